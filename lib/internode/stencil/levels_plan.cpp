// SPDX-License-Identifier: MIT

#include "internode/stencil/levels_plan.h"

#include "internode/stencil/block_run.h"
#include "internode/stencil/levels.h"
#include "internode/stencil/step_tables.h"

#include <cassert>
#include <optional>
#include <stdexcept>
#include <utility>

namespace internode {

LevelsPlan::LevelsPlan(const IntervalSystem& system, int degree, WordView word, Ends ends, int steps,
                       const PlanOptions& options)
    : LevelsPlan(system, start_cells(system, degree, word, ends, options), steps, options) {}

LevelsPlan::LevelsPlan(const IntervalSystem& system, const StartCells& start, int steps, const PlanOptions& options)
    : plan_(system, start.automaton, start.cells, steps, options)
    , starts_{0} {
    if (steps < 1) throw std::invalid_argument("levels of fewer than one step");
    const Levels levels = levels_of(*start.automaton, start.cells, steps);
    const StepFuser fuser = interval_fuser(start.automaton, system);
    StepTables tables(fuser);
    const auto table = [&](int base, int level) {
        return tables.of(level - base, levels.occupied[static_cast<std::size_t>(base)]);
    };
    levels_.resize(static_cast<std::size_t>(steps));
    const std::vector<int> blocks = plan_.blocks();
    int end = steps;
    // From the last block to the first, whose cells have fewer states.
    for (auto block = blocks.rbegin(); block != blocks.rend(); ++block) {
        const int first = end - *block;
        int base = first;
        for (int level = first + 1; level <= end; ++level) {
            std::shared_ptr<const FusedStencils> stencils = table(base, level);
            if (stencils == nullptr) stencils = table(base = level - 1, level);
            assert(stencils != nullptr && "one step is always there");
            levels_[static_cast<std::size_t>(level - 1)] = {base, std::move(stencils)};
        }
        end = first;
    }
    assert(end == 0);
    for (std::size_t level = 1; level < sizes().size(); ++level) starts_.push_back(starts_.back() + sizes()[level]);
}

std::uint64_t LevelsPlan::start(int level) const {
    if (level < 1 || static_cast<std::size_t>(level) > levels_.size()) throw std::out_of_range("no such level");
    return starts_[static_cast<std::size_t>(level - 1)];
}

CellArray LevelsPlan::cells_of(int base) const {
    assert(base >= 0 && static_cast<std::size_t>(base) <= levels_.size());
    if (base == 0) return {plan_.cells(), plan_.automaton().state_count()};
    const Level& level = levels_[static_cast<std::size_t>(base - 1)];
    return cells_of(level.base).refined(*level.stencils, sizes()[static_cast<std::size_t>(base)]);
}

template<typename Scalar>
void LevelsPlan::apply(std::span<const Scalar> points, std::size_t dimension, std::span<Scalar> out,
                       const ApplyOptions& options) const {
    if (dimension == 0 || points.size() % dimension != 0 || out.size() % dimension != 0 ||
        points.size() / dimension != input_size() || out.size() / dimension != output_size())
        throw std::invalid_argument("the points do not have the sizes of the plan");
    std::optional<CellArray> cells;
    int base = -1;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        if (levels_[i].base != base) cells = cells_of(base = levels_[i].base);
        const Scalar* const parents = base == 0 ? points.data() : out.data() + start(base) * dimension;
        run_block<Scalar>(*levels_[i].stencils, *cells, {parents, dimension}, out.data() + starts_[i] * dimension,
                          options);
    }
}

template void LevelsPlan::apply(std::span<const double> points, std::size_t dimension, std::span<double> out,
                                const ApplyOptions& options) const;
template void LevelsPlan::apply(std::span<const float> points, std::size_t dimension, std::span<float> out,
                                const ApplyOptions& options) const;

} // namespace internode
