// SPDX-License-Identifier: MIT
//
// A point grammar as a cell automaton, with the words that its cells stand for. Only compile() makes one
// (point/compile/compile.h).
//
// A cell is a point of a module; it owns its module and the modules without points that follow it (before the first
// point of a word, those too). A step of the automaton is a cycle of the grammar. Rows of several cycles are products
// of rows of one, in 106 bits and rounded once; for them a cell knows the rows of its neighbours.

#pragma once

#include "internode/point/compile/module_kind.h"
#include "internode/point/module_word.h"
#include "internode/stencil/cell_rules.h"
#include "internode/stencil/fused_stencils.h"
#include "internode/stencil/plan.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace internode {

class CompiledGrammar {
public:
    /// With exact rows; one step is one cycle.
    [[nodiscard]] const CellAutomaton& automaton() const { return *automaton_; }
    /// The same as a plain value.
    [[nodiscard]] const CellRules& rules() const { return rules_; }
    /// The state of each cell of the start word.
    [[nodiscard]] const std::vector<std::uint32_t>& cells() const { return cells_; }
    /// The state of a cell in the middle of a word of many points.
    [[nodiscard]] std::optional<std::uint32_t> interior() const { return interior_; }

    /// `cycles` >= 1 cycles at once, in 106 bits and rounded once; one cycle takes the exact rows. None when rows would
    /// be wider than a kernel takes.
    [[nodiscard]] std::optional<FusedStencils> fuse(int cycles, const std::vector<bool>& wanted) const;

    /// Of the start word. \throw std::length_error for more than 2^62 points
    [[nodiscard]] RefinementPlan plan(int cycles, const PlanOptions& options = {}) const;

    /// The word whose cells have these states and these points, rows of `dimension` coordinates.
    [[nodiscard]] ModuleWord word(std::span<const std::uint32_t> states, std::span<const double> points,
                                  std::size_t dimension) const;

    /// How large the word is after `cycles` cycles: saturating at 2^62.
    struct WordSize {
        std::uint64_t points = 0;
        std::uint64_t modules = 0; ///< modules of the word, where points is not 0
        std::uint64_t numbers = 0; ///< numbers of all modules, without those of their points
    };
    [[nodiscard]] WordSize size(std::uint64_t cycles) const;

    /// The word after `cycles` cycles of a start word with these points (cell_points), before any interpretation. None
    /// when no point is left: modules without points belong to points, and only the interpreter knows them then.
    /// \throw std::invalid_argument for another number of points, std::length_error as plan()
    [[nodiscard]] std::optional<ModuleWord> derive(std::span<const double> points, std::size_t dimension, int cycles,
                                                   const ApplyOptions& options = {}) const;

private:
    friend class CompiledGrammarMaker;
    class Fusion;
    /// The rows of the cells round a child, over the parents round its cell.
    struct Surroundings {
        std::ptrdiff_t first = 0; ///< the first of the cells, relative to the child
        std::vector<CellRow> rows;
    };
    /// The modules that a cell owns.
    struct Emission {
        std::vector<std::uint32_t> kinds;
        std::size_t slot = 0; ///< which point of its module a cell is; only slot 0 owns modules
        friend bool operator==(const Emission&, const Emission&) = default;
    };

    std::shared_ptr<const CellAutomaton> automaton_;
    CellRules rules_;
    std::vector<std::vector<Surroundings>> surroundings_; ///< per state, per child
    std::vector<Emission> emissions_;                     ///< per state
    std::vector<ModuleKind> kinds_;
    std::vector<std::vector<bool>> is_point_; ///< per kind, per parameter
    std::vector<std::uint32_t> cells_;
    std::optional<std::uint32_t> interior_;
    std::size_t fused_width_ = 2; ///< weights in a row of any number of cycles, at most
};

/// The points of all modules of a word, one after the other: those of its cells.
[[nodiscard]] std::vector<double> cell_points(const ModuleWord& word, const PointSystem& system);

} // namespace internode
