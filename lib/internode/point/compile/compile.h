// SPDX-License-Identifier: MIT
//
// From a point grammar to a cell automaton: what the interpreter does with every word, decided once.
//
// A cell is a point of a module; it owns its module and the modules without points that follow it (before the first
// point of a word, those too). Its state is the piece of the word round it, W modules to each side, by letters and
// exact numbers. The grammar compiles when for some W the piece decides the pieces of the cell's children after one
// cycle: then letters, and with them rules, travel no faster than the word grows. Rows are exact; states that cannot be
// told apart are one. A step of the automaton is a cycle of the grammar; interpretation passes come after the last.
//
// Positions must be affine combinations of points. No piece decides where strict predecessors of several modules,
// branches, chance or queries come in. What does not compile runs in the interpreter, and the reason is a value.

#pragma once

#include "internode/point/compile/compiled_grammar.h"
#include "internode/point/compile/exact_word.h"
#include "internode/point/compile/start_cells.h"

#include <optional>
#include <vector>

namespace internode {

struct Compilation {
    std::optional<CompiledGrammar> compiled; ///< present iff reasons is empty
    std::vector<ExactStop> reasons;
};

/// \throw std::invalid_argument for no points, or an input or an axiom that the grammar does not have
[[nodiscard]] Compilation compile(const PointSystem& system, StartWord start, const CompileLimits& limits = {});

} // namespace internode
