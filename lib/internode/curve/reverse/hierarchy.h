// SPDX-License-Identifier: MIT
//
// The nested spaces of a pyramid: the knots w_0 of the coarse polygon and those of its refinements σ(w_0), …, σ^n(w_0).
//
// Level 0 is the coarse one. Nothing but the coarse knots and n decide the hierarchy (docs/mathematics.md, "Steps
// backwards"); all levels share one stencil automaton, and a level is the list of the states of its cells: 4 bytes a
// point.

#pragma once

#include "internode/curve/knots.h"
#include "internode/curve/reverse/gather_matrix.h"
#include "internode/stencil/automaton.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace internode {

class Hierarchy {
public:
    /// `levels` >= 0 steps below the fine polygon. Sizes are the caller's care (refined_size). \throw TooManyStates,
    /// std::invalid_argument
    Hierarchy(Knots coarse, int levels);

    [[nodiscard]] const Knots& coarse() const { return coarse_; }
    [[nodiscard]] int levels() const { return static_cast<int>(states_.size()) - 1; }
    /// The points of a level, 0 … levels().
    [[nodiscard]] std::size_t size(int level) const { return states(level).size(); }
    /// P of the step from `level` to `level` + 1; its rows live as long as the hierarchy.
    [[nodiscard]] GatherMatrix matrix(int level) const;
    /// The state of each cell of a level.
    [[nodiscard]] const std::vector<std::uint32_t>& states(int level) const {
        return states_.at(static_cast<std::size_t>(level));
    }
    [[nodiscard]] const StencilAutomaton& automaton() const { return *automaton_; }

private:
    Knots coarse_;
    std::shared_ptr<const StencilAutomaton> automaton_;
    std::vector<std::vector<std::uint32_t>> states_;
};

} // namespace internode
