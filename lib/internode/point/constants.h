// SPDX-License-Identifier: MIT
//
// The values of a grammar's constants, and what its functions cost.

#pragma once

#include "internode/expression/known_number.h"
#include "internode/point/limits.h"
#include "internode/point/point_system.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace internode {

/// The operations of an expression with its calls written out, saturating above max_expression_operations.
/// `definition_costs`: of the definitions that it may use.
[[nodiscard]] std::uint64_t operations(const Expression& expression, std::span<const std::uint64_t> definition_costs);

/// The cost of each definition.
[[nodiscard]] std::vector<std::uint64_t> definition_costs(const PointGrammar& grammar);

/// The value of an expression without formals, or of a function with all its arguments known. `constants`: of the
/// definitions that it may use. Precondition: its types and its cost are checked.
[[nodiscard]] KnownNumber evaluate_known(const Expression& expression, std::vector<KnownNumber> arguments,
                                         const PointGrammar& grammar, std::span<const KnownNumber> constants);

/// One per definition, meaningful for constants. What is wrong with a definition or with a setting is a problem; a
/// definition in error has the value 0.
[[nodiscard]] std::vector<KnownNumber> constant_values(const PointGrammar& grammar,
                                                       const std::map<std::string, Rational>& settings,
                                                       std::vector<PointProblem>& problems);

} // namespace internode
