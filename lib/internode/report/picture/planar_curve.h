// SPDX-License-Identifier: MIT
//
// A refined curve as plane geometry, ready to be drawn: the control polygon it came from, the refined polygon, and the
// limit curve as one Bézier segment per knot interval, with the symbol of each.
//
// Two coordinates of the points are taken, divided by the weight where points have one. A curve of dimension 1 is drawn
// over its parameter: control points over their Greville abscissae, Bézier points over equal parts of their interval,
// which is exact.

#pragma once

#include "internode/curve/homogeneous.h"
#include "internode/curve/limit.h"
#include "internode/report/picture/svg.h"

#include <cstddef>
#include <string>
#include <vector>

namespace internode {

/// Coordinates, from 0, that are drawn to the right and upwards.
struct PictureAxes {
    std::size_t right = 0;
    std::size_t up = 1;
};

struct PlanarCurve {
    int degree = 1;
    bool closed = false;            ///< the polygons close: their last point is joined to the first
    bool is_graph = false;          ///< a function over the parameter: the axes have different units
    std::vector<Point2> control;    ///< the coarse polygon
    std::vector<Point2> refined;    ///< the refined polygon; empty when no step was taken
    std::vector<Symbol> symbols;    ///< the symbol of each segment, left to right
    std::vector<Point2> segments;   ///< degree + 1 Bézier points per segment
    std::vector<double> weights;    ///< weights of these points; empty when the curve is polynomial
    std::vector<std::string> names; ///< names of the symbols of the alphabet
};

/// `refinement` is of the same curve as `coarse`, at the same step or later. \throw std::invalid_argument for an axis
/// that the points do not have, and for weights without two coordinates beside them
[[nodiscard]] PlanarCurve planar_curve(const Curve& coarse, const Refinement& refinement, PictureAxes axes,
                                       Coordinates coordinates = Coordinates::Cartesian);

} // namespace internode
