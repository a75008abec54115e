// SPDX-License-Identifier: MIT
//
// The cell automaton: the common currency of everything one-dimensional.
//
// A scheme on a line is a finite automaton over *cells*, one per control point. A step turns every cell into the cells
// of its state's children, and each child carries one row of weights over consecutive parents:
//
//     state -> sequence of (child state, row of `width` weights over the parents at cell + offset … + width - 1)
//
// A cell may have no children. What a state stands for is known to whoever made the automaton: a window of intervals
// (stencil/automaton.h), or the modules round a point (point/compile/compile.h). Kernels, plans and exports need no
// more.

#pragma once

#include "internode/algebra/number.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace internode {

class CellAutomaton {
public:
    struct Child {
        std::uint32_t state; ///< state of the new cell
        std::uint32_t row;   ///< index of its weights; 0 without rows
        friend bool operator==(const Child&, const Child&) = default;
    };

    /// The weights in a row.
    [[nodiscard]] std::size_t width() const { return width_; }
    [[nodiscard]] std::size_t state_count() const { return offset_.size(); }
    /// 0 when it was made without rows.
    [[nodiscard]] std::size_t row_count() const { return weights_.size() / width(); }
    [[nodiscard]] std::span<const Child> children(std::uint32_t state) const {
        return {children_.data() + first_child_[state], first_child_[state + 1] - first_child_[state]};
    }
    /// Position of the first parent relative to the cell.
    [[nodiscard]] std::ptrdiff_t offset(std::uint32_t state) const { return offset_[state]; }
    /// The weights of a row, each the nearest double to the exact one.
    [[nodiscard]] std::span<const double> weights(std::uint32_t row) const {
        return {weights_.data() + row * width(), width()};
    }
    [[nodiscard]] std::span<const Number> exact_weights(std::uint32_t row) const {
        return {exact_.data() + row * width(), width()};
    }
    /// The part of a row between its outer zeros: weights first … last are enough, 0 <= first <= last < width. Parent i
    /// of the row is the one at cell + offset(state) + i.
    struct Support {
        std::size_t first;
        std::size_t last;
    };
    [[nodiscard]] Support support(std::uint32_t row) const;
    /// The exact sum of a row: 1, by affine invariance.
    [[nodiscard]] Number row_sum(std::uint32_t row) const;

protected:
    friend class CellAutomatonBuilder;
    std::size_t width_ = 2;
    std::vector<std::int32_t> offset_;     ///< place of the first parent relative to the cell, for each state
    std::vector<std::size_t> first_child_; ///< state_count() + 1
    std::vector<Child> children_;
    std::vector<Number> exact_;   ///< row_count() * width()
    std::vector<double> weights_; ///< the same, rounded
};

} // namespace internode
