// SPDX-License-Identifier: MIT

#include "internode/grammar/points/point_grammar.h"

#include <cassert>

#include <fmt/format.h>

namespace internode {

std::optional<Symbol> find_letter(const PointGrammar& grammar, std::string_view text, std::size_t parameters) {
    const std::optional<Symbol> plain = grammar.letters.find(text);
    assert(!plain || to_index(*plain) < grammar.arity.size());
    if (!plain || grammar.arity[to_index(*plain)] == parameters) return plain;
    return grammar.letters.find(fmt::format("{}/{}", text, parameters));
}

} // namespace internode
