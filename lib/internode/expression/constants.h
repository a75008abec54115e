// SPDX-License-Identifier: MIT
//
// The values of the constants of a text, its own or set from outside.

#pragma once

#include "internode/expression/definition_scope.h"
#include "internode/expression/problem.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace internode {

/// One per definition, meaningful for constants. What is wrong with a definition or with a setting is a problem; a
/// definition in error has the value 0. Cost: at most max_constant_operations (expression/limits.h).
[[nodiscard]] std::vector<KnownNumber> constant_values(std::span<const Definition> definitions,
                                                       const std::map<std::string, Rational>& settings,
                                                       std::vector<ExpressionProblem>& problems);

} // namespace internode
