// SPDX-License-Identifier: MIT
//
// How many cells there are after 0, 1, … steps, and which states they have: counted, not rewritten.

#pragma once

#include "internode/stencil/cell_automaton.h"

#include <cstdint>
#include <vector>

namespace internode {

struct Levels {
    std::vector<std::uint64_t> sizes;        ///< steps + 1
    std::vector<std::vector<bool>> occupied; ///< whether each state occurs, for each level
};

/// From the states of the cells of a word. \throw std::length_error for more than 2^62 cells
[[nodiscard]] Levels levels_of(const CellAutomaton& automaton, const std::vector<std::uint32_t>& cells, int steps);

} // namespace internode
