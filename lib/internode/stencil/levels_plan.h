// SPDX-License-Identifier: MIT
//
// Refinement that keeps every level: the points after 1, 2, … n steps, one level after the other.
//
// A level is not computed from the one before it but from the first of its block (stencil/plan.h), by a table of as
// many steps as lie between. Each point is still written once, and the small levels alone are read again.

#pragma once

#include "internode/stencil/cell_array.h"
#include "internode/stencil/fused_stencils.h"
#include "internode/stencil/plan.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace internode {

class LevelsPlan {
public:
    /// Arguments and exceptions of RefinementPlan; steps >= 1.
    LevelsPlan(const IntervalSystem& system, int degree, WordView word, Ends ends, int steps,
               const PlanOptions& options = {});

    /// Points after 0, 1, … n steps.
    [[nodiscard]] const std::vector<std::uint64_t>& sizes() const { return plan_.sizes(); }
    [[nodiscard]] std::size_t input_size() const { return plan_.input_size(); }
    /// Of all levels 1 … n together.
    [[nodiscard]] std::size_t output_size() const { return static_cast<std::size_t>(starts_.back()); }
    /// Where a level 1 … n starts in the output, in points. \throw std::out_of_range
    [[nodiscard]] std::uint64_t start(int level) const;

    /// `points` has input_size() rows of `dimension` coordinates, `out` output_size(). Scalar is double or float; the
    /// bytes depend on no option. \throw std::invalid_argument for other sizes
    template<typename Scalar>
    void apply(std::span<const Scalar> points, std::size_t dimension, std::span<Scalar> out,
               const ApplyOptions& options = {}) const;

private:
    LevelsPlan(const IntervalSystem& system, const StartCells& start, int steps, const PlanOptions& options);

    struct Level {
        int base; ///< the level it is computed from
        std::shared_ptr<const FusedStencils> stencils;
    };
    [[nodiscard]] CellArray cells_of(int base) const;

    RefinementPlan plan_;
    std::vector<Level> levels_;         ///< how levels 1, 2, … are made
    std::vector<std::uint64_t> starts_; ///< n + 1
};

} // namespace internode
