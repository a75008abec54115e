// SPDX-License-Identifier: MIT
//
// What refining a grid needs that does not depend on its points (stencil/plan.h), for both directions.
//
//     first the steps along u but for the last block, on the coarse rows; then along v, row by row; then the last block
//     along u, where a whole row is one point of many coordinates.
//
// So nearly all points are written once, by the last block, in stretches of whole cache lines, and the memory beside
// input and output is what that block reads.

#pragma once

#include "internode/curve/knots.h"
#include "internode/stencil/plan.h"

#include <cstdint>
#include <span>

namespace internode {

class GridPlan {
public:
    /// steps >= 0 in each direction. Exceptions of RefinementPlan.
    GridPlan(const Knots& u, const Knots& v, int steps_u, int steps_v);

    /// Control points along u and v, before and after.
    [[nodiscard]] std::size_t input_rows() const { return head_u_.input_size(); }
    [[nodiscard]] std::size_t input_columns() const { return v_.input_size(); }
    [[nodiscard]] std::size_t output_rows() const { return tail_u_.output_size(); }
    [[nodiscard]] std::size_t output_columns() const { return v_.output_size(); }
    /// Bytes that apply() needs beside input and output, about.
    [[nodiscard]] std::uint64_t work_bytes(std::size_t dimension) const;

    /// `points` has input_rows() · input_columns() rows of `dimension` coordinates, `out` output_rows() ·
    /// output_columns(). The bytes depend on no option. \throw std::invalid_argument for other sizes
    void apply(std::span<const double> points, std::size_t dimension, std::span<double> out,
               const ApplyOptions& options = {}) const;

private:
    struct Cut;
    explicit GridPlan(const Cut& cut);
    RefinementPlan head_u_;
    RefinementPlan tail_u_;
    RefinementPlan v_;
};

} // namespace internode
