// SPDX-License-Identifier: MIT
//
// One block of fused steps over all cells: the points before it to the points after it.
//
// Cells read their parents where they are; only the cells at the two ends, whose parents wrap around a closed curve or
// whose last parent has nothing behind it, read from copies. Tasks are runs of cells that write disjoint runs of
// points.

#pragma once

#include "internode/stencil/cell_array.h"
#include "internode/stencil/plan.h"

namespace internode {

template<typename Scalar>
struct ParentRows {
    const Scalar* first;   ///< the first of as many points as there are cells
    std::size_t dimension; ///< coordinates of a point
};

/// Writes all points after the block to `out`.
template<typename Scalar>
void run_block(const FusedStencils& stencils, const CellArray& cells, ParentRows<Scalar> parents, Scalar* out,
               const ApplyOptions& options);

} // namespace internode
