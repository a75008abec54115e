// SPDX-License-Identifier: MIT
//
// From point grammar to text: the normal form. parse_point_grammar(print(g)) == g for every grammar that was read.

#pragma once

#include "internode/grammar/points/point_grammar.h"

#include <span>
#include <string>

namespace internode {

/// One statement a line, ASCII only, ends with a newline.
[[nodiscard]] std::string print(const PointGrammar& grammar);

/// One rule, as it stands in the normal form, without a newline.
[[nodiscard]] std::string print(const PointRule& rule, const PointGrammar& grammar);

/// An expression with as few parentheses as its meaning needs; `formals` are those of its rule or definition.
[[nodiscard]] std::string print(const Expression& expression, std::span<const std::string> formals,
                                const PointGrammar& grammar);

} // namespace internode
