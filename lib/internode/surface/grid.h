// SPDX-License-Identifier: MIT
//
// A tensor-product B-spline surface: knots in two directions, and a control point for each pair of theirs.
//
//     S(x, y) = Σ_i Σ_j N_i(x) N_j(y) p_ij,   i = 0 … N_u - 1,  j = 0 … N_v - 1
//
// The directions are independent: each has its own grammar, degree and ends. Points stand in rows of one i, so that
// p_ij begins at coordinate (i N_v + j) · dimension. A rational surface has homogeneous points (w x, w y, w z, w), the
// last coordinate the weight; they are refined as they are and divided only when written or measured.

#pragma once

#include "internode/curve/knots.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace internode {

struct ApplyOptions;
struct GridData;
struct CheckedGrid;

class Grid {
public:
    [[nodiscard]] const Knots& u() const { return u_; }
    [[nodiscard]] const Knots& v() const { return v_; }
    /// Coordinates of a control point, the weight included.
    [[nodiscard]] std::size_t dimension() const { return dimension_; }
    /// Whether the last coordinate is a weight.
    [[nodiscard]] bool rational() const { return rational_; }
    /// Coordinates of a point of the surface.
    [[nodiscard]] std::size_t space_dimension() const { return rational_ ? dimension_ - 1 : dimension_; }
    /// u().size() · v().size() rows of dimension() coordinates.
    [[nodiscard]] const std::vector<double>& points() const { return points_; }
    [[nodiscard]] std::size_t size() const { return points_.size() / dimension_; }

private:
    friend CheckedGrid make_grid(GridData data);
    friend Grid refine(const Grid& grid, int steps_u, int steps_v, const ApplyOptions& options);
    explicit Grid(GridData data);
    Knots u_;
    Knots v_;
    std::size_t dimension_;
    bool rational_;
    std::vector<double> points_;
};

struct GridData {
    Knots u;
    Knots v;
    std::size_t dimension = 3;  ///< >= 1, and >= 2 when rational
    bool rational = false;      ///< the last coordinate is the weight, > 0 (curve/homogeneous.h)
    std::vector<double> points; ///< u.size() · v.size() rows of `dimension` coordinates
};

struct CheckedGrid {
    std::optional<Grid> grid;          ///< the grid, when everything fits
    std::vector<std::string> problems; ///< what does not fit, each a sentence with the numbers
};

/// Checks that there is a point for each pair of knots, that every coordinate is finite and every weight positive, by a
/// margin. At most a few problems of each kind are listed.
[[nodiscard]] CheckedGrid make_grid(GridData data);

/// The control points in space, size() rows of space_dimension() coordinates: divided by their weights when rational.
[[nodiscard]] std::vector<double> projected_points(const Grid& grid);

} // namespace internode
