// SPDX-License-Identifier: MIT

#include "internode/io/obj/free_form_input.h"

#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

std::vector<InputNumber> exact_numbers(const std::vector<Rational>& knots) {
    std::vector<InputNumber> numbers;
    numbers.reserve(knots.size());
    for (const Rational& knot : knots) numbers.push_back({knot});
    return numbers;
}

InputPolygon side(const FreeFormFile& file, const FreeFormDirection& direction) {
    InputPolygon polygon;
    polygon.source = file.source;
    polygon.degree = direction.degree;
    polygon.closed = false;
    polygon.knots = exact_numbers(direction.knots);
    return polygon;
}

} // namespace

InputPolygon free_form_polygon(const FreeFormFile& file, const FreeForm& curve) {
    if (curve.v) throw std::invalid_argument("a surface is no polygon");
    InputPolygon polygon = side(file, curve.u);
    polygon.dimension = free_form_row - 1;
    for (const std::uint32_t vertex : curve.vertices) {
        assert((vertex + std::size_t{1}) * free_form_row <= file.vertices.size());
        const auto first = file.vertices.begin() + static_cast<std::ptrdiff_t>(vertex * free_form_row);
        polygon.points.insert(polygon.points.end(), first, first + free_form_row - 1);
        if (curve.rational) polygon.weights.push_back(first[free_form_row - 1]);
    }
    return polygon;
}

InputGrid free_form_grid(const FreeFormFile& file, const FreeForm& surface) {
    if (!surface.v) throw std::invalid_argument("a curve is no grid");
    assert(surface.vertices.size() == surface.u.points * surface.v->points);
    InputGrid grid;
    grid.source = file.source;
    grid.rows = surface.u.points;
    grid.columns = surface.v->points;
    grid.dimension = surface.rational ? free_form_row : free_form_row - 1;
    grid.rational = surface.rational;
    grid.sides = {side(file, surface.u), side(file, *surface.v)};
    grid.points.reserve(surface.vertices.size() * grid.dimension);
    for (std::size_t i = 0; i < grid.rows; ++i)
        for (std::size_t j = 0; j < grid.columns; ++j) {
            const double* const vertex = file.vertices.data() + free_form_row * surface.vertices[i + j * grid.rows];
            const double weight = surface.rational ? vertex[free_form_row - 1] : 1;
            for (std::size_t c = 0; c + 1 < free_form_row; ++c) grid.points.push_back(weight * vertex[c]);
            if (surface.rational) grid.points.push_back(weight);
        }
    return grid;
}

} // namespace internode
