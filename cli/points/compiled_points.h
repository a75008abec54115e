// SPDX-License-Identifier: MIT
//
// The fast way of a point grammar: the cell automaton that it compiles to, at the speed of interval grammars.

#pragma once

#include "cli/arguments/options.h"
#include "cli/points/points.h"
#include "internode/point/compile/compile.h"

#include <cstdint>
#include <optional>
#include <string>

namespace internode::cli {

/// A compiled grammar with the points of its start word, in the order of its cells.
struct CompiledPoints {
    std::optional<CompiledGrammar> grammar; ///< none: `reason` says why
    std::string reason;                     ///< one line
    std::size_t dimension = 0;
    std::vector<double> points;
};

/// What can be compiled of this derivation: no phase, no chance, points of one dimension.
[[nodiscard]] CompiledPoints compiled_points(const LoadedPoints& loaded);

/// A plan has tables for its steps: of words that hardly grow, more cycles than this are cheaper module by module.
inline constexpr std::uint64_t max_compiled_cycles = 64;

/// The word after 1 … max_compiled_cycles cycles, before its interpretation; none when a coordinate leaves the range of
/// double: the interpreter then says where. \throw Failure (Refused) for more points than the modules allowed
[[nodiscard]] std::optional<ModuleWord> compiled_word(const CompiledPoints& compiled, const LoadedPoints& loaded,
                                                      std::uint64_t cycles, const CommonOptions& common);

} // namespace internode::cli
