// SPDX-License-Identifier: MIT
//
// The deviation functions β_i of a curve from its polygon, over one knot interval.
//
// β_i(x) = Σ_k (ξ_k - ξ_i)_+ N_k(x) - (x - ξ_i)_+ >= 0 is the deviation that a slope jump of 1 at ξ_i alone makes. Over
// interval j only i = j-d+1 … j-1 are not zero, and they depend only on the 2d-1 lengths around j. Between knots and
// Greville abscissae each is a polynomial of degree d.

#pragma once

#include <span>
#include <vector>

namespace internode {

struct DeviationPiece {
    double begin = 0; ///< where it begins, in the parameter that is 0 where the interval starts
    double end = 0;   ///< > begin
    std::vector<double>
        coefficients; ///< d + 1 rows, one per Bernstein polynomial on [begin, end], of d - 1 numbers β_i
};

/// The pieces of the middle interval, left to right. `lengths`: 2d - 1 >= 3 of them, the middle one > 0, others >= 0.
[[nodiscard]] std::vector<DeviationPiece> deviation_pieces(std::span<const double> lengths);

} // namespace internode
