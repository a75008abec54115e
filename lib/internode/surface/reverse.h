// SPDX-License-Identifier: MIT
//
// Grids backwards: a coarse grid and details, exactly as many numbers as the fine grid has.
//
// In one direction a polygon becomes its coarse polygon and one detail per inserted knot (curve/reverse/pyramid.h): a
// linear map W that synthesis inverts. A grid takes W_v on every row, then W_u on the rows. Coefficients stand where
// the points of the fine grid stood, in rows of N_v: those of the coarse polygon first, then the details of each step
// from coarse to fine. So the first n_u by n_v are the coarse grid, the rest details along v, along u, or along both.

#pragma once

#include "internode/curve/reverse/details.h"
#include "internode/surface/grid.h"

#include <span>
#include <vector>

namespace internode {

/// Where a decomposition ends: the coarse knots, and how many steps lie between them and the fine grid.
struct GridHierarchy {
    Knots u;
    Knots v;
    int levels_u = 1; ///< >= 0
    int levels_v = 1;
};

/// The coefficients of a fine grid with points of `dimension` coordinates over the knots so many steps finer.
/// \throw std::invalid_argument for another number of points or negative levels; TooManyStates
[[nodiscard]] std::vector<double> decomposed(const GridHierarchy& hierarchy, std::size_t dimension,
                                             std::span<const double> fine, const ReverseOptions& options = {});

/// The fine points again. With 0 instead of some details: an approximation of them. Exceptions of decomposed()
[[nodiscard]] std::vector<double> recomposed(const GridHierarchy& hierarchy, std::size_t dimension,
                                             std::span<const double> coefficients, const ReverseOptions& options = {});

} // namespace internode
