// SPDX-License-Identifier: MIT
//
// From the tokens of an expression to its program, by two stacks (Dijkstra's shunting yard): no recursion.
//
//     or < and < not < comparison < + - < * / juxtaposition < unary - < .x
//
// All binary operations group from the left; comparisons do not chain. `3/4` between digits is one number, but for the
// right side of a division: `a/3/4` is (a/3)/4. Juxtaposition multiplies; what stands on its right is a name or a
// parenthesis, and a quotient on its left must be a number: of `a/b c` nobody knows what is meant.

#pragma once

#include "internode/grammar/expressions/expression_builder.h"
#include "internode/grammar/expressions/name_scope.h"
#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/token.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace internode {

enum class Wanted {
    Value,  ///< a number or a point
    Number, ///< not a point for certain
    Truth,
};

struct ExpressionContext {
    std::string_view text;
    NameScope& scope;
    PointBudget& budget;
    Complaints& complaints;
    std::size_t& searches; ///< searches for names that could be meant, so far
    std::size_t levels;    ///< levels of nesting that the normal form adds
};

/// Reads all of the tokens, at least one; none after a complaint. Cost: linear in the tokens.
[[nodiscard]] std::optional<Expression> read_expression(std::span<const Token> tokens, Wanted wanted,
                                                        ExpressionContext& context);

} // namespace internode
