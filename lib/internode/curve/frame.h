// SPDX-License-Identifier: MIT
//
// Tangent and curvature from the first two derivatives of a curve, in any dimension, whatever its parameter.
//
//     κ = √(|c'|² |c''|² − (c'·c'')²) / |c'|³ = √(Σ_{i<j} (c'_i c''_j − c'_j c''_i)²) / |c'|³
//
// by Lagrange's identity: the sum of squares on the right does not cancel where c' and c'' are nearly parallel. In the
// plane it is one square, and its root keeps the sign: positive where the curve turns from x towards y, to the left.

#pragma once

#include <span>

namespace internode {

/// unit = first / |first|; every coordinate NaN where `first` is 0: the curve stops there and has no tangent from this
/// derivative. Sizes equal: assert.
void unit_tangent(std::span<const double> first, std::span<double> unit);

/// κ, signed in two dimensions, >= 0 beyond, 0 in one, never −0; NaN where `first` is 0, ±infinity where it exceeds
/// every double. No intermediate overflows. O(n²) in the dimension. Sizes equal: assert.
[[nodiscard]] double curvature(std::span<const double> first, std::span<const double> second);

} // namespace internode
