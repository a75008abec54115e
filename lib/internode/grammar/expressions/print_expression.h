// SPDX-License-Identifier: MIT
//
// From expression to text, with as few parentheses as its meaning needs.

#pragma once

#include "internode/expression/definition.h"
#include "internode/expression/expression.h"

#include <span>
#include <string>

namespace internode {

/// `formals` are those of the rule or definition in which the expression stands; `definitions` those of its grammar.
[[nodiscard]] std::string print(const Expression& expression, std::span<const std::string> formals,
                                std::span<const Definition> definitions);

} // namespace internode
