// SPDX-License-Identifier: MIT
//
// Points of a surface by de Boor's algorithm, one direction after the other.

#pragma once

#include "internode/surface/grid.h"
#include "tests/reference/de_boor.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace internode::reference {

/// The homogeneous point over the pieces [t_i, t_{i+1}] of u and [t_j, t_{j+1}] of v, continued beyond them.
inline std::vector<Real> surface_piece(const Grid& grid, std::size_t i, Real x, std::size_t j, Real y) {
    const std::size_t row_size = grid.v().size() * grid.dimension();
    std::vector<double> ones(grid.u().size(), 1);
    DeBoorCurve columns = de_boor_curve(make_curve(grid.u(), 1, std::move(ones)).curve.value());
    std::vector<std::vector<Real>> rows;
    for (std::size_t row = 0; row < grid.u().size(); ++row) {
        const auto first = grid.points().begin() + static_cast<std::ptrdiff_t>(row * row_size);
        const Curve curve =
            make_curve(grid.v(), grid.dimension(), {first, first + static_cast<std::ptrdiff_t>(row_size)})
                .curve.value();
        rows.push_back(de_boor_piece(de_boor_curve(curve), j, y));
    }
    // Point m of an unrolled closed curve is point m - d, as in de_boor_curve.
    const std::size_t n = grid.u().size();
    const std::size_t shift = grid.u().ends() == Ends::Circular ? columns.degree * n - columns.degree : 0;
    for (std::size_t m = 0; m < columns.points.size(); ++m) columns.points[m] = rows[(m + shift) % n];
    return de_boor_piece(columns, i, x);
}

/// Divided by the weight.
inline std::vector<Real> in_space(const Grid& grid, std::vector<Real> point) {
    if (!grid.rational()) return point;
    const Real weight = point.back();
    point.pop_back();
    for (Real& coordinate : point) coordinate /= weight;
    return point;
}

} // namespace internode::reference
