// SPDX-License-Identifier: MIT
//
// A state whose cell depends on neighbours is more than its own rows: k cycles multiply the rows of neighbours too. So
// a child is labelled by all rows over the cells that its descendants reach, and states are classes of the coarsest
// partition in which children agree in label and class (stencil/cell_rules.h).

#include "internode/point/compile/state_classes.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace internode {
namespace {

bool widen(Reach& reach, const Reach& of_child, const PieceChild& child) {
    const Reach before = reach;
    for (std::ptrdiff_t cell = of_child.first; cell <= of_child.last; ++cell) {
        assert(cell >= child.first && static_cast<std::size_t>(cell - child.first) < child.rows.size());
        const CellRow& row = child.rows[static_cast<std::size_t>(cell - child.first)];
        if (row.weights.empty()) continue;
        reach.first = std::min(reach.first, row.first);
        reach.last = std::max(reach.last, row.first + static_cast<std::ptrdiff_t>(row.weights.size()) - 1);
    }
    return !(before == reach);
}

CellRow own_row(const PieceChild& child) {
    assert(child.first <= 0 && static_cast<std::size_t>(-child.first) < child.rows.size());
    return trimmed(child.rows[static_cast<std::size_t>(-child.first)]);
}

Emission emission_of(const CellPiece& piece, const KindTable& kinds) {
    Emission emission{{}, piece.slot};
    if (piece.slot > 0) return emission;
    const OwnModules own = own_modules(piece, kinds).value();
    emission.kinds.assign(piece.kinds.begin() + static_cast<std::ptrdiff_t>(own.first),
                          piece.kinds.begin() + static_cast<std::ptrdiff_t>(own.last));
    return emission;
}

/// Equal colours for equal emissions.
std::vector<std::uint32_t> colors(const std::vector<Emission>& emissions) {
    std::map<Emission, std::uint32_t> numbers;
    std::vector<std::uint32_t> colors;
    for (const Emission& emission : emissions)
        colors.push_back(numbers.try_emplace(emission, static_cast<std::uint32_t>(numbers.size())).first->second);
    return colors;
}

/// Children with equal labels have equal rows, and equal rows of the cells that their descendants depend on.
std::vector<std::uint32_t> child_labels(const std::vector<ExploredState>& states, const std::vector<Reach>& reach) {
    CellRules all(1); // every row in question, as children of one state
    std::vector<std::vector<std::ptrdiff_t>> spans;
    for (const ExploredState& state : states)
        for (std::size_t c = 0; c < state.children.size(); ++c) {
            const PieceChild& child = state.children[c];
            const Reach& of_child = reach[state.states[c]];
            spans.push_back({of_child.first, of_child.last});
            for (std::ptrdiff_t cell = of_child.first; cell <= of_child.last; ++cell)
                all[0].push_back({0, child.rows[static_cast<std::size_t>(cell - child.first)]});
        }
    const std::vector<std::uint32_t> rows = row_labels(all);
    std::map<std::pair<std::vector<std::ptrdiff_t>, std::vector<std::uint32_t>>, std::uint32_t> numbers;
    std::vector<std::uint32_t> labels;
    auto next = rows.begin();
    for (const std::vector<std::ptrdiff_t>& span : spans) {
        const auto end = next + (span[1] - span[0] + 1);
        labels.push_back(
            numbers
                .try_emplace({span, std::vector<std::uint32_t>(next, end)}, static_cast<std::uint32_t>(numbers.size()))
                .first->second);
        next = end;
    }
    return labels;
}

} // namespace

std::vector<Reach> reaches(const std::vector<ExploredState>& states) {
    std::vector<Reach> reach(states.size());
    for (bool changes = true; changes;) {
        changes = false;
        for (std::size_t i = 0; i < states.size(); ++i)
            for (std::size_t c = 0; c < states[i].children.size(); ++c)
                changes = widen(reach[i], reach[states[i].states[c]], states[i].children[c]) || changes;
    }
    return reach;
}

std::vector<Emission> emissions(const Exploration& exploration) {
    std::vector<Emission> emissions;
    for (const ExploredState& state : exploration.states)
        emissions.push_back(emission_of(state.piece, exploration.kinds));
    return emissions;
}

CellRules own_rules(const std::vector<ExploredState>& states) {
    CellRules rules;
    for (const ExploredState& state : states) {
        rules.emplace_back();
        for (std::size_t c = 0; c < state.children.size(); ++c)
            rules.back().push_back({state.states[c], own_row(state.children[c])});
    }
    return rules;
}

std::vector<std::uint32_t> classes(const std::vector<ExploredState>& states, const std::vector<Reach>& reach,
                                   const std::vector<Emission>& emissions) {
    assert(states.size() == reach.size() && states.size() == emissions.size());
    return equivalent_states(own_rules(states), child_labels(states, reach), colors(emissions));
}

} // namespace internode
