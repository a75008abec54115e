// SPDX-License-Identifier: MIT
//
// Random numbers without a state: each draw depends on its key alone, so draws may be made in any order.
//
// The mixing function of splitmix64 (Steele, Lea, Flood, Fast splittable pseudorandom number generators, OOPSLA 2014),
// once for each part of the key.

#pragma once

#include <cstdint>

namespace internode {

[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

/// Uniform in [0, 1), a multiple of 2^-53.
[[nodiscard]] constexpr double uniform_draw(std::uint64_t seed, std::uint64_t step, std::uint64_t position) {
    const std::uint64_t bits = mix_bits(mix_bits(mix_bits(seed) ^ step) ^ position);
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

} // namespace internode
