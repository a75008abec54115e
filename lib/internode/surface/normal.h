// SPDX-License-Identifier: MIT
//
// The normal of a surface from homogeneous position and derivatives at one point.

#pragma once

#include "internode/algebra/double_double.h"

#include <array>
#include <span>

namespace internode {

using Vector3 = std::array<double, 3>;

/// Combinations of control points of one dimension, 3 or with weight 4: the position, the first derivatives along u and
/// v and the mixed one. The derivatives may be in other units of u and v, the mixed one in the product of both.
struct LocalSurface {
    std::span<const DoubleDouble> position;
    std::span<const DoubleDouble> along_u;
    std::span<const DoubleDouble> along_v;
    std::span<const DoubleDouble> mixed;
    double noise_u;     ///< a coordinate of along_u not above this says nothing
    double noise_v;     ///< a coordinate of along_v not above this says nothing
    double noise_mixed; ///< a coordinate of mixed not above this says nothing
    bool u_from_left;   ///< the surface continues to smaller u
    bool v_from_left;   ///< the surface continues to smaller v
};

/// Of length 1, or 0 0 0.
[[nodiscard]] Vector3 unit_normal(const LocalSurface& surface);

} // namespace internode
