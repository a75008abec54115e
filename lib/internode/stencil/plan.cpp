// SPDX-License-Identifier: MIT

#include "internode/stencil/plan.h"

#include "internode/stencil/block_run.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace internode {
namespace {

/// A row of a fused table takes as long as about so many points take: measured, cubic (bench/).
constexpr std::uint64_t points_per_row = 256;
/// The points before the last block are at most this part of the output, where tables allow it (docs/promises.md, P4).
constexpr std::uint64_t least_growth = 12;

/// The sizes after 0 … steps steps from these cells.
std::vector<std::uint64_t> level_sizes(const StencilAutomaton& automaton, const std::vector<std::uint32_t>& cells,
                                       int steps) {
    constexpr std::uint64_t most = std::uint64_t{1} << 62;
    std::vector<std::uint64_t> cells_of(automaton.state_count());
    for (const std::uint32_t state : cells) ++cells_of[state];
    std::vector<std::uint64_t> sizes{cells.size()};
    for (int step = 0; step < steps; ++step) {
        std::vector<std::uint64_t> next(cells_of.size());
        std::uint64_t total = 0;
        for (std::uint32_t state = 0; state < cells_of.size(); ++state)
            for (const StencilAutomaton::Child& child : automaton.children(state)) {
                next[child.state] += cells_of[state];
                total += cells_of[state];
                if (total > most) throw std::length_error("a refinement to more than 2^62 points");
            }
        cells_of = std::move(next);
        sizes.push_back(total);
    }
    return sizes;
}

/// Chooses how many steps go together.
class BlockChoice {
public:
    BlockChoice(const StencilAutomaton& automaton, const PlanOptions& options, int steps)
        : options_(options)
        , width_(automaton.width()) {
        DescendantCounts counts(automaton);
        const int most = std::min(steps, std::max(options.most_fused_steps, 1));
        for (int step = 0; step < most; ++step) {
            counts.step();
            rows_.push_back(counts.total());
            // What no table can hold needs no counting.
            if (rows_.back() > std::uint64_t{1} << 32) break;
        }
    }

    /// The steps of the block that ends with so many points after `level` steps.
    [[nodiscard]] int last_block(const std::vector<std::uint64_t>& sizes, int level) const {
        const auto most = static_cast<std::size_t>(std::min<int>(level, static_cast<int>(rows_.size())));
        const auto end = static_cast<std::size_t>(level);
        std::size_t chosen = 1;
        while (chosen < most && fits_cache(rows_[chosen]) && pays(rows_[chosen], sizes[end])) ++chosen;
        while (chosen < most && sizes[end] / least_growth < sizes[end - chosen] && is_small(rows_[chosen], sizes[end]))
            ++chosen;
        return static_cast<int>(chosen);
    }

private:
    [[nodiscard]] bool fits_cache(std::uint64_t rows) const {
        return rows * width_ * sizeof(double) <= options_.table_bytes;
    }
    [[nodiscard]] static bool pays(std::uint64_t rows, std::uint64_t points) { return rows * points_per_row <= points; }
    /// Against the output, which has at least one coordinate a point.
    [[nodiscard]] bool is_small(std::uint64_t rows, std::uint64_t points) const { return rows * width_ * 32 <= points; }

    PlanOptions options_;
    std::size_t width_;
    std::vector<std::uint64_t> rows_; ///< of the table of 1, 2, … steps
};

std::shared_ptr<const FusedStencils> shared(FusedStencils stencils) {
    return std::make_shared<const FusedStencils>(std::move(stencils));
}

/// Output sizes are multiplied by dimensions that come from the caller.
std::size_t coordinates(std::uint64_t points, std::size_t dimension) {
    if (dimension == 0) throw std::invalid_argument("a point needs at least one coordinate");
    if (points > SIZE_MAX / dimension) throw std::length_error("more coordinates than memory has addresses");
    return points * dimension;
}

} // namespace

RefinementPlan::RefinementPlan(const IntervalSystem& system, int degree, WordView word, Ends ends, int steps,
                               const PlanOptions& options) {
    if (steps < 0) throw std::invalid_argument("a negative number of steps");
    const std::vector<CellState> states = cell_states(word, degree, ends);
    automaton_ = std::make_shared<const StencilAutomaton>(make_automaton(system, degree, states, options.state_limit));
    cells_.reserve(states.size());
    for (const CellState& state : states) cells_.push_back(automaton_->find(state));
    sizes_ = level_sizes(*automaton_, cells_, steps);

    const BlockChoice choice(*automaton_, options, steps);
    for (int level = steps; level > 0;) {
        int count = choice.last_block(sizes_, level);
        auto stencils = table_of(system, count);
        if (stencils == nullptr) stencils = table_of(system, count = 1);
        level -= count;
        blocks_.insert(blocks_.begin(), {level, stencils});
    }
}

std::shared_ptr<const FusedStencils> RefinementPlan::table_of(const IntervalSystem& system, int steps) {
    for (const Block& block : blocks_)
        if (block.stencils->steps == steps) return block.stencils;
    std::optional<FusedStencils> made = fuse(*automaton_, system, steps);
    return made ? shared(*std::move(made)) : nullptr;
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
        const std::uint64_t before = i == 0 ? 0 : sizes_[static_cast<std::size_t>(blocks_[i].first_step)];
        const std::uint64_t after = sizes_[static_cast<std::size_t>(blocks_[i + 1].first_step)];
        most = std::max(most, (before + after) * each);
    }
    return most;
}

template <typename Scalar>
void RefinementPlan::apply(std::span<const Scalar> points, std::size_t dimension, std::span<Scalar> out,
                           const ApplyOptions& options) const {
    if (points.size() != coordinates(input_size(), dimension) || out.size() != coordinates(output_size(), dimension))
        throw std::invalid_argument("the points do not have the sizes of the plan");
    if (blocks_.empty()) {
        std::ranges::copy(points, out.begin());
        return;
    }
    CellArray cells(cells_, automaton_->state_count());
    std::unique_ptr<Scalar[]> before;
    const Scalar* parents = points.data();
    for (const Block& block : blocks_) {
        const auto level = static_cast<std::size_t>(block.first_step);
        const bool last = &block == &blocks_.back();
        const std::uint64_t count = sizes_[level + static_cast<std::size_t>(block.stencils->steps)];
        // for_overwrite: every coordinate is written by the block.
        std::unique_ptr<Scalar[]> after;
        if (!last) after = std::make_unique_for_overwrite<Scalar[]>(coordinates(count, dimension));
        run_block<Scalar>(*block.stencils, cells, {parents, dimension}, last ? out.data() : after.get(), options);
        if (!last) cells = cells.refined(*block.stencils, count);
        before = std::move(after);
        parents = before.get();
    }
}

template void RefinementPlan::apply(std::span<const double> points, std::size_t dimension, std::span<double> out,
                                    const ApplyOptions& options) const;
template void RefinementPlan::apply(std::span<const float> points, std::size_t dimension, std::span<float> out,
                                    const ApplyOptions& options) const;

} // namespace internode
