// SPDX-License-Identifier: MIT
//
// Which states of an exploration cannot be told apart: by what they own, by their rows, and by the rows of the
// neighbours that their descendants depend on.

#pragma once

#include "internode/point/compile/exploration.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace internode {

/// Which cells round a cell its descendants depend on, relative to the cell.
struct Reach {
    std::ptrdiff_t first = 0;
    std::ptrdiff_t last = 0;
    friend bool operator==(const Reach&, const Reach&) = default;
};

/// One per state: the least fixed point. Cost: quadratic in the states at most.
[[nodiscard]] std::vector<Reach> reaches(const std::vector<ExploredState>& states);

/// The modules that the cell of a state owns.
struct Emission {
    std::vector<std::uint32_t> kinds;
    std::size_t slot = 0; ///< which point of its module the cell is; only slot 0 owns modules
    friend auto operator<=>(const Emission&, const Emission&) = default;
};

[[nodiscard]] std::vector<Emission> emissions(const Exploration& exploration);

/// The children of every state with the rows that they have of their own.
[[nodiscard]] CellRules own_rules(const std::vector<ExploredState>& states);

/// The class of each state, numbered in the order of the first state of each.
[[nodiscard]] std::vector<std::uint32_t> classes(const std::vector<ExploredState>& states,
                                                 const std::vector<Reach>& reach,
                                                 const std::vector<Emission>& emissions);

} // namespace internode
