// SPDX-License-Identifier: MIT
//
// Parameters of modules without rounding: exact numbers, and points as exact combinations Σ w_j p_j of points p_j that
// are given from outside (the points of a polygon, the points of a window).
//
// What cannot be said so has a reason: a coordinate or a literal point mixes coordinates, a square root is not
// rational.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/expression/definition_scope.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace internode {

/// Σ weight p_index: by ascending index, none twice, no weight zero.
struct PointSum {
    std::vector<std::pair<std::ptrdiff_t, Rational>> terms;
    friend bool operator==(const PointSum&, const PointSum&) = default;
};

using ExactValue = std::variant<Rational, PointSum>;

/// A value, a truth as the number 1 or 0, or the reason why there is none.
struct ExactResult {
    std::optional<ExactValue> value;
    std::string reason; ///< "mixes coordinates", … ; empty when there is a value
};

/// The value of an expression of a rule, an axiom or an input; `formals` in the order of the rule's.
/// Limits: expression/limits.h, which are reasons too. Precondition: the types of the expression are checked.
[[nodiscard]] ExactResult exact_value(const Expression& expression, std::span<const ExactValue> formals,
                                      const DefinitionScope& scope);

} // namespace internode
