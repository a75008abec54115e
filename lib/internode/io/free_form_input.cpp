// SPDX-License-Identifier: MIT

#include "internode/io/free_form_input.h"

#include <stdexcept>

namespace internode {

namespace {

constexpr std::size_t row = 4; // x, y, z, w

} // namespace

InputPolygon free_form_polygon(const FreeFormFile& file, const FreeForm& curve) {
    if (curve.v) throw std::invalid_argument("a surface is no polygon");
    InputPolygon polygon;
    polygon.source = file.source;
    polygon.dimension = row - 1;
    polygon.degree = curve.u.degree;
    polygon.closed = false;
    polygon.knots.emplace();
    for (const Rational& knot : curve.u.knots) polygon.knots->push_back({knot});
    for (const std::uint32_t vertex : curve.vertices) {
        const auto first = file.vertices.begin() + static_cast<std::ptrdiff_t>(vertex * row);
        polygon.points.insert(polygon.points.end(), first, first + row - 1);
        if (curve.rational) polygon.weights.push_back(first[row - 1]);
    }
    return polygon;
}

} // namespace internode
