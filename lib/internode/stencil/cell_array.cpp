// SPDX-License-Identifier: MIT

#include "internode/stencil/cell_array.h"

#include <algorithm>
#include <cassert>

namespace internode {
namespace {

template<typename State>
std::vector<State> narrowed(const std::vector<std::uint32_t>& states) {
    assert(std::ranges::all_of(states, [](std::uint32_t state) { return static_cast<State>(state) == state; }));
    std::vector<State> result(states.size());
    std::ranges::transform(states, result.begin(), [](std::uint32_t state) { return static_cast<State>(state); });
    return result;
}

template<typename State>
std::vector<State> descendants(const std::vector<State>& states, const FusedStencils& stencils, std::uint64_t count) {
    const std::vector<State> table = narrowed<State>(stencils.descendants);
    std::vector<State> result(count);
    State* next = result.data();
    for (const State state : states)
        next = std::copy(table.data() + stencils.first_row[state],
                         table.data() + stencils.first_row[std::size_t{state} + 1], next);
    assert(next == result.data() + result.size());
    return result;
}

} // namespace

std::size_t CellArray::bytes_for(std::size_t state_count) {
    if (state_count <= 0x100) return 1;
    return state_count <= 0x10000 ? 2 : 4;
}

CellArray::CellArray(const std::vector<std::uint32_t>& states, std::size_t state_count) {
    assert(std::ranges::all_of(states, [&](std::uint32_t state) { return state < state_count; }));
    switch (bytes_for(state_count)) {
    case 1:
        states_ = narrowed<std::uint8_t>(states);
        break;
    case 2:
        states_ = narrowed<std::uint16_t>(states);
        break;
    default:
        states_ = states;
    }
}

CellArray CellArray::refined(const FusedStencils& stencils, std::uint64_t count) const {
    CellArray result;
    std::visit([&](const auto& states) { result.states_ = descendants(states, stencils, count); }, states_);
    return result;
}

std::size_t CellArray::size() const {
    return std::visit([](const auto& states) { return states.size(); }, states_);
}

std::size_t CellArray::bytes_per_cell() const {
    return std::visit([](const auto& states) { return sizeof states[0]; }, states_);
}

} // namespace internode
