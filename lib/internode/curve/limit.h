// SPDX-License-Identifier: MIT
//
// Points of the limit curve itself, by exact rows: at the knots, and as Bézier segments.

#pragma once

#include "internode/curve/refinement.h"

#include <vector>

namespace internode {

struct LimitPoints {
    std::vector<double> parameters; ///< the distinct knots of the domain, ascending, the first one 0
    std::vector<double> points;     ///< one row of dimension() coordinates each; of a closed curve the first point is
                                    ///< not repeated (parameters then has one entry fewer than there are knots)
    std::vector<bool> break_before; ///< the curve is discontinuous here (a run of d zeros): the point is the limit
                                    ///< from the right, and the row before it holds the limit from the left. Where a
                                    ///< closed curve breaks at its seam, that row is the last one, at the period
};

/// The curve at the distinct knots of its domain. Where it breaks, the knot appears twice: left limit, right limit.
[[nodiscard]] LimitPoints limit_points(const Refinement& refinement);

struct BezierSegments {
    std::vector<Symbol> symbols; ///< of each non-empty interval of the domain, left to right
    std::vector<double> points;  ///< d + 1 rows of dimension() coordinates per segment
};

/// The curve over each non-empty interval of its domain as a Bézier curve of degree d.
[[nodiscard]] BezierSegments bezier_segments(const Refinement& refinement);

} // namespace internode
