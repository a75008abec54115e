// SPDX-License-Identifier: MIT
//
// The word after some cycles, the fast way where there is one: by the cell automaton that the grammar compiles to, else
// by the interpreter, which is the reference for both.

#pragma once

#include "internode/point/compile/compile.h"
#include "internode/point/interpreter.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace internode {

/// A plan has tables for its steps: of words that hardly grow, more cycles than this are cheaper module by module.
inline constexpr std::uint64_t max_compiled_cycles = 64;

/// What a derivation compiles to; a phase turns the ring, which no automaton does. \throw std::invalid_argument as
/// compile()
[[nodiscard]] Compilation compile_derivation(const PointSystem& system, StartWord start, const DeriveOptions& options);

/// A word with where it comes from: axiom_word() or input_word() of so many points.
struct DerivationStart {
    const ModuleWord& word;
    StartWord start;
};

struct FastOptions {
    DeriveOptions derive;
    ApplyOptions apply;            ///< how the automaton is applied
    bool interpreter_only = false; ///< the reference way
};

/// The size of a word that is larger than allowed.
struct TooLargeWord {
    CompiledGrammar::WordSize size;
    std::size_t dimension = 0; ///< coordinates of its points
};

struct FastDerivation {
    std::optional<ModuleWord> word; ///< before its interpretation; none: `problem` or `too_large` says why
    std::optional<DerivationProblem> problem;
    std::optional<TooLargeWord> too_large; ///< the size of a word beyond derive.max_modules
    /// Why the grammar does not compile, where that was asked for and the interpreter ran instead.
    std::optional<ExactStop> interpreted;
};

/// The word after `cycles` cycles. The interpreter also takes over after max_compiled_cycles, where no point is left,
/// and where a coordinate leaves the range of double: it says where. \throw std::invalid_argument as compile()
[[nodiscard]] FastDerivation derive_fast(const PointSystem& system, const DerivationStart& from, std::uint64_t cycles,
                                         const FastOptions& options = {});

} // namespace internode
