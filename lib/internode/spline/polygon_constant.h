// SPDX-License-Identifier: MIT
//
// The constant of the distance between control polygon and curve.
//
// With Greville abscissae ξ_k = (t_{k+1} + … + t_{k+d}) / d and c_k = (1 / (2 d² (d-1))) Σ_{i<j} (t_{k+i} - t_{k+j})²,
// s(ξ_k) - v_k = c_k s'' exactly for parabolas. So ρ^{2s} error_s tends to sup C*(x) |s''(x)| (docs/mathematics.md;
// sharpens Cohen and Schumaker 1985, Theorem 3.3). C* = max of c over the persistent words of d-1 inner intervals; it
// scales with the square of the lengths. For d = 1 the polygon is the curve and C* = 0.

#pragma once

#include "internode/interval/interval_system.h"

#include <cstddef>

namespace internode {

/// Persistent words of d - 1 intervals among which the largest constant is looked for: n^(d-1) at worst, so that 3
/// symbols at degree 12 still fit.
inline constexpr std::size_t max_inner_words = 1'000'000;

/// c of the d - 1 inner intervals of a basis function of degree d = word.size() + 1.
[[nodiscard]] Number polygon_constant(const IntervalSystem& system, WordView inner);

struct PolygonConstant {
    Number value; ///< C*(d), exact
    Word word;    ///< d - 1 letters where it is attained; empty for d = 1
};

/// The largest constant over the persistent words of the system, whatever word a curve starts from.
/// \throw TooManyWords, std::invalid_argument for a degree below 1
[[nodiscard]] PolygonConstant largest_polygon_constant(const IntervalSystem& system, int degree);

} // namespace internode
