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

/// What the coordinates of a point are.
enum class Coordinates { Cartesian, Homogeneous };

/// A margin that keeps products and quotients of moderate coordinates finite.
inline constexpr double smallest_weight = 1e-100;
inline constexpr double largest_weight = 1e100;

/// The first weight outside the two bounds (NaN included), or none.
[[nodiscard]] std::optional<std::size_t> first_bad_weight(std::span<const double> weights);

/// Rows (w x_1, …, w x_n, w) from rows x_1 … x_n. \throw std::invalid_argument for sizes that do not match and bad
/// weights
[[nodiscard]] std::vector<double> homogeneous(std::span<const double> points, std::size_t dimension,
                                              std::span<const double> weights);

/// Rows (x_1, …, x_n, w) from rows (w x_1, …, w x_n, w), `width` = n + 1 numbers each. \throw std::invalid_argument for
/// width < 2, rows that are not whole, and a w that is not positive
[[nodiscard]] std::vector<double> projected(std::span<const double> rows, std::size_t width);

/// The same without w: n coordinates a point.
[[nodiscard]] std::vector<double> projected_points(std::span<const double> rows, std::size_t width);

} // namespace internode
