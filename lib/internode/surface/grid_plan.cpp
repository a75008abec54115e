// SPDX-License-Identifier: MIT

#include "internode/surface/grid_plan.h"

#include "internode/curve/refinement.h"
#include "internode/stencil/coordinate_buffer.h"

#include <cassert>
#include <stdexcept>

namespace internode {
namespace {

/// A table pays at once where every row of it is used for a whole row of points, or for many rows.
PlanOptions for_many_points() {
    PlanOptions options;
    options.points_per_row = 1;
    return options;
}

} // namespace

/// The steps along u, before and in the last block.
struct GridPlan::Cut {
    const Knots& u;
    const Knots& v;
    int steps_u;
    int steps_v;

    [[nodiscard]] int last_block() const {
        const std::vector<int> blocks = refinement_plan(u, steps_u, for_many_points()).blocks();
        return blocks.empty() ? 0 : blocks.back();
    }
};

GridPlan::GridPlan(const Knots& u, const Knots& v, int steps_u, int steps_v)
    : GridPlan(Cut{u, v, steps_u, steps_v}) {}

GridPlan::GridPlan(const Cut& cut)
    : head_u_(refinement_plan(cut.u, cut.steps_u - cut.last_block(), for_many_points()))
    , tail_u_(refinement_plan(refined_knots(cut.u, head_u_.steps()), cut.steps_u - head_u_.steps(), for_many_points()))
    , v_(refinement_plan(cut.v, cut.steps_v, for_many_points())) {
    assert(head_u_.output_size() == tail_u_.input_size());
}

std::uint64_t GridPlan::work_bytes(std::size_t dimension) const {
    const std::uint64_t rows = tail_u_.input_size();
    return rows * (input_columns() + output_columns()) * dimension * sizeof(double);
}

void GridPlan::apply(std::span<const double> points, std::size_t dimension, std::span<double> out,
                     const ApplyOptions& options) const {
    const std::size_t coarse_row = input_columns() * dimension;
    const std::size_t fine_row = output_columns() * dimension;
    if (dimension == 0 || points.size() != input_rows() * coarse_row || out.size() != output_rows() * fine_row)
        throw std::invalid_argument("the points do not have the sizes of the plan");
    const std::size_t rows = tail_u_.input_size();
    CoordinateBuffer<double> head(rows * coarse_row);
    head_u_.apply<double>(points, coarse_row, head.values(), options);
    CoordinateBuffer<double> wide(rows * fine_row);
    v_.apply_each<double>(head.values(), rows, dimension, wide.values(), options);
    tail_u_.apply<double>(wide.values(), fine_row, out, options);
}

} // namespace internode
