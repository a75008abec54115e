// SPDX-License-Identifier: MIT

#include "internode/surface/refinement.h"

#include "internode/curve/refinement.h"
#include "internode/stencil/coordinate_buffer.h"
#include "internode/surface/grid_plan.h"

#include <limits>

namespace internode {

namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    return b != 0 && a > most / b ? most : a * b;
}

std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
    return a > most - b ? most : a + b;
}

} // namespace

GridSize refined_size(const Grid& grid, std::uint64_t steps_u, std::uint64_t steps_v, std::uint64_t cap) {
    const RefinementSize u = refined_size(grid.u(), 1, steps_u, cap);
    const RefinementSize v = refined_size(grid.v(), 1, steps_v, cap);
    GridSize size;
    size.rows = u.points;
    size.columns = v.points;
    size.points = product(size.rows, size.columns);
    size.exceeded = u.exceeded || v.exceeded || size.points > cap;
    // The last block of steps along u reads at most what there is before the last step (surface/grid_plan.h).
    const std::uint64_t rows_before = steps_u == 0 ? size.rows : refined_size(grid.u(), 1, steps_u - 1, cap).points;
    const std::uint64_t work = product(rows_before, sum(grid.v().size(), size.columns));
    size.bytes = product(sum(sum(grid.size(), work), size.points), grid.dimension() * sizeof(double));
    return size;
}

Grid refine(const Grid& grid, int steps_u, int steps_v, const ApplyOptions& options) {
    const GridPlan plan(grid.u(), grid.v(), steps_u, steps_v);
    std::vector<double> points = in_large_pages<double>(plan.output_rows() * plan.output_columns() * grid.dimension());
    plan.apply(grid.points(), grid.dimension(), points, options);
    return Grid({refined_knots(grid.u(), steps_u), refined_knots(grid.v(), steps_v), grid.dimension(), grid.rational(),
                 std::move(points)});
}

} // namespace internode
