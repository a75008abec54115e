// SPDX-License-Identifier: MIT
//
// Random grids, the same ones on every machine, and their refinement one curve at a time.

#pragma once

#include "internode/curve/refinement.h"
#include "internode/surface/grid.h"
#include "tests/reference/random_curve.h"

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace internode::reference {

inline Grid grid_of(GridData data) {
    CheckedGrid checked = make_grid(std::move(data));
    if (!checked.grid) throw std::logic_error("the grid does not fit: " + checked.problems.front());
    return *std::move(checked.grid);
}

/// Knots with `letters` intervals that have a length in their domain.
inline Knots random_knots(Random& random, const IntervalSystem& system, int degree, Shape shape, std::size_t letters) {
    return random_curve(random, system, degree, shape, letters, 1).knots();
}

/// Random points over the knots; of a rational one the last coordinate is a weight in [1/2, 3/2).
inline Grid random_grid(Random& random, const Knots& u, const Knots& v, std::size_t dimension, bool rational) {
    GridData data{u, v, dimension, rational, {}};
    for (std::size_t i = 0; i < u.size() * v.size() * dimension; ++i) {
        const bool weight = rational && (i + 1) % dimension == 0;
        data.points.push_back(weight ? 1 + random.coordinate() / 2 : random.coordinate());
    }
    return grid_of(std::move(data));
}

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
