// SPDX-License-Identifier: MIT
//
// Rational curves: a point x with weight w is the row (w x_1, …, w x_n, w), and the curve is x = Σ w_k x_k N_k / Σ w_k
// N_k. Refinement and limits act on the rows, and points are divided by their weight last.
//
// Weights are positive, so that every refined weight, a convex combination, is positive too.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace internode {

/// A margin that keeps products and quotients of moderate coordinates finite.
inline constexpr double smallest_weight = 1e-100;
inline constexpr double largest_weight = 1e100;

/// The first weight outside the two bounds (NaN included), or none.
[[nodiscard]] std::optional<std::size_t> first_bad_weight(std::span<const double> weights);

/// Rows (w x_1, …, w x_n, w) from rows x_1 … x_n. \throw std::invalid_argument for sizes that do not match and bad
/// weights
[[nodiscard]] std::vector<double> homogeneous(std::span<const double> points, std::size_t dimension,
                                              std::span<const double> weights);

/// Points and weights again, n coordinates a point.
struct WeightedPoints {
    std::vector<double> points;
    std::vector<double> weights;
};

/// Divides rows of n + 1 numbers by their last, which must be positive. \throw std::invalid_argument otherwise, and for
/// n = 0 and rows that are not whole
[[nodiscard]] WeightedPoints projected(std::span<const double> rows, std::size_t dimension);

} // namespace internode
