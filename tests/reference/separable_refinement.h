// SPDX-License-Identifier: MIT
//
// The refinement of a grid one curve at a time: each row along v, then each column along u.

#pragma once

#include "internode/curve/refinement.h"
#include "internode/surface/grid.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace internode::reference {

/// One curve refined step by step, without its knots.
inline std::vector<double> refined_points(const Knots& knots, std::size_t dimension, std::vector<double> points,
                                          int steps) {
    Refinement refinement(make_curve(knots, dimension, std::move(points)).curve.value());
    for (int step = 0; step < steps; ++step) refinement.step();
    return refinement.curve().points();
}

/// The points of the refined grid: each row a curve along v, then each column a curve along u.
inline std::vector<double> separably_refined(const Grid& grid, int steps_u, int steps_v) {
    const std::size_t dimension = grid.dimension();
    const std::size_t row_size = grid.v().size() * dimension;
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < grid.u().size(); ++i) {
        const auto first = grid.points().begin() + static_cast<std::ptrdiff_t>(i * row_size);
        rows.push_back(
            refined_points(grid.v(), dimension, {first, first + static_cast<std::ptrdiff_t>(row_size)}, steps_v));
    }
    const std::size_t columns = rows.front().size() / dimension;
    std::vector<std::vector<double>> refined;
    for (std::size_t j = 0; j < columns; ++j) {
        std::vector<double> column;
        for (const std::vector<double>& row : rows)
            column.insert(column.end(), &row[j * dimension], &row[j * dimension] + dimension);
        refined.push_back(refined_points(grid.u(), dimension, std::move(column), steps_u));
    }
    std::vector<double> points;
    for (std::size_t i = 0; i < refined.front().size(); i += dimension)
        for (const std::vector<double>& column : refined)
            points.insert(points.end(), &column[i], &column[i] + dimension);
    return points;
}

} // namespace internode::reference
