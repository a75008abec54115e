// SPDX-License-Identifier: MIT
//
// Refinement of a tensor-product surface: the same surface over more and more intervals in both directions.
//
// The matrix of a step of the grid is the product of a matrix in each direction. So the rows are refined along v and
// then whole rows along u: one row of the grid is one point of many coordinates to the stencils of u. Rational points
// are refined in homogeneous coordinates.

#pragma once

#include "internode/stencil/plan.h"
#include "internode/surface/grid.h"

#include <cstdint>

namespace internode {

struct GridSize {
    std::uint64_t rows = 0;    ///< control points along u after the steps
    std::uint64_t columns = 0; ///< along v
    std::uint64_t points = 0;  ///< rows · columns
    std::uint64_t bytes = 0;   ///< memory that the refinement needs: at most, beside words and tables
    bool exceeded = false;     ///< more points than the cap: all of these are then lower bounds
};

/// The size after so many steps in each direction, without refining. Stops counting beyond `cap` points.
[[nodiscard]] GridSize refined_size(const Grid& grid, std::uint64_t steps_u, std::uint64_t steps_v, std::uint64_t cap);

/// The grid after steps >= 0 in each direction, the fast way (surface/grid_plan.h). \throw std::invalid_argument for
/// fewer, TooManyStates
[[nodiscard]] Grid refine(const Grid& grid, int steps_u, int steps_v, const ApplyOptions& options = {});

} // namespace internode
