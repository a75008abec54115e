// SPDX-License-Identifier: MIT
//
// Surfaces of known shape for tests, and surfaces by de Boor's algorithm one direction after the other.

#pragma once

#include "internode/surface/grid.h"
#include "tests/reference/de_boor.h"
#include "tests/reference/random_grid.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace internode::reference {

/// A -> A A.
inline IntervalSystem uniform_bisection() {
    return system_with({"AA"});
}

/// The full circle of four arcs as a rational quadratic, closed: double knots between the arcs.
inline Knots circle_knots() {
    const Symbol a{0};
    const Symbol o = zero_interval;
    return make_knots(uniform_bisection(), {2, Ends::Circular, {a, o, a, o, a, o, a, o}}).knots.value();
}

/// Its points (x, y, w), not multiplied by w: points of the circle at the knots, corners of the square with weight √½
/// between them.
inline std::vector<std::array<double, 3>> circle_points() {
    const double w = std::sqrt(0.5);
    return {{1, 0, 1}, {1, 1, w}, {0, 1, 1}, {-1, 1, w}, {-1, 0, 1}, {-1, -1, w}, {0, -1, 1}, {1, -1, w}};
}

/// The half circle from (0, -1) over (1, 0) to (0, 1), clamped.
inline Knots half_circle_knots() {
    const Symbol a{0};
    const Symbol o = zero_interval;
    return make_knots(uniform_bisection(), {2, Ends::Open, {o, o, a, o, a, o, o}}).knots.value();
}

inline std::vector<std::array<double, 3>> half_circle_points() {
    const double w = std::sqrt(0.5);
    return {{0, -1, 1}, {1, -1, w}, {1, 0, 1}, {1, 1, w}, {0, 1, 1}};
}

/// The profile (r, z, w), r >= 0, turned around the z axis: u goes round, v along the profile. The normal S_u × S_v
/// points outwards where the profile runs upwards.
inline Grid revolved(const Knots& profile_knots, const std::vector<std::array<double, 3>>& profile) {
    std::vector<double> points;
    for (const auto& [x, y, w] : circle_points())
        for (const auto& [r, z, v] : profile)
            points.insert(points.end(), {r * x * w * v, r * y * w * v, z * w * v, w * v});
    return grid_of({circle_knots(), profile_knots, 4, true, points});
}

/// The unit sphere; its poles are whole rows of one point.
inline Grid unit_sphere() {
    return revolved(half_circle_knots(), half_circle_points());
}

/// A torus: the circle of radius `tube` around (`ring`, 0), turned around the z axis.
inline Grid torus(double ring, double tube) {
    std::vector<std::array<double, 3>> profile = circle_points();
    for (auto& [r, z, w] : profile) {
        r = ring + tube * r;
        z *= tube;
    }
    return revolved(circle_knots(), profile);
}

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
