// SPDX-License-Identifier: MIT
//
// The stencil automaton of an interval system: a cell automaton (stencil/cell_automaton.h) whose states are windows.
//
// A *cell* is a control point together with the leftmost interval of its support; cells and points are equal in
// number and order. The state of a cell is (window of 2d-1 letters around the first non-empty interval j at or right of
// the cell, z = how many cells the cell lies left of j). A step turns every cell into the cells of its state's
// children:
//
//     state -> sequence of (child state, row of d+1 weights over the parents at cell + offset … cell + offset + d)
//
// z = 0: a child per letter of the rule of j, offset -d. z >= 1 (an empty interval, or a point that starts left of an
// open domain): one child with z again, offset z - d. Ends are states: a kernel has no special case for them.

#pragma once

#include "internode/interval/interval_system.h"
#include "internode/spline/exact_work.h"
#include "internode/stencil/cell_automaton.h"
#include "internode/text/limits.h"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace internode {

struct CellState {
    Word window;            ///< 2d - 1 letters
    std::uint32_t lead = 0; ///< z, 0 … d
    friend bool operator==(const CellState&, const CellState&) = default;
};

/// What an automaton may hold by default: a million windows of degree 12 are some gigabytes of exact rows.
inline constexpr std::size_t max_states = 1'000'000;

/// More states than allowed.
class TooManyStates : public LimitExceeded {
public:
    using LimitExceeded::LimitExceeded;
};

/// Whether an automaton has its weights, which are nearly all of its cost, or states and children alone.
enum class AutomatonRows { Exact, None };

class StencilAutomaton : public CellAutomaton {
public:
    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] const CellState& state(std::uint32_t state) const { return states_[state]; }
    /// How many different windows the states have.
    [[nodiscard]] std::size_t window_count() const { return index_.size(); }
    /// The state of that window and lead. \throw std::out_of_range when the automaton does not have it
    [[nodiscard]] std::uint32_t find(const CellState& state) const;

private:
    friend class AutomatonBuilder;
    int degree_ = 1;
    std::vector<CellState> states_;
    std::unordered_map<Word, std::vector<std::uint32_t>, WordHash> index_; ///< states of a window
};

/// The automaton that holds `start` and everything it leads to. degree 1 … 12; every window 2d-1 letters with a
/// non-empty middle. \throw TooManyStates and TooMuchWork beyond the limits, std::invalid_argument
[[nodiscard]] StencilAutomaton make_automaton(const IntervalSystem& system, int degree,
                                              const std::vector<CellState>& start, const ExactLimits& limits,
                                              AutomatonRows rows = AutomatonRows::Exact);

/// The states of the cells of a word: N when circular; N when the word is open and has N + d letters, the first d cells
/// leading the domain. \throw std::invalid_argument for a word that is too short, a domain that begins or ends with
/// `0`, more than d zeros in a row (curve/curve.h says it with numbers)
[[nodiscard]] std::vector<CellState> cell_states(WordView word, int degree, Ends ends);

/// The states of a word's cells, each once, as make_automaton() numbers them when it starts from these.
struct NumberedCells {
    std::vector<CellState> states;    ///< in the order in which they first stand in the word
    std::vector<std::uint32_t> cells; ///< the number of each cell's state
};

/// Of the same words, with the same exceptions; 4 bytes a cell where cell_states() takes a window.
[[nodiscard]] NumberedCells numbered_cells(WordView word, int degree, Ends ends);

} // namespace internode
