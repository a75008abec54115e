// SPDX-License-Identifier: MIT
//
// A function over its parameter is itself a curve in the plane: Greville abscissae are the control points of x = t.

#include "internode/report/picture/planar_curve.h"

#include "internode/curve/parameter.h"

#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

/// Two coordinates of each row, divided by the last where it is a weight.
std::vector<Point2> drawn(const std::vector<double>& points, std::size_t dimension, PictureAxes axes,
                          Coordinates coordinates) {
    assert(dimension > 0 && points.size() % dimension == 0);
    if (coordinates == Coordinates::Homogeneous)
        return drawn(projected(points, dimension), dimension, axes, Coordinates::Cartesian);
    std::vector<Point2> projection;
    projection.reserve(points.size() / dimension);
    for (std::size_t row = 0; row < points.size(); row += dimension)
        projection.push_back({.x = points[row + axes.right], .y = points[row + axes.up]});
    return projection;
}

/// The polygon of a curve of dimension 1 over its Greville abscissae; a closed one over a whole period.
std::vector<Point2> graph_polygon(const Curve& curve) {
    assert(curve.dimension() == 1);
    const std::vector<double> abscissae = greville_abscissae(curve);
    std::vector<Point2> polygon;
    for (std::size_t k = 0; k < curve.size(); ++k) polygon.push_back({.x = abscissae[k], .y = curve.points()[k]});
    if (curve.ends() == Ends::Circular) {
        const std::vector<double> knots = knot_positions(curve);
        polygon.push_back({.x = abscissae[0] + (knots.back() - knots.front()), .y = curve.points()[0]});
    }
    return polygon;
}

/// The Bézier points of dimension 1 over equal parts of their intervals.
std::vector<Point2> graph_segments(const Curve& curve, const std::vector<double>& points) {
    const std::vector<double> knots = knot_positions(curve);
    const WordView domain = curve.domain();
    const auto degree = static_cast<std::size_t>(curve.degree());
    const std::size_t first = curve.ends() == Ends::Open ? degree : 0;
    std::vector<Point2> segments;
    segments.reserve(points.size());
    for (std::size_t k = 0; k < domain.size(); ++k) {
        if (domain[k] == zero_interval) continue;
        const double start = knots[first + k];
        const double length = knots[first + k + 1] - start;
        for (std::size_t b = 0; b <= degree; ++b)
            segments.push_back({.x = start + length * (static_cast<double>(b) / static_cast<double>(degree)),
                                .y = points[segments.size()]});
    }
    assert(segments.size() == points.size());
    return segments;
}

} // namespace

PlanarCurve planar_curve(const Curve& coarse, const Refinement& refinement, PictureAxes axes, Coordinates coordinates) {
    const Curve& fine = refinement.curve();
    const std::size_t dimension = fine.dimension();
    const bool is_rational = coordinates == Coordinates::Homogeneous;
    const std::size_t space = dimension - (is_rational ? 1 : 0);
    PlanarCurve planar;
    planar.degree = fine.degree();
    planar.is_graph = dimension == 1;
    planar.closed = fine.ends() == Ends::Circular && !planar.is_graph;
    planar.names = fine.system().alphabet().names();
    BezierSegments limit = bezier_segments(refinement);
    planar.symbols = std::move(limit.symbols);
    if (planar.is_graph) {
        planar.control = graph_polygon(coarse);
        if (fine.step() > coarse.step()) planar.refined = graph_polygon(fine);
        planar.segments = graph_segments(fine, limit.points);
        return planar;
    }
    if (axes.right >= space || axes.up >= space)
        throw std::invalid_argument("the points have " + std::to_string(space) + " coordinates: axes " +
                                    std::to_string(axes.right + 1) + "," + std::to_string(axes.up + 1) +
                                    " are not all among them");
    planar.control = drawn(coarse.points(), dimension, axes, coordinates);
    if (fine.step() > coarse.step()) planar.refined = drawn(fine.points(), dimension, axes, coordinates);
    planar.segments = drawn(limit.points, dimension, axes, coordinates);
    if (is_rational)
        for (std::size_t row = space; row < limit.points.size(); row += dimension)
            planar.weights.push_back(limit.points[row]);
    return planar;
}

} // namespace internode
