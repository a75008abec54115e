// SPDX-License-Identifier: MIT
//
// The cells are cut into tasks that write about as many coordinates as options.grain says; the place of a task's first
// point is known beforehand. A task hands its cells to the kernel in batches: where the parents stand, where the rows
// begin, and how many there are.

#include "internode/stencil/block_run.h"

#include "internode/stencil/kernel.h"
#include "internode/stencil/parallel.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace internode {
namespace {

/// Wide points of larger outputs, rows of a grid, go past the caches: their many stretches would evict the parents.
/// Narrow points come in one stretch, which ordinary stores write faster (bench/: fresh and reused, 10 and 24 M
/// points).
constexpr std::size_t streamed_bytes = std::size_t{1} << 24;
constexpr std::size_t narrow = 4;
/// Cells that are handed to the kernel at once: their descriptions stay in the first cache.
constexpr std::size_t batch = 128;

/// The weights as the kernel wants them; floats are rounded once more.
template<typename Scalar>
std::vector<Scalar> converted(const std::vector<double>& weights) {
    std::vector<Scalar> result(weights.size());
    std::ranges::transform(weights, result.begin(), [](double weight) { return static_cast<Scalar>(weight); });
    return result;
}

struct Task {
    std::size_t first_cell;
    std::size_t last_cell;
    std::size_t first_point; ///< place of the first point in the output
};

/// Runs of cells that write about `grain` points each.
template<typename State>
std::vector<Task> tasks_of(const FusedStencils& stencils, const State* states, std::size_t cells, std::size_t grain) {
    assert(cells > 0 && grain > 0);
    std::vector<Task> tasks;
    std::size_t point = 0;
    Task task{0, 0, 0};
    for (std::size_t cell = 0; cell < cells; ++cell) {
        point += stencils.rows(states[cell]);
        if (point - task.first_point < grain && cell + 1 < cells) continue;
        task.last_cell = cell + 1;
        tasks.push_back(task);
        task = {cell + 1, 0, point};
    }
    assert(tasks.back().last_cell == cells);
    return tasks;
}

template<typename Scalar, typename State>
class BlockRun {
public:
    BlockRun(const FusedStencils& stencils, const State* states, std::size_t cells, ParentRows<Scalar> parents)
        : stencils_(stencils)
        , states_(states)
        , cells_(cells)
        , parents_(parents) {
        if constexpr (!std::is_same_v<Scalar, double>) own_weights_ = converted<Scalar>(stencils.weights);
        assert(stencils.first_row.size() == stencils.offset.size() + 1);
        assert(stencils.weights.size() == stencils.row_count() * stencils.width);
        copy_ends();
    }

    void run(Scalar* out, const ApplyOptions& options) const {
        const std::size_t dimension = parents_.dimension;
        assert(dimension > 0);
        const std::size_t grain = std::max<std::size_t>(1, options.grain / dimension);
        const std::vector<Task> tasks = tasks_of(stencils_, states_, cells_, grain);
        std::size_t points = 0;
        for (const State* state = states_ + tasks.back().first_cell; state != states_ + cells_; ++state)
            points += stencils_.rows(*state);
        points += tasks.back().first_point;
        const bool streams = dimension > narrow && points * dimension * sizeof(Scalar) > streamed_bytes;
        const Store store = streams ? Store::Streamed : Store::Cached;
        const Kernel<Scalar> kernel = internode::kernel<Scalar>(options.isa, stencils_.width, dimension);
        const auto run_task = [&](std::size_t task) {
            run_cells(tasks[task], kernel, out + tasks[task].first_point * dimension, store);
        };
        for_each_task(tasks.size(), options.threads, run_task);
    }

private:
    void run_cells(const Task& task, Kernel<Scalar> kernel, Scalar* out, Store store) const {
        CellWork<Scalar> work[batch];
        for (std::size_t first = task.first_cell; first < task.last_cell; first += batch) {
            const std::size_t last = std::min(first + batch, task.last_cell);
            std::size_t count = 0; // of the cells that have descendants
            std::size_t points = 0;
            for (std::size_t cell = first; cell < last; ++cell) {
                work[count] = describe(cell);
                points += work[count].rows;
                if (work[count].rows > 0) ++count;
            }
            if (count == 0) continue;
            kernel(work, count, parents_.dimension, out, store);
            out += points * parents_.dimension;
        }
    }

    [[nodiscard]] CellWork<Scalar> describe(std::size_t cell) const {
        const State state = states_[cell];
        const std::size_t row = stencils_.first_row[state];
        const Scalar* weights = nullptr;
        if constexpr (std::is_same_v<Scalar, double>)
            weights = stencils_.weights.data();
        else
            weights = own_weights_.data();
        return {parents_of(cell, state), weights + row * stencils_.width, stencils_.rows(state)};
    }

    [[nodiscard]] const Scalar* parents_of(std::size_t cell, State state) const {
        if (cell < left_) return ends_.data() + cell * end_stride();
        if (cell >= right_) return ends_.data() + (left_ + cell - right_) * end_stride();
        return parents_.first + (static_cast<std::ptrdiff_t>(cell) + stencils_.offset[state]) *
                                    static_cast<std::ptrdiff_t>(parents_.dimension);
    }

    /// Coordinates of the copied parents of one cell, with what a vector may read behind the last.
    [[nodiscard]] std::size_t end_stride() const {
        return stencils_.width * parents_.dimension + padding_bytes / sizeof(Scalar);
    }

    /// The cells whose parents are not all there, and those that have no whole point behind their parents.
    void copy_ends() {
        const auto [least, most] = std::ranges::minmax(stencils_.offset);
        const auto width = static_cast<std::ptrdiff_t>(stencils_.width);
        const auto before = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, -least));
        const auto behind = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, most + width));
        left_ = std::min(cells_, before);
        right_ = std::max(left_, cells_ - std::min(cells_, behind));
        ends_.resize((left_ + cells_ - right_) * end_stride());
        for (std::size_t cell = 0; cell < left_; ++cell) copy_parents(cell, ends_.data() + cell * end_stride());
        for (std::size_t cell = right_; cell < cells_; ++cell)
            copy_parents(cell, ends_.data() + (left_ + cell - right_) * end_stride());
    }

    void copy_parents(std::size_t cell, Scalar* to) const {
        const auto n = static_cast<std::ptrdiff_t>(cells_);
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(cell) + stencils_.offset[states_[cell]];
        for (std::size_t k = 0; k < stencils_.width; ++k) {
            const std::ptrdiff_t parent = ((first + static_cast<std::ptrdiff_t>(k)) % n + n) % n;
            std::copy_n(parents_.first + static_cast<std::size_t>(parent) * parents_.dimension, parents_.dimension,
                        to + k * parents_.dimension);
        }
    }

    const FusedStencils& stencils_;
    const State* states_;
    std::size_t cells_;
    ParentRows<Scalar> parents_;
    std::vector<Scalar> own_weights_; ///< the weights as Scalar, when that is not double
    std::size_t left_ = 0;            ///< cells before this read copies
    std::size_t right_ = 0;           ///< and from this on
    std::vector<Scalar> ends_;
};

} // namespace

template<typename Scalar>
void run_block(const FusedStencils& stencils, const CellArray& cells, ParentRows<Scalar> parents, Scalar* out,
               const ApplyOptions& options) {
    if (cells.size() == 0) return; // all cells have died
    cells.visit([&](const auto* states) {
        using State = std::remove_const_t<std::remove_pointer_t<decltype(states)>>;
        BlockRun<Scalar, State>(stencils, states, cells.size(), parents).run(out, options);
    });
}

template void run_block(const FusedStencils& stencils, const CellArray& cells, ParentRows<double> parents, double* out,
                        const ApplyOptions& options);
template void run_block(const FusedStencils& stencils, const CellArray& cells, ParentRows<float> parents, float* out,
                        const ApplyOptions& options);

} // namespace internode
