// SPDX-License-Identifier: MIT
//
// k steps of a stencil automaton at once, in doubles: the automaton of σᵏ, laid out for the kernels.
//
// A point after k steps whose support starts in the old interval j is the blossom of the piece over j at d consecutive
// knots of the refined word. So it is a row of d+1 weights over v_{j-d} … v_j, whatever k is (docs/mathematics.md,
// section 2). Every new point is computed from the coarse ones directly and written once. One step takes the exact rows
// of the automaton; more are derived from lengths of 106 bits (algebra/double_double.h) and rounded once.

#pragma once

#include "internode/stencil/automaton.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace internode {

struct FusedStencils {
    int steps = 1;         ///< k
    std::size_t width = 2; ///< d + 1
    /// Per state, the first of its rows: state_count() + 1. A wanted state has one row per descendant after k steps.
    std::vector<std::uint32_t> first_row;
    std::vector<std::int32_t> offset;       ///< place of the first parent relative to the cell, for each state
    std::vector<double> weights;            ///< width a row
    std::vector<std::uint32_t> descendants; ///< state of the new cell, per row

    [[nodiscard]] std::size_t rows(std::uint32_t state) const { return first_row[state + 1] - first_row[state]; }
    [[nodiscard]] std::size_t row_count() const { return descendants.size(); }
};

/// Makes the tables of one automaton and the system that it is made from. The lengths are rounded once, when the first
/// table asks for them.
class IntervalFuser {
public:
    /// `system` must outlive this.
    IntervalFuser(std::shared_ptr<const StencilAutomaton> automaton, const IntervalSystem& system);

    /// The table of `steps` >= 1 steps for the states that are `wanted`: state_count() entries. One step takes the
    /// exact rows where the automaton has them. None when 106 bits do not suffice for rows that are right to a few
    /// units of 2^-60, because lengths side by side are too uneven; one step is always there.
    /// \throw std::invalid_argument for steps < 1, std::length_error beyond 2^32 - 1 rows
    [[nodiscard]] std::optional<FusedStencils> table(int steps, const std::vector<bool>& wanted);

private:
    struct Lengths; // of 106 bits
    class Rows;
    const Lengths& lengths();

    std::shared_ptr<const StencilAutomaton> automaton_;
    const IntervalSystem& system_;
    std::shared_ptr<const Lengths> lengths_; ///< none before they are asked for
};

} // namespace internode
