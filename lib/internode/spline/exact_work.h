// SPDX-License-Identifier: MIT
//
// What exact rows cost, counted before the first one is derived.
//
// A piece of degree d costs d (d+1) / 2 divisions in K = Q(ρ), a row of weights as many steps of the blossom
// (spline/blossom.h). A step is worth 8 + n units where K has degree n: measured on fields of degree 2 to 12, a unit
// is about 0.3 µs, and the size of the coefficients counts for little. The budget is about half a minute.

#pragma once

#include "internode/interval/interval_system.h"
#include "internode/text/limits.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace internode {

/// Units of exact work in one table of masks or one automaton.
inline constexpr std::uint64_t max_table_work = 100'000'000;

/// More exact work than the budget.
class TooMuchWork : public LimitExceeded {
public:
    using LimitExceeded::LimitExceeded;
};

/// What a table of exact rows may cost.
struct ExactLimits {
    /// So many words, windows or states, and the budget.
    ExactLimits(std::size_t most_entries)
        : entries(most_entries) {}
    std::size_t entries;
    std::uint64_t work = max_table_work;
    std::function<void(std::uint64_t)> announce; ///< called with the work before it starts, when there is one
};

/// How many pieces and rows are to be derived.
struct ExactCounts {
    std::uint64_t pieces = 0;
    std::uint64_t rows = 0;
};

/// The units of that work; saturated.
[[nodiscard]] std::uint64_t exact_work(const IntervalSystem& system, int degree, const ExactCounts& counts);

/// Announces the work. \throw TooMuchWork beyond limits.work, with both numbers
void begin_exact_work(std::uint64_t work, const ExactLimits& limits);

} // namespace internode
