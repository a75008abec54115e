// SPDX-License-Identifier: MIT
//
// Steps are cut into blocks, each as long as its table allows. The choice depends on the cells and the steps alone,
// never on the machine or the threads, so that the bytes do not either.

#include "internode/stencil/plan.h"

#include "internode/stencil/block_run.h"
#include "internode/stencil/coordinate_buffer.h"
#include "internode/stencil/levels.h"
#include "internode/stencil/parallel.h"
#include "internode/stencil/step_tables.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>

namespace internode {
namespace {

/// The points before the last block are at most this part of the output, where tables allow it (docs/promises.md, P4).
constexpr std::uint64_t least_growth = 12;

/// Chooses how many steps go together.
class BlockChoice {
public:
    BlockChoice(const CellAutomaton& automaton, std::size_t width, const Levels& levels, const PlanOptions& options)
        : automaton_(automaton)
        , width_(width)
        , levels_(levels)
        , options_(options) {}

    /// The steps of the block that ends after `level` steps: as many as its table allows, and more where the points
    /// before it would be a large part of the output.
    [[nodiscard]] int last_block(std::size_t level) const {
        assert(level >= 1 && level < levels_.sizes.size());
        const std::size_t most = std::min<std::size_t>(level, static_cast<std::size_t>(options_.most_fused_steps));
        std::vector<std::uint64_t> descendants(automaton_.state_count(), 1);
        advance(descendants);
        std::size_t chosen = 1;
        while (chosen < most) {
            advance(descendants);
            const std::uint64_t rows = rows_of(descendants, level - chosen - 1);
            const bool is_free = fits_cache(rows) && pays(rows, levels_.sizes[level]);
            const bool is_needed = levels_.sizes[level] / least_growth < levels_.sizes[level - chosen] &&
                                   is_small(rows, levels_.sizes[level]);
            if (!is_free && !is_needed) break;
            ++chosen;
        }
        return static_cast<int>(chosen);
    }

private:
    void advance(std::vector<std::uint64_t>& descendants) const {
        std::vector<std::uint64_t> next(descendants.size());
        for (std::uint32_t state = 0; state < descendants.size(); ++state)
            for (const CellAutomaton::Child& child : automaton_.children(state))
                next[state] = std::min(most_rows, next[state] + descendants[child.state]);
        descendants = std::move(next);
    }

    [[nodiscard]] std::uint64_t rows_of(const std::vector<std::uint64_t>& descendants, std::size_t level) const {
        assert(levels_.occupied[level].size() == descendants.size());
        std::uint64_t rows = 0;
        for (std::size_t state = 0; state < descendants.size(); ++state)
            if (levels_.occupied[level][state]) rows = std::min(most_rows, rows + descendants[state]);
        return rows;
    }

    [[nodiscard]] bool fits_cache(std::uint64_t rows) const {
        return rows * width_ * sizeof(double) <= options_.table_bytes;
    }
    [[nodiscard]] bool pays(std::uint64_t rows, std::uint64_t points) const {
        return rows * options_.points_per_row <= points;
    }
    /// Against the output, which has at least one coordinate a point.
    [[nodiscard]] bool is_small(std::uint64_t rows, std::uint64_t points) const { return rows * width_ * 32 <= points; }

    static constexpr std::uint64_t most_rows = std::uint64_t{1} << 40; // no table has as many
    const CellAutomaton& automaton_;
    std::size_t width_; ///< weights in a row
    const Levels& levels_;
    PlanOptions options_;
};

/// The counts come from the caller.
std::size_t coordinates(std::uint64_t points, std::size_t dimension) {
    if (dimension == 0) throw std::invalid_argument("no coordinates, or no polygons");
    if (points > SIZE_MAX / dimension) throw std::length_error("more coordinates than memory has addresses");
    return points * dimension;
}

} // namespace

StartCells start_cells(const IntervalSystem& system, int degree, WordView word, Ends ends, const PlanOptions& options) {
    NumberedCells start = numbered_cells(word, degree, ends);
    const AutomatonRows rows = options.most_fused_steps == 1 ? AutomatonRows::Exact : AutomatonRows::None;
    return {std::make_shared<const StencilAutomaton>(
                make_automaton(system, degree, start.states, options.state_limit, rows)),
            std::move(start.cells)};
}

StepFuser interval_fuser(std::shared_ptr<const StencilAutomaton> automaton, const IntervalSystem& system) {
    const std::size_t width = automaton->width();
    return {[fuser = IntervalFuser(std::move(automaton), system)](int steps, const std::vector<bool>& wanted) mutable {
                return fuser.table(steps, wanted);
            },
            width};
}

RefinementPlan::RefinementPlan(const IntervalSystem& system, int degree, WordView word, Ends ends, int steps,
                               const PlanOptions& options)
    : RefinementPlan(system, start_cells(system, degree, word, ends, options), steps, options) {}

RefinementPlan::RefinementPlan(const IntervalSystem& system, std::shared_ptr<const StencilAutomaton> automaton,
                               std::vector<std::uint32_t> cells, int steps, const PlanOptions& options)
    : RefinementPlan(system, StartCells{std::move(automaton), std::move(cells)}, steps, options) {}

RefinementPlan::RefinementPlan(const IntervalSystem& system, StartCells start, int steps, const PlanOptions& options)
    : RefinementPlan(start.automaton, std::move(start.cells), steps, interval_fuser(start.automaton, system), options) {
}

RefinementPlan::RefinementPlan(std::shared_ptr<const CellAutomaton> automaton, std::vector<std::uint32_t> cells,
                               int steps, const StepFuser& fuser, const PlanOptions& options)
    : automaton_(std::move(automaton))
    , cells_(std::move(cells)) {
    if (steps < 0) throw std::invalid_argument("a negative number of steps");
    choose_blocks(steps, fuser, options);
}

void RefinementPlan::choose_blocks(int steps, const StepFuser& fuser, const PlanOptions& options) {
    Levels levels = levels_of(*automaton_, cells_, steps);
    const BlockChoice choice(*automaton_, fuser.width, levels, options);
    StepTables tables(fuser);
    const auto table = [&](int level, int count) {
        return tables.of(count, levels.occupied[static_cast<std::size_t>(level - count)]);
    };
    for (int level = steps; level > 0;) {
        int count = choice.last_block(static_cast<std::size_t>(level));
        std::shared_ptr<const FusedStencils> stencils = table(level, count);
        if (stencils == nullptr) stencils = table(level, count = 1);
        assert(stencils != nullptr && stencils->steps == count && "one step is always there");
        level -= count;
        blocks_.insert(blocks_.begin(), {level, stencils});
    }
    sizes_ = std::move(levels.sizes);
}

std::vector<std::uint32_t> RefinementPlan::final_cells() const {
    if (blocks_.empty()) return cells_;
    const CellArray last = block_cells().back().refined(*blocks_.back().stencils, sizes_.back());
    return last.visit([&](const auto* states) { return std::vector<std::uint32_t>(states, states + last.size()); });
}

std::vector<int> RefinementPlan::blocks() const {
    std::vector<int> steps;
    for (const Block& block : blocks_) steps.push_back(block.stencils->steps);
    return steps;
}

std::uint64_t RefinementPlan::work_bytes(std::size_t dimension, std::size_t scalar_bytes) const {
    const std::uint64_t each = dimension * scalar_bytes + CellArray::bytes_for(automaton_->state_count());
    std::uint64_t most = 0;
    for (std::size_t i = 0; i + 1 < blocks_.size(); ++i) {
        const std::uint64_t before = i == 0 ? 0 : size_before(blocks_[i]);
        const std::uint64_t after = size_before(blocks_[i + 1]);
        most = std::max(most, (before + after) * each);
    }
    return most;
}

std::vector<CellArray> RefinementPlan::block_cells() const {
    std::vector<CellArray> cells;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (i == 0)
            cells.emplace_back(cells_, automaton_->state_count());
        else
            cells.push_back(cells.back().refined(*blocks_[i - 1].stencils, size_before(blocks_[i])));
    }
    return cells;
}

template<typename Scalar>
void RefinementPlan::apply_blocks(const std::vector<CellArray>& cells, const Scalar* points, std::size_t dimension,
                                  Scalar* out, const ApplyOptions& options) const {
    assert(cells.size() == blocks_.size());
    if (blocks_.empty()) std::copy_n(points, coordinates(input_size(), dimension), out);
    CoordinateBuffer<Scalar> before;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const bool last = i + 1 == blocks_.size();
        CoordinateBuffer<Scalar> after;
        if (!last) after = CoordinateBuffer<Scalar>(coordinates(size_before(blocks_[i + 1]), dimension));
        const Scalar* const parents = i == 0 ? points : before.data();
        run_block<Scalar>(*blocks_[i].stencils, cells[i], {parents, dimension}, last ? out : after.data(), options);
        before = std::move(after);
    }
}

template<typename Scalar>
void RefinementPlan::apply(std::span<const Scalar> points, std::size_t dimension, std::span<Scalar> out,
                           const ApplyOptions& options) const {
    apply_each(points, 1, dimension, out, options);
}

template<typename Scalar>
void RefinementPlan::apply_each(std::span<const Scalar> points, std::size_t polygons, std::size_t dimension,
                                std::span<Scalar> out, const ApplyOptions& options) const {
    const std::size_t before = coordinates(input_size(), dimension);
    const std::size_t after = coordinates(output_size(), dimension);
    if (points.size() != coordinates(before, polygons) || out.size() != coordinates(after, polygons))
        throw std::invalid_argument("the points do not have the sizes of the plan");
    const std::vector<CellArray> cells = block_cells();
    if (polygons == 1) {
        apply_blocks(cells, points.data(), dimension, out.data(), options);
        return;
    }
    const ApplyOptions inner{1, options.isa, options.grain, options.stores};
    for_each_task(polygons, options.threads, [&](std::size_t polygon) {
        apply_blocks(cells, points.data() + polygon * before, dimension, out.data() + polygon * after, inner);
    });
}

template void RefinementPlan::apply(std::span<const double> points, std::size_t dimension, std::span<double> out,
                                    const ApplyOptions& options) const;
template void RefinementPlan::apply(std::span<const float> points, std::size_t dimension, std::span<float> out,
                                    const ApplyOptions& options) const;
template void RefinementPlan::apply_each(std::span<const double> points, std::size_t polygons, std::size_t dimension,
                                         std::span<double> out, const ApplyOptions& options) const;
template void RefinementPlan::apply_each(std::span<const float> points, std::size_t polygons, std::size_t dimension,
                                         std::span<float> out, const ApplyOptions& options) const;

} // namespace internode
