// SPDX-License-Identifier: MIT
//
// The second step of reading: from tokens to statements. A statement ends at a newline, `,` or `;` outside
// parentheses; a newline inside them or after `->`, `:`, `<`, `>`, `+`, `-`, `*`, `/` continues it.
//
// In a point grammar `[ ]` are brackets too, and `|` continues a statement.
//
// A bracket without its partner is made TokenKind::Unbalanced and does not swallow what follows: no partner is looked
// for beyond an arrow, because no word contains one.

#pragma once

#include "internode/grammar/lexing/token.h"

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

enum class Brackets {
    Round,          ///< `( )`: words of intervals
    RoundAndSquare, ///< `[ ]` as well: branches of point grammars
};

/// Cost: linear in the tokens.
[[nodiscard]] Statements split_statements(std::vector<Token> tokens, std::string_view text,
                                          Brackets brackets = Brackets::Round);

/// Makes each bracket without its partner TokenKind::Unbalanced. Of `( [ )` the square one has none.
void mark_unbalanced(std::vector<Token>& tokens, std::string_view text, Brackets brackets = Brackets::Round);

} // namespace internode
