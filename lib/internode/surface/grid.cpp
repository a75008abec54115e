// SPDX-License-Identifier: MIT

#include "internode/surface/grid.h"

#include "internode/curve/homogeneous.h"

#include <cassert>
#include <cmath>
#include <fmt/format.h>

namespace internode {

namespace {

constexpr std::size_t listed = 5; // problems of a kind: enough to see a pattern

/// Whether the coordinates are a point for each pair of knots.
std::vector<std::string> size_problems(const GridData& data) {
    if (data.dimension == 0) return {"a point needs at least one coordinate"};
    if (data.rational && data.dimension == 1)
        return {"a rational surface needs points with at least one coordinate and the weight, not 1 in all"};
    const std::size_t points = data.points.size() / data.dimension;
    if (data.points.size() % data.dimension != 0)
        return {fmt::format("{} coordinates do not make whole points of {}", data.points.size(), data.dimension)};
    const std::size_t rows = data.u.size();
    const std::size_t columns = data.v.size();
    assert(columns > 0);
    // By division: the product of two sizes may be more than a number holds.
    if (points % columns == 0 && points / columns == rows) return {};
    return {fmt::format("knots for {} by {} control points need as many points, not {}", rows, columns, points)};
}

/// What is wrong with one coordinate, or nothing.
std::string value_problem(const GridData& data, std::size_t column, double value) {
    if (!std::isfinite(value)) return "every coordinate must be a finite number";
    const bool is_weight = data.rational && column + 1 == data.dimension;
    if (!is_weight || !first_bad_weight({&value, 1})) return {};
    return fmt::format("every weight must be between {} and {}", smallest_weight, largest_weight);
}

std::vector<std::string> value_problems(const GridData& data) {
    std::vector<std::string> problems;
    std::size_t found = 0;
    for (std::size_t i = 0; i < data.points.size(); ++i) {
        const std::size_t column = i % data.dimension;
        const std::string problem = value_problem(data, column, data.points[i]);
        if (problem.empty() || ++found > listed) continue;
        const std::size_t point = i / data.dimension;
        problems.push_back(fmt::format("row {}, column {}, coordinate {} is {}: {}", point / data.v.size() + 1,
                                       point % data.v.size() + 1, column + 1, data.points[i], problem));
    }
    if (found > listed) problems.push_back(fmt::format("and {} more coordinates like these", found - listed));
    return problems;
}

} // namespace

Grid::Grid(GridData data)
    : u_(std::move(data.u))
    , v_(std::move(data.v))
    , dimension_(data.dimension)
    , rational_(data.rational)
    , points_(std::move(data.points)) {
    assert(points_.size() == u_.size() * v_.size() * dimension_);
}

CheckedGrid make_grid(GridData data) {
    CheckedGrid checked;
    checked.problems = size_problems(data);
    if (checked.problems.empty()) checked.problems = value_problems(data);
    if (checked.problems.empty()) checked.grid = Grid(std::move(data));
    return checked;
}

std::vector<double> projected_points(const Grid& grid) {
    return grid.rational() ? projected_points(grid.points(), grid.dimension()) : grid.points();
}

} // namespace internode
