// SPDX-License-Identifier: MIT
//
// Knots from words, and the blossom of one polynomial piece of a B-spline (Ramshaw 1989; Goldman 1990).
//
// Over the non-empty interval j = [τ_j, τ_{j+1}) a spline of degree d is a polynomial with control points
// v_{j-d} … v_j and the 2d knots τ_{j-d+1} … τ_{j+d}. Its blossom p(x_1, …, x_d) is a combination of the d+1 control
// points with weights that sum to 1. A new control point after knot insertion is the blossom at d consecutive new
// knots; the curve at x is the blossom at (x, …, x). All exact in K.

#pragma once

#include "internode/interval/interval_system.h"

#include <span>
#include <vector>

namespace internode {

/// The word.size() + 1 knots of a word, the first one 0. \throw std::invalid_argument for a symbol without a length
[[nodiscard]] std::vector<Number> knots(const IntervalSystem& system, WordView word);

/// The piece over one interval, ready for many blossoms: its d (d+1) / 2 divisions are done once.
class PolynomialPiece {
public:
    /// `local_knots`: τ_{j-d+1} … τ_{j+d} (2d of them, d >= 1, ascending, τ_j < τ_{j+1} in the middle).
    /// \throw std::invalid_argument for another size, an empty interval j, or knots that do not ascend
    explicit PolynomialPiece(std::vector<Number> local_knots);

    [[nodiscard]] std::size_t degree() const { return knots_.size() / 2; }
    /// d + 1 weights of v_{j-d} … v_j in the blossom at d arguments, in any order. O(d²) operations in K.
    /// \throw std::invalid_argument for another number of arguments
    [[nodiscard]] std::vector<Number> weights(std::span<const Number> arguments) const;

private:
    std::vector<Number> knots_;       ///< 2d
    std::vector<Number> reciprocals_; ///< 1 / knot difference, by level and position
};

/// d + 1 weights of v_{j-d} … v_j, for a single blossom. Exceptions of PolynomialPiece.
[[nodiscard]] std::vector<Number> blossom_weights(std::span<const Number> local_knots,
                                                  std::span<const Number> arguments);

} // namespace internode
