// SPDX-License-Identifier: MIT

#include "internode/stencil/cell_mask.h"

#include "internode/stencil/automaton.h"

#include <cassert>
#include <map>
#include <stdexcept>

namespace internode {
namespace {

/// The rows of the children as one sequence: p'_{m i + c} = Σ_t w_t p_{i + first + t} has its weights at the indices
/// c - m (first + t).
std::map<std::ptrdiff_t, Rational> coefficients(const std::vector<CellChild>& children) {
    const NumberField rationals;
    const auto arity = static_cast<std::ptrdiff_t>(children.size());
    std::map<std::ptrdiff_t, Rational> all;
    for (std::ptrdiff_t c = 0; c < arity; ++c) {
        const CellRow& row = children[static_cast<std::size_t>(c)].row;
        for (std::size_t t = 0; t < row.weights.size(); ++t)
            if (row.weights[t].sign() != 0)
                all[c - arity * (row.first + static_cast<std::ptrdiff_t>(t))] =
                    row.weights[t].coefficients(rationals).front();
    }
    return all;
}

} // namespace

std::optional<UniformMask> uniform_mask(const std::vector<CellChild>& children) {
    const std::map<std::ptrdiff_t, Rational> all = coefficients(children);
    if (all.empty()) return std::nullopt;
    assert(all.begin()->second != 0 && all.rbegin()->second != 0);
    UniformMask mask{children.size(), all.begin()->first, {}};
    mask.coefficients.resize(static_cast<std::size_t>(all.rbegin()->first - mask.first) + 1);
    for (const auto& [index, weight] : all) mask.coefficients[static_cast<std::size_t>(index - mask.first)] = weight;
    return mask;
}

std::optional<UniformMask> uniform_mask(const IntervalSystem& system, int degree) {
    if (degree < 1) throw std::invalid_argument("a mask of degree below 1");
    if (system.alphabet().size() != 1) return std::nullopt;
    const CellState state{.window = Word(2 * static_cast<std::size_t>(degree) - 1, to_symbol(0)), .lead = 0};
    const StencilAutomaton automaton = make_automaton(system, degree, {state}, 1);
    return uniform_mask(rules_of(automaton)[automaton.find(state)]);
}

} // namespace internode
