// SPDX-License-Identifier: MIT
//
// The normal of a surface from homogeneous position and derivatives at one point.

#pragma once

#include <array>
#include <span>

namespace internode {

using Vector3 = std::array<double, 3>;

/// Combinations of control points of one dimension, 3 or with weight 4: the position, the first derivatives along u and
/// v and the mixed one, each derivative up to a positive factor.
struct LocalSurface {
    std::span<const double> position;
    std::span<const double> along_u;
    std::span<const double> along_v;
    std::span<const double> mixed;
    double noise;     ///< below this a coordinate is rounding error
    bool u_from_left; ///< the surface continues to smaller u
    bool v_from_left; ///< and to smaller v
};

/// Of length 1, or 0 0 0.
[[nodiscard]] Vector3 unit_normal(const LocalSurface& surface);

} // namespace internode
