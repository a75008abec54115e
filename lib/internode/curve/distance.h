// SPDX-License-Identifier: MIT
//
// The distance between a curve and its control polygon, with its certificate.
//
// ℓ is the polygon over the Greville abscissae ξ_k, s the curve, D_i the slope jump of ℓ at ξ_i and
// β_i(x) = Σ_k (ξ_k - ξ_i)_+ N_k(x) - (x - ξ_i)_+ >= 0. Then s - ℓ = Σ D_i β_i, so ‖s - ℓ‖ <= Σ ‖D_i‖ β_i, the
// *envelope*: itself the distance of the scalar curve whose polygon has the slope jumps ‖D_i‖. Both are taken over
// [max(ξ_first, domain start), min(ξ_last, domain end)], the whole period of a closed curve, and apart on both sides of
// a break, where two ξ are equal. On each piece between knots and abscissae s - ℓ is a polynomial: its Bernstein
// coefficients bound it.

#pragma once

#include "internode/curve/curve.h"

namespace internode {

struct PolygonDistance {
    double error = 0;       ///< sup ‖s(x) - ℓ(x)‖ as measured: attained at some x, up to rounding
    double error_bound = 0; ///< >= the supremum; within a relative 1e-6 of `error`
    double envelope = 0;    ///< sup of Σ ‖D_i‖ β_i: guaranteed, >= error
};

/// Cost: linear in the points. Exactly 0 for degree 1.
[[nodiscard]] PolygonDistance polygon_distance(const Curve& curve);

} // namespace internode
