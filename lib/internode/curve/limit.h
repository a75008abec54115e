// SPDX-License-Identifier: MIT
//
// The limit curve itself, by exact rows: points and derivatives at the knots, and Bézier segments.
//
// Each value is a combination of d+1 control points; its row depends on the window of the interval that starts (or
// ends) at the knot and on nothing else. Rows are exact in K and rounded once. Derivatives are by the parameter of
// step 0, in which A_i has the length a_i, at every step: a row of order m at step s is ρ^(s m) times that of step 0.

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

/// Rows of dimension() coordinates, and single numbers, in the order of `limit`.
struct LimitFrames {
    LimitPoints limit;
    std::vector<double> first;      ///< derivatives; at a knot from the right, at the end and before a break from the
                                    ///< left: the two sides agree up to order d - (multiplicity of the knot)
    std::vector<double> second;     ///< 0 for degree 1
    std::vector<double> tangents;   ///< of length 1; NaN where the first derivative is 0
    std::vector<double> curvatures; ///< one each, signed in the plane (curve/frame.h); NaN where `first` is 0
};

/// Points, derivatives, tangents and curvatures at the distinct knots of the domain, in one sweep. Beyond the range of
/// doubles (intervals near smallest_length) a derivative is infinite or NaN.
[[nodiscard]] LimitFrames limit_frames(const Refinement& refinement);

struct BezierSegments {
    std::vector<Symbol> symbols; ///< of each non-empty interval of the domain, left to right
    std::vector<double> points;  ///< d + 1 rows of dimension() coordinates per segment
};

/// The curve over each non-empty interval of its domain as a Bézier curve of degree d.
[[nodiscard]] BezierSegments bezier_segments(const Refinement& refinement);

} // namespace internode
