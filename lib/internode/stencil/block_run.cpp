// SPDX-License-Identifier: MIT
//
// The cells are cut into tasks that write about as many coordinates as options.grain says; the place of a task's first
// point is known beforehand. A task hands its cells to the kernel in batches: where the parents stand, where the rows
// begin, and how many there are.
//
// A large result is written by ordinary stores or past the caches. Which are faster is measured on its first stretches,
// by turns: it depends on the machine, and on whether the memory is fresh.

#include "internode/stencil/block_run.h"

#include "internode/stencil/kernel.h"
#include "internode/stencil/line_writer.h"
#include "internode/stencil/parallel.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <chrono>
#include <limits>
#include <span>
#include <type_traits>

namespace internode {
namespace {

/// Smaller results are read from a cache soon after.
constexpr std::size_t measured_bytes = std::size_t{1} << 25;
/// Stretches of each kind; as long as a large page, so that in fresh memory each pays for one.
constexpr std::size_t trials = 3;
constexpr std::size_t trial_bytes = std::size_t{1} << 21;
/// Streaming must win by more than the noise: it leaves nothing of the result in a cache.
constexpr double sure = 0.9;
/// Cells that are handed to the kernel at once: their descriptions stay in the first cache.
constexpr std::size_t batch = 128;

/// Rows of a table are put into groups when each makes so many points: it takes the time of a few.
constexpr std::size_t points_to_group = 16;

/// The weights as the kernel wants them: rounded once more for floats, and the first rows of each cell in groups.
template<typename Scalar>
std::vector<Scalar> arranged(const FusedStencils& stencils, std::size_t group) {
    const std::size_t width = stencils.width;
    std::vector<Scalar> result(stencils.weights.size());
    std::ranges::transform(stencils.weights, result.begin(), [](double weight) { return static_cast<Scalar>(weight); });
    if (group == 1) return result;
    for (std::uint32_t state = 0; state < stencils.offset.size(); ++state) {
        std::size_t row = stencils.first_row[state];
        for (; row + group <= stencils.first_row[state + 1]; row += group)
            for (std::size_t r = 0; r < group; ++r)
                for (std::size_t k = 0; k < width; ++k)
                    result[row * width + k * group + r] = static_cast<Scalar>(stencils.weights[(row + r) * width + k]);
    }
    return result;
}

struct Task {
    std::size_t first_cell;
    std::size_t last_cell;
    std::size_t first_point; ///< place of the first point in the output
    std::size_t last_point;  ///< place behind the last one
};

/// Runs of cells that write about `grain` points each; the first ones, as many as there are trials, `trial_grain`:
/// where they try nothing, they are but shorter.
template<typename State>
std::vector<Task> tasks_of(const FusedStencils& stencils, const State* states, std::size_t cells, std::size_t grain,
                           std::size_t trial_grain) {
    assert(cells > 0 && grain > 0 && trial_grain > 0);
    std::vector<Task> tasks;
    std::size_t point = 0;
    Task task{0, 0, 0, 0};
    for (std::size_t cell = 0; cell < cells; ++cell) {
        point += stencils.rows(states[cell]);
        const std::size_t wanted = tasks.size() < 2 * trials ? trial_grain : grain;
        if (point - task.first_point < wanted && cell + 1 < cells) continue;
        task.last_cell = cell + 1;
        task.last_point = point;
        tasks.push_back(task);
        task = {cell + 1, 0, point, 0};
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
        assert(stencils.first_row.size() == stencils.offset.size() + 1);
        assert(stencils.weights.size() == stencils.row_count() * stencils.width);
        copy_ends();
    }

    void run(Scalar* out, const ApplyOptions& options) {
        const std::size_t dimension = parents_.dimension;
        assert(dimension > 0);
        const std::size_t point_bytes = dimension * sizeof(Scalar);
        const std::size_t grain = std::max<std::size_t>(1, options.grain / dimension);
        const std::size_t trial_grain = std::clamp<std::size_t>(trial_bytes / point_bytes, 1, grain);
        const std::vector<Task> tasks = tasks_of(stencils_, states_, cells_, grain, trial_grain);
        const bool measures =
            options.stores == Stores::Measured && tasks.back().last_point * point_bytes >= measured_bytes;
        const Kernels<Scalar> kernels = internode::kernels<Scalar>(options.isa, stencils_.width, dimension);
        arrange_weights(kernels.group, tasks.back().last_point);
        const auto run_task = [&](const Task& task, Store store) {
            Scalar* const place = out + task.first_point * dimension;
            if (store == Store::Streamed && point_bytes <= staged_point_bytes)
                run_staged(task, kernels.staged, place);
            else
                run_cells(task, kernels.direct, place, store);
        };
        const std::size_t tried = measures ? std::min(2 * trials, tasks.size()) : 0;
        const Store store = tried > 0 ? faster_store(std::span(tasks).first(tried), options, run_task)
                            : options.stores == Stores::Streamed ? Store::Streamed
                                                                 : Store::Cached;
        for_each_task(tasks.size() - tried, options.threads,
                      [&](std::size_t task) { run_task(tasks[tried + task], store); });
    }

private:
    void arrange_weights(std::size_t group, std::size_t points) {
        if (points / points_to_group < stencils_.row_count()) group = 1;
        if (group > 1) group_shift_ = std::countr_zero(group);
        if constexpr (std::is_same_v<Scalar, double>) {
            weights_ = stencils_.weights.data();
            if (group == 1) return;
        }
        own_weights_ = arranged<Scalar>(stencils_, group);
        weights_ = own_weights_.data();
    }

    /// Runs the tasks in the order cached, streamed, streamed, cached, … and tells whose fastest one was faster.
    template<typename RunTask>
    [[nodiscard]] static Store faster_store(std::span<const Task> tasks, const ApplyOptions& options,
                                            const RunTask& run_task) {
        using Clock = std::chrono::steady_clock;
        using Seconds = std::chrono::duration<double>;
        const auto store_of = [](std::size_t task) {
            return (task + 1) / 2 % 2 == 0 ? Store::Cached : Store::Streamed;
        };
        std::vector<double> times(tasks.size()); // of a point
        for_each_task(tasks.size(), options.threads, [&](std::size_t task) {
            const Clock::time_point start = Clock::now();
            run_task(tasks[task], store_of(task));
            const auto points = static_cast<double>(tasks[task].last_point - tasks[task].first_point);
            times[task] = Seconds(Clock::now() - start).count() / std::max(points, 1.0);
        });
        double cached = std::numeric_limits<double>::max();
        double streamed = cached;
        for (std::size_t task = 0; task < tasks.size(); ++task) {
            double& least = store_of(task) == Store::Cached ? cached : streamed;
            least = std::min(least, times[task]);
        }
        return streamed < sure * cached ? Store::Streamed : Store::Cached;
    }

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

    /// The same by way of a stage that all batches of the task share.
    void run_staged(const Task& task, StagedKernel<Scalar> kernel, Scalar* out) const {
        LineStage<Scalar> stage;
        LineWriter<Scalar> writer(stage, out);
        CellWork<Scalar> work[batch];
        for (std::size_t first = task.first_cell; first < task.last_cell; first += batch) {
            const std::size_t last = std::min(first + batch, task.last_cell);
            for (std::size_t cell = first; cell < last; ++cell) work[cell - first] = describe(cell);
            kernel(work, last - first, parents_.dimension, writer);
        }
        writer.finish();
    }

    [[nodiscard]] CellWork<Scalar> describe(std::size_t cell) const {
        const State state = states_[cell];
        const std::size_t rows = stencils_.rows(state);
        return {parents_of(cell, state), weights_ + stencils_.first_row[state] * stencils_.width, rows,
                group_shift_ > 0 ? rows >> static_cast<unsigned>(group_shift_) : 0};
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
    const Scalar* weights_ = nullptr;
    std::vector<Scalar> own_weights_; ///< where the kernel wants others than the table has
    int group_shift_ = 0;             ///< a group has two to so many rows; 0: there are none
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
