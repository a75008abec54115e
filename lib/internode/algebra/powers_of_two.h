// SPDX-License-Identifier: MIT
//
// Exponents of doubles by their bits: scaling by powers of two changes no digit and needs no library of functions.

#pragma once

#include <bit>
#include <cassert>
#include <cstdint>

namespace internode {

/// e of a positive normal number x with 2^e <= x < 2^(e+1).
[[nodiscard]] inline int exponent_of(double x) {
    const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52U);
    assert(biased > 0 && biased < 0x7ff);
    return biased - 1023;
}

/// x · 2^exponent, rounded at most once below the normal numbers, infinite beyond the largest.
[[nodiscard]] inline double times_power_of_two(double x, int exponent) {
    constexpr int step = 1000;
    for (; exponent > step; exponent -= step) x *= 0x1p1000;
    for (; exponent < -step; exponent += step) x *= 0x1p-1000;
    return x * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

} // namespace internode
