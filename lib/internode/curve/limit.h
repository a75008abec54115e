// SPDX-License-Identifier: MIT
//
// The limit curve itself: points at the knots and Bézier segments by exact rows, and derivatives.
//
// A point is a combination of d+1 control points; its row depends on the window of the interval that starts (or ends)
// at the knot and on nothing else. Rows are exact in K and rounded once. Derivatives are those of the given curve, by
// its own parameter, at the knots of the refined one (curve/derivatives.h): their error does not grow with the steps.

#pragma once

#include "internode/curve/refinement.h"

#include <vector>

namespace internode {

struct LimitPoints {
    std::vector<double> parameters; ///< the distinct knots of the domain, ascending, the first one Knots::origin()
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
    std::vector<double> tangents;   ///< tangents of length 1; NaN where the first derivative is 0
    std::vector<double> curvatures; ///< one each, signed in the plane (curve/frame.h); NaN where `first` is 0
};

/// Points, derivatives, tangents and curvatures at the distinct knots of the refined domain, in one sweep. `refinement`
/// is of `given`, after any steps: assert. Beyond the range of doubles (intervals near smallest_length) a derivative is
/// infinite or NaN.
[[nodiscard]] LimitFrames limit_frames(const Curve& given, const Refinement& refinement);

/// The same of refinement.curve() as the given curve: for a refinement that has taken no step. After steps its points
/// have been rounded, and their differences with them.
[[nodiscard]] LimitFrames limit_frames(const Refinement& refinement);

struct BezierSegments {
    std::vector<Symbol> symbols; ///< the symbol of each non-empty interval of the domain, left to right
    std::vector<double> points;  ///< d + 1 rows of dimension() coordinates per segment
};

/// The curve over each non-empty interval of its domain as a Bézier curve of degree d.
[[nodiscard]] BezierSegments bezier_segments(const Refinement& refinement);

} // namespace internode
