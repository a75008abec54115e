// SPDX-License-Identifier: MIT

#include "internode/spline/exact_work.h"

#include <cassert>
#include <limits>
#include <string>

namespace internode {

namespace {

/// What a step costs beside the coefficients of its numbers.
constexpr std::uint64_t fixed_cost = 8;

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    return b != 0 && a > most / b ? most : a * b;
}

} // namespace

std::uint64_t exact_work(const IntervalSystem& system, int degree, const ExactCounts& counts) {
    assert(degree >= 1);
    const auto d = static_cast<std::uint64_t>(degree);
    const auto field = static_cast<std::uint64_t>(system.field().degree());
    assert(counts.rows <= std::numeric_limits<std::uint64_t>::max() - counts.pieces);
    return product(counts.pieces + counts.rows, product(d * (d + 1) / 2, fixed_cost + field));
}

void begin_exact_work(std::uint64_t work, const ExactLimits& limits) {
    if (work > limits.work)
        throw TooMuchWork("the exact weights need " + std::to_string(work) + " units of work, more than the limit of " +
                          std::to_string(limits.work) + ": take a lower degree, or fewer words");
    if (limits.announce) limits.announce(work);
}

} // namespace internode
