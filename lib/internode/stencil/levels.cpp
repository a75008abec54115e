// SPDX-License-Identifier: MIT

#include "internode/stencil/levels.h"

#include <cassert>
#include <stdexcept>

namespace internode {
namespace {

std::vector<bool> present(const std::vector<std::uint64_t>& cells_of) {
    std::vector<bool> result;
    result.reserve(cells_of.size());
    for (const std::uint64_t count : cells_of) result.push_back(count > 0);
    return result;
}

} // namespace

Levels levels_of(const CellAutomaton& automaton, const std::vector<std::uint32_t>& cells, int steps) {
    assert(steps >= 0);
    constexpr std::uint64_t most = std::uint64_t{1} << 62;
    std::vector<std::uint64_t> cells_of(automaton.state_count());
    for (const std::uint32_t state : cells) {
        assert(state < cells_of.size());
        ++cells_of[state];
    }
    Levels levels{{cells.size()}, {present(cells_of)}};
    for (int step = 0; step < steps; ++step) {
        std::vector<std::uint64_t> next(cells_of.size());
        std::uint64_t total = 0;
        for (std::uint32_t state = 0; state < cells_of.size(); ++state)
            for (const CellAutomaton::Child& child : automaton.children(state)) {
                next[child.state] += cells_of[state];
                total += cells_of[state];
                if (total > most) throw std::length_error("a refinement to more than 2^62 points");
            }
        cells_of = std::move(next);
        levels.sizes.push_back(total);
        levels.occupied.push_back(present(cells_of));
    }
    return levels;
}

} // namespace internode
