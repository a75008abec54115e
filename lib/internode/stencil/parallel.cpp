// SPDX-License-Identifier: MIT

#include "internode/stencil/parallel.h"

#include <algorithm>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace internode {
namespace {

/// Never more than oneTBB allows: it would print a warning.
int concurrency(int threads) {
    const auto most = static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    return threads == 0 ? most : std::min(threads, most);
}

} // namespace

void for_each_task(std::size_t count, int threads, const std::function<void(std::size_t)>& task) {
    if (threads == 1 || count <= 1) {
        for (std::size_t i = 0; i < count; ++i) task(i);
        return;
    }
    tbb::task_arena arena(concurrency(threads));
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, task); });
}

} // namespace internode
