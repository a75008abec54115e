// SPDX-License-Identifier: MIT
//
// A stencil automaton on its way out, as JSON or as code, with the words it is for.
//
// Tables that know no word must serve all of a kind. A choice of windows gives the automaton of every closed, open and
// clamped word of at least 2d-1 intervals whose factors of 2d-1 letters are among the windows.

#pragma once

#include "internode/interval/decomposition_graph.h"
#include "internode/stencil/automaton.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace internode {

struct AutomatonExport {
    std::string name; ///< the grammar's, for people
    IntervalSystem system;
    std::string start; ///< "persistent" or "all": the words above; "axiom" or "word": one word and what it becomes
    StencilAutomaton automaton;
    std::uint64_t steps = 1; ///< steps of the grammar at once: `system` is a power of it (interval/interval_system.h)
};

/// The cells of the words above: each window with z = 0 … d, and every cell of 0^d window 0^d.
[[nodiscard]] std::vector<CellState> cells_of_windows(const std::vector<Word>& windows, int degree);

/// By the axiom where there is one (and `choice` is Default or Reachable), else by the persistent windows or by all.
/// \throw TooManyWords, TooManyStates, TooMuchWork beyond the limits; std::invalid_argument for a degree outside 1 …
/// 12, for Reachable without an axiom and for an axiom that does not fit the degree
[[nodiscard]] AutomatonExport export_automaton(const std::string& name, const IntervalSystem& system, int degree,
                                               WordChoice choice, const ExactLimits& limits);

/// By one word. \throw TooManyStates, TooMuchWork beyond the limits; std::invalid_argument as cell_states()
[[nodiscard]] AutomatonExport export_automaton(const std::string& name, const IntervalSystem& system, int degree,
                                               const Axiom& word, const ExactLimits& limits);

} // namespace internode
