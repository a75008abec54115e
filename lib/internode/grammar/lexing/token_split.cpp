// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/token_split.h"

#include <cassert>

namespace internode {

std::vector<std::size_t> find_outside(std::span<const Token> tokens, std::string_view text, char mark) {
    std::vector<std::size_t> found;
    std::size_t depth = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (is_mark(tokens[i], text, '(') || is_mark(tokens[i], text, '[')) ++depth;
        if (is_mark(tokens[i], text, ')') || is_mark(tokens[i], text, ']')) --depth;
        if (depth == 0 && is_mark(tokens[i], text, mark)) found.push_back(i);
    }
    return found;
}

std::vector<std::span<const Token>> split_at(std::span<const Token> tokens, const std::vector<std::size_t>& indices) {
    std::vector<std::span<const Token>> parts;
    std::size_t first = 0;
    for (const std::size_t index : indices) {
        assert(index >= first && index < tokens.size());
        parts.push_back(tokens.subspan(first, index - first));
        first = index + 1;
    }
    parts.push_back(tokens.subspan(first));
    return parts;
}

} // namespace internode
