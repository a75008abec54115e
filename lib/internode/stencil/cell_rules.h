// SPDX-License-Identifier: MIT
//
// A cell automaton while it is being made or compared: states with their children and exact rows, as a plain value.
//
// Two automata are the same scheme when their normal forms are equal. In these, states that cannot be told apart are
// one (the coarsest partition, Moore 1956) and states are numbered as they are met from the start. Rows have no zeros
// at their ends, and parents are counted from the first parent of the first row, for which a constant says nothing.

#pragma once

#include "internode/algebra/number.h"
#include "internode/stencil/cell_automaton.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace internode {

/// Weights over consecutive parents, the first of them at cell + first; neither the first nor the last weight is zero.
/// No weights: a point that depends on nothing.
struct CellRow {
    std::ptrdiff_t first = 0;
    std::vector<Number> weights;
    friend bool operator==(const CellRow&, const CellRow&) = default;
};

struct CellChild {
    std::uint32_t state = 0;
    CellRow row;
    friend bool operator==(const CellChild&, const CellChild&) = default;
};

/// The children of each state.
using CellRules = std::vector<std::vector<CellChild>>;

/// The row without zeros at its ends.
[[nodiscard]] CellRow trimmed(CellRow row);

/// The automaton with these states. Its width is the least, but 2, that holds every row of a state at one offset.
/// \throw std::invalid_argument for a child without a state
[[nodiscard]] CellAutomaton make_cell_automaton(const CellRules& rules);

/// The states, children and rows of an automaton that has rows.
[[nodiscard]] CellRules rules_of(const CellAutomaton& automaton);

/// For each state the number of its class: the coarsest partition in which states of one class have the same color and,
/// child by child, equal labels and children of one class. `labels` has one entry per child, state by state; without
/// colors all are the same. Classes are numbered by their first states.
[[nodiscard]] std::vector<std::uint32_t> equivalent_states(const CellRules& rules,
                                                           std::span<const std::uint32_t> labels,
                                                           std::span<const std::uint32_t> colors = {});

/// For each child, state by state, the number of its row among the different rows.
[[nodiscard]] std::vector<std::uint32_t> row_labels(const CellRules& rules);

/// The normal form of what is reached from `start`: equal for automata that are the same scheme.
struct NormalForm {
    CellRules rules;
    std::vector<std::uint32_t> start; ///< the class of each start state
    friend bool operator==(const NormalForm&, const NormalForm&) = default;
};
[[nodiscard]] NormalForm normal_form(const CellRules& rules, std::span<const std::uint32_t> start);

} // namespace internode
