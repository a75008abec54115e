// SPDX-License-Identifier: MIT
//
// The value of an expression whose formals are known numbers, and what it costs to find.

#pragma once

#include "internode/expression/definition_scope.h"

#include <cstdint>
#include <span>
#include <vector>

namespace internode {

/// The value of an expression without formals, or of a function with all its arguments known. Calls are written out.
/// Precondition: the types of the expression and its cost are checked.
[[nodiscard]] KnownNumber evaluate_known(const Expression& expression, std::span<const KnownNumber> arguments,
                                         const DefinitionScope& scope);

/// The operations of an expression with its calls written out, saturating above max_expression_operations.
/// `definition_costs`: of the definitions that it may use.
[[nodiscard]] std::uint64_t operations(const Expression& expression, std::span<const std::uint64_t> definition_costs);

/// The cost of each definition.
[[nodiscard]] std::vector<std::uint64_t> definition_costs(std::span<const Definition> definitions);

} // namespace internode
