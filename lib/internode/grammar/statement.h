// SPDX-License-Identifier: MIT
//
// The second step of reading: from tokens to statements. A statement ends at a newline, `,` or `;` outside
// parentheses; a newline inside them or after `->`, `:`, `<`, `>`, `+`, `-`, `*`, `/` continues it.
//
// A parenthesis without its partner is made TokenKind::Unbalanced and does not swallow what follows: no partner is
// looked for beyond an arrow, because no word contains one.

#pragma once

#include "internode/grammar/token.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace internode {

struct Statement {
    std::span<const Token> tokens;    ///< at least one; no newlines
    std::optional<std::size_t> arrow; ///< index of the first arrow
};

struct Statements {
    std::vector<Token> tokens; ///< what the statements point into
    std::vector<Statement> statements;
};

/// Cost: linear in the tokens.
[[nodiscard]] Statements split_statements(std::vector<Token> tokens, std::string_view text);

/// Makes each parenthesis without its partner TokenKind::Unbalanced.
void mark_unbalanced(std::vector<Token>& tokens, std::string_view text);

} // namespace internode
