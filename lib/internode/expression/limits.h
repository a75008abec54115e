// SPDX-License-Identifier: MIT
//
// What expressions may cost at most. `internode limits` prints these numbers among those of point grammars
// (point/limits.h).

#pragma once

#include <cstddef>
#include <cstdint>

namespace internode {

/// Numerator and denominator of a number that is known before a word is, together: twice what the longest literal
/// needs. Beyond, it goes on as a double, so that exact work stays bounded by the text.
inline constexpr std::size_t max_known_bits = 8192;

/// Operations of one expression with its calls written out (a function that calls another twice doubles its cost), and
/// of all constants together.
inline constexpr std::uint64_t max_expression_operations = 1'000'000;
inline constexpr std::uint64_t max_constant_operations = 100'000;

} // namespace internode
