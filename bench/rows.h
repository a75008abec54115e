// SPDX-License-Identifier: MIT
//
// A row of the table: contestants that do the same work on the same input, measured in one process in turns.

#pragma once

#include "bench/cases.h"

#include <chrono>
#include <ctime>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace internode::bench {

struct Contestant {
    std::string name;
    double amount;                                             ///< of work in a run: points, bytes or multiply-adds
    std::size_t point_count;                                   ///< that a run writes, about
    std::function<double()> seconds;                           ///< a run; what precedes and follows it is not counted
    std::function<std::span<const double>()> points = nullptr; ///< of the last run; none: nothing to compare
};

struct Row {
    std::string name;
    std::function<std::vector<Contestant>(Scale)> make;
};

/// All rows of the table, in its order.
[[nodiscard]] std::vector<Row> all_rows();
[[nodiscard]] std::vector<Row> curve_rows();
[[nodiscard]] std::vector<Row> grid_rows();
[[nodiscard]] std::vector<Row> memory_rows();
[[nodiscard]] std::vector<Row> point_rows();
[[nodiscard]] std::vector<Row> text_rows();
/// Those that compare internode with itself.
[[nodiscard]] std::vector<Row> own_rows();

/// The largest difference between the points of contestants, relative to the largest coordinate; each has run before.
/// Infinite for different numbers of points.
[[nodiscard]] double disagreement(const std::vector<Contestant>& contestants);

/// What contestants may differ by.
inline constexpr double tolerance = 1e-9;

/// Processor time of this thread during a call, so that what else the machine does costs little; memory counts as read
/// and written around it.
template<typename Work>
double seconds_of(Work&& work) {
    const auto now = [] {
        std::timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    asm volatile("" ::: "memory");
    const double start = now();
    work();
    asm volatile("" ::: "memory");
    return now() - start;
}

/// Time on the wall, where several threads work.
template<typename Work>
double wall_seconds_of(Work&& work) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace internode::bench
