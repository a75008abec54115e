// SPDX-License-Identifier: MIT

#include "internode/curve/reverse/hierarchy.h"

#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

/// The weights between the first and the last that is not 0, and where they start.
GatherRow trimmed(std::ptrdiff_t first, std::span<const double> weights) {
    assert(!weights.empty());
    while (weights.size() > 1 && weights.front() == 0) {
        weights = weights.subspan(1);
        ++first;
    }
    while (weights.size() > 1 && weights.back() == 0) weights = weights.first(weights.size() - 1);
    return {first, weights};
}

std::vector<std::uint32_t> children_of(const StencilAutomaton& automaton, const std::vector<std::uint32_t>& states) {
    std::vector<std::uint32_t> next;
    next.reserve(states.size());
    for (const std::uint32_t state : states)
        for (const StencilAutomaton::Child& child : automaton.children(state)) next.push_back(child.state);
    return next;
}

} // namespace

Hierarchy::Hierarchy(Knots coarse, int levels)
    : coarse_(std::move(coarse)) {
    if (levels < 0) throw std::invalid_argument("a negative number of levels");
    NumberedCells start = numbered_cells(coarse_.word(), coarse_.degree(), coarse_.ends());
    automaton_ = std::make_shared<const StencilAutomaton>(
        make_automaton(coarse_.system(), coarse_.degree(), start.states, max_states));
    states_.push_back(std::move(start.cells));
    for (int level = 0; level < levels; ++level) states_.push_back(children_of(*automaton_, states_.back()));
}

GatherMatrix Hierarchy::matrix(int level) const {
    const std::vector<std::uint32_t>& cells = states(level);
    GatherMatrix matrix;
    matrix.ends = coarse_.ends();
    matrix.columns = cells.size();
    matrix.rows.reserve(size(level + 1));
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(cell) + automaton_->offset(cells[cell]);
        for (const StencilAutomaton::Child& child : automaton_->children(cells[cell]))
            matrix.rows.push_back(trimmed(first, automaton_->weights(child.row)));
    }
    assert(matrix.rows.size() == size(level + 1));
    return matrix;
}

} // namespace internode
