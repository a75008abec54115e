// SPDX-License-Identifier: MIT

#include "internode/stencil/cell_automaton.h"

#include <cassert>

namespace internode {

CellAutomaton::Support CellAutomaton::support(std::uint32_t row) const {
    assert(row < row_count());
    const std::span<const Number> weights = exact_weights(row);
    Support support{0, weights.size() - 1};
    while (support.first < support.last && weights[support.first].sign() == 0) ++support.first;
    while (support.last > support.first && weights[support.last].sign() == 0) --support.last;
    return support;
}

Number CellAutomaton::row_sum(std::uint32_t row) const {
    assert(row < row_count());
    Number sum;
    for (const Number& weight : exact_weights(row)) sum += weight;
    return sum;
}

} // namespace internode
