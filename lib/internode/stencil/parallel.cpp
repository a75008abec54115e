// SPDX-License-Identifier: MIT

#include "internode/stencil/parallel.h"

#include <algorithm>
#include <atomic>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#include <vector>

#if defined(__SANITIZE_THREAD__)
extern "C" void __tsan_acquire(void* place); // NOLINT(bugprone-reserved-identifier)
extern "C" void __tsan_release(void* place); // NOLINT(bugprone-reserved-identifier)
#endif

namespace internode {
namespace {

/// What oneTBB orders and ThreadSanitizer cannot see, because the library is not compiled for it: what came before
/// gives() is seen by what comes after takes(). Nothing where nothing watches (scripts/check-threads).
class Order {
public:
    void gives() {
#if defined(__SANITIZE_THREAD__)
        __tsan_release(this);
#endif
    }
    void takes() {
#if defined(__SANITIZE_THREAD__)
        __tsan_acquire(this);
#endif
    }
};
Order before_tasks; ///< of all calls: a task that looked for its own would be seen to look
Order after_tasks;

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
    const auto ordered = [&](std::size_t i) {
        before_tasks.takes();
        task(i);
        after_tasks.gives();
    };
    before_tasks.gives();
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, ordered); });
    after_tasks.takes();
}

bool for_each_text(std::size_t count, int threads, const std::function<std::string(std::size_t)>& make,
                   const std::function<bool(std::string_view)>& take) {
    if (threads == 1 || count <= 1) {
        for (std::size_t i = 0; i < count; ++i)
            if (!take(make(i))) return false;
        return true;
    }
    tbb::task_arena arena(concurrency(threads));
    const auto ahead = 2 * static_cast<std::size_t>(arena.max_concurrency());
    // Texts stand in slots and numbers travel: what is under way when an exception ends a pipeline is not destroyed.
    // At most `ahead` are under way, and they leave in order, so that a slot is empty when its turn comes again.
    std::vector<std::string> slots(ahead);
    std::atomic<bool> is_taken = true;
    std::size_t next = 0;
    const auto number = [&](tbb::flow_control& control) {
        if (next == count || !is_taken) control.stop();
        return next++;
    };
    const auto fill = [&](std::size_t i) {
        slots[i % ahead] = make(i);
        return i;
    };
    const auto pass = [&](std::size_t i) {
        if (is_taken && !take(slots[i % ahead])) is_taken = false;
    };
    arena.execute([&] {
        tbb::parallel_pipeline(ahead, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, number) &
                                          tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, fill) &
                                          tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, pass));
    });
    return is_taken;
}

} // namespace internode
