// SPDX-License-Identifier: MIT
//
// The first two derivatives of a curve at any place of its domain, from differences of its own points.
//
//     c' = Σ N_k^{d-1} v'_k,   v'_k = d (v_k - v_{k-1}) / (t_{k+d} - t_k),   and c'' from v'_k in the same way
//
// Differences of refined points would lose ulp(|v|) / h^m, 4 times more for m = 2 with every halving. Those of the
// given points lose nothing at any depth: everything here is in pairs of doubles and rounded once.

#pragma once

#include "internode/curve/curve.h"
#include "internode/curve/knot_walk.h"
#include "internode/curve/long_spline.h"

#include <cstddef>
#include <vector>

namespace internode {

class Derivatives {
public:
    /// The curve outlives it.
    explicit Derivatives(const Curve& curve);

    [[nodiscard]] const Spans& spans() const { return spans_; }
    /// Appends dimension() coordinates to each, by the parameter of the curve. Quick for places of one letter after the
    /// other. Infinite beyond the range of doubles.
    void append(const KnotPlace& place, std::vector<double>& first, std::vector<double>& second);

private:
    /// One derivative over the interval of `letter_`.
    struct Piece {
        LongRows points;
        LocalBasis basis;
        int exponent; ///< the derivative is its value here times 2^exponent
    };

    void enter(std::size_t letter);
    [[nodiscard]] LongRows points_over(std::size_t letter) const;
    void append(Piece& piece, DoubleDouble offset, std::vector<double>& values);

    const Curve& curve_;
    Spans spans_;
    int exponent_; ///< points are taken times 2^-exponent_
    std::size_t letter_;
    std::vector<Piece> pieces_; ///< the first derivative, then the second unless the degree is 1
    std::vector<DoubleDouble> value_;
};

/// An exponent that keeps products of these coordinates with lengths of Spans in the range of pairs of doubles: 0 for
/// all but huge and tiny ones.
[[nodiscard]] int safe_exponent(const std::vector<double>& coordinates);

} // namespace internode
