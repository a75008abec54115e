// SPDX-License-Identifier: MIT
//
// What a point system and its words may be at most, beside the limits of its text (grammar/lexing/limits.h), of
// its expressions (expression/limits.h) and of its polygon (io/file/limits.h). A refusal names its number.

#pragma once

#include "internode/expression/limits.h"
#include "internode/text/limits.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace internode {

inline constexpr std::uint64_t max_cycle_steps = 100'000;

/// Each table lists its rules by letter, those that stand before the first table too.
inline constexpr std::size_t max_table_entries = 1'000'000;

/// A word may hold so many numbers for each module that is allowed: 64 coordinates in every module of ten million would
/// not fit in memory.
inline constexpr std::uint64_t values_per_module = 16;

inline constexpr std::uint64_t default_max_modules = 10'000'000;

/// Letters compared and numbers computed, all steps together: contexts of a thousand modules against a word of 10^7
/// would take hours a step.
inline constexpr std::uint64_t default_max_work = 20'000'000'000;

/// Modules, terms and words of 64 bits that are written when a matrix is derived without rounding.
inline constexpr std::uint64_t max_exact_work = 4'000'000;

/// Of compiling: modules to each side of a cell, states, and the same count as above.
inline constexpr std::size_t max_compiled_side = 64;
inline constexpr std::size_t max_compiled_states = 4'096;
inline constexpr std::uint64_t max_compile_work = 1'000'000;

inline constexpr std::array<Limit, 12> point_limits{{
    {"exact constant (beyond: nearest double)", max_known_bits, "bits"},
    {"operations of an expression, its calls written out", max_expression_operations, "operations"},
    {"operations of all constants, calls written out", max_constant_operations, "operations"},
    {"derivation steps of a cycle", max_cycle_steps, "steps"},
    {"tables times rules and letters", max_table_entries, "entries"},
    {"modules of a derived word (--max-modules)", default_max_modules, "modules"},
    {"numbers of a derived word, for each of --max-modules", values_per_module, "numbers"},
    {"letters compared and numbers computed in a derivation", default_max_work, "operations"},
    {"exact matrix of a cycle", max_exact_work, "modules, terms and words of 64 bits"},
    {"compiled grammar: modules to each side of a point", max_compiled_side, "modules"},
    {"compiled grammar: states", max_compiled_states, "states"},
    {"compiling (beyond: the interpreter runs)", max_compile_work, "modules, terms and words of 64 bits"},
}};

} // namespace internode
