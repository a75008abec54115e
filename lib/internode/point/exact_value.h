// SPDX-License-Identifier: MIT
//
// Parameters of modules without rounding: exact numbers, and points as exact combinations Σ w_j p_j of points p_j that
// are given from outside (the points of a polygon, the points of a window).
//
// What cannot be said so has a reason: a coordinate or a literal point mixes coordinates, a square root is not
// rational.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/point/point_system.h"

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

/// A value, a truth, or the reason why there is none.
struct ExactResult {
    std::optional<std::variant<Rational, PointSum, bool>> value;
    std::string reason; ///< "mixes coordinates", … ; empty when there is a value
};

/// Bits of a numerator or denominator; longer numbers are a reason. Instructions of one evaluation, with those of the
/// definitions that are called.
inline constexpr std::size_t max_exact_bits = 4096;
inline constexpr std::size_t max_exact_instructions = 1'000'000;

/// The value of an expression of a rule, an axiom or an input; `formals` in the order of the rule's.
[[nodiscard]] ExactResult exact_value(const Expression& expression, std::span<const ExactValue> formals,
                                      const PointSystem& system);

} // namespace internode
