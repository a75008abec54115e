// SPDX-License-Identifier: MIT

#include "internode/stencil/plan.h"

#include "internode/stencil/block_run.h"
#include "internode/stencil/coordinate_buffer.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace internode {
namespace {

/// The points before the last block are at most this part of the output, where tables allow it (docs/promises.md, P4).
constexpr std::uint64_t least_growth = 12;

/// Which states occur after 0, 1, … steps, and how many cells there are.
struct Levels {
    std::vector<std::uint64_t> sizes;
    std::vector<std::vector<bool>> occupied;
};

std::vector<bool> present(const std::vector<std::uint64_t>& cells_of) {
    std::vector<bool> result;
    result.reserve(cells_of.size());
    for (const std::uint64_t count : cells_of) result.push_back(count > 0);
    return result;
}

Levels levels_of(const StencilAutomaton& automaton, const std::vector<std::uint32_t>& cells, int steps) {
    constexpr std::uint64_t most = std::uint64_t{1} << 62;
    std::vector<std::uint64_t> cells_of(automaton.state_count());
    for (const std::uint32_t state : cells) ++cells_of[state];
    Levels levels{{cells.size()}, {present(cells_of)}};
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
        levels.sizes.push_back(total);
        levels.occupied.push_back(present(cells_of));
    }
    return levels;
}

/// Chooses how many steps go together.
class BlockChoice {
public:
    BlockChoice(const StencilAutomaton& automaton, const Levels& levels, const PlanOptions& options)
        : automaton_(automaton)
        , levels_(levels)
        , options_(options) {}

    /// The steps of the block that ends after `level` steps: as many as its table allows, and more where the points
    /// before it would be a large part of the output.
    [[nodiscard]] int last_block(std::size_t level) const {
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
            for (const StencilAutomaton::Child& child : automaton_.children(state))
                next[state] = std::min(most_rows, next[state] + descendants[child.state]);
        descendants = std::move(next);
    }

    [[nodiscard]] std::uint64_t rows_of(const std::vector<std::uint64_t>& descendants, std::size_t level) const {
        std::uint64_t rows = 0;
        for (std::size_t state = 0; state < descendants.size(); ++state)
            if (levels_.occupied[level][state]) rows = std::min(most_rows, rows + descendants[state]);
        return rows;
    }

    [[nodiscard]] bool fits_cache(std::uint64_t rows) const {
        return rows * automaton_.width() * sizeof(double) <= options_.table_bytes;
    }
    [[nodiscard]] bool pays(std::uint64_t rows, std::uint64_t points) const {
        return rows * options_.points_per_row <= points;
    }
    /// Against the output, which has at least one coordinate a point.
    [[nodiscard]] bool is_small(std::uint64_t rows, std::uint64_t points) const {
        return rows * automaton_.width() * 32 <= points;
    }

    static constexpr std::uint64_t most_rows = std::uint64_t{1} << 40; // no table has as many
    const StencilAutomaton& automaton_;
    const Levels& levels_;
    PlanOptions options_;
};

/// The table of a block; none where it would not be precise.
std::shared_ptr<const FusedStencils> table_of(const StencilAutomaton& automaton, const IntervalSystem& system,
                                              int steps, const std::vector<bool>& wanted) {
    std::optional<FusedStencils> made = fuse(automaton, system, steps, wanted);
    return made ? std::make_shared<const FusedStencils>(*std::move(made)) : nullptr;
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
    Levels levels = levels_of(*automaton_, cells_, steps);

    const BlockChoice choice(*automaton_, levels, options);
    for (int level = steps; level > 0;) {
        int count = choice.last_block(static_cast<std::size_t>(level));
        const auto wanted = [&] { return levels.occupied[static_cast<std::size_t>(level - count)]; };
        auto stencils = table_of(*automaton_, system, count, wanted());
        if (stencils == nullptr) stencils = table_of(*automaton_, system, count = 1, wanted());
        level -= count;
        blocks_.insert(blocks_.begin(), {level, stencils});
    }
    sizes_ = std::move(levels.sizes);
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

template<typename Scalar>
void RefinementPlan::apply(std::span<const Scalar> points, std::size_t dimension, std::span<Scalar> out,
                           const ApplyOptions& options) const {
    if (points.size() != coordinates(input_size(), dimension) || out.size() != coordinates(output_size(), dimension))
        throw std::invalid_argument("the points do not have the sizes of the plan");
    if (blocks_.empty()) {
        std::ranges::copy(points, out.begin());
        return;
    }
    CellArray cells(cells_, automaton_->state_count());
    CoordinateBuffer<Scalar> before;
    const Scalar* parents = points.data();
    for (const Block& block : blocks_) {
        const auto level = static_cast<std::size_t>(block.first_step);
        const bool last = &block == &blocks_.back();
        const std::uint64_t count = sizes_[level + static_cast<std::size_t>(block.stencils->steps)];
        CoordinateBuffer<Scalar> after;
        if (!last) after = CoordinateBuffer<Scalar>(coordinates(count, dimension));
        run_block<Scalar>(*block.stencils, cells, {parents, dimension}, last ? out.data() : after.data(), options);
        if (!last) cells = cells.refined(*block.stencils, count);
        before = std::move(after);
        parents = before.data();
    }
}

template void RefinementPlan::apply(std::span<const double> points, std::size_t dimension, std::span<double> out,
                                    const ApplyOptions& options) const;
template void RefinementPlan::apply(std::span<const float> points, std::size_t dimension, std::span<float> out,
                                    const ApplyOptions& options) const;

} // namespace internode
