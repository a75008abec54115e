// SPDX-License-Identifier: MIT
//
// Everything about refining by `steps` steps that does not depend on the points: derived once, applied to any polygon.
//
// The steps are cut into blocks of fused steps (stencil/fused_stencils.h) whose tables fit a cache. Each block reads
// the points of the block before and writes its own once, so the memory beside input and output is the input of the
// last block. Blocks depend on the word, the steps and the options, never on the machine. The bytes of the result are
// the same for any number of threads, any partition of the work and any instruction set (docs/promises.md, P9 and P10).
// Different blocks round differently, in the last bits.

#pragma once

#include "internode/stencil/automaton.h"
#include "internode/stencil/isa.h"
#include "internode/stencil/stores.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace internode {

class CellArray;
struct FusedStencils;

struct PlanOptions {
    std::size_t table_bytes =
        24 * 1024; ///< size of the weights of a block: with room to spare in a first cache of 32 KiB
    std::uint64_t points_per_row = 256; ///< points that a block writes for a row of its table to pay
    int most_fused_steps = 64;          ///< 1: step by step, with exact rows rounded once
    std::size_t state_limit = max_states;
};

struct ApplyOptions {
    int threads = 1;                  ///< 0: as many as the machine has
    Isa isa = Isa::Best;              ///< never changes the result
    std::size_t grain = 524288;       ///< coordinates that a task writes, about: less is not worth a thread
    Stores stores = Stores::Measured; ///< never changes the result
};

/// An automaton and the states of the cells of a word in it.
struct StartCells {
    std::shared_ptr<const StencilAutomaton> automaton; ///< without rows, unless options.most_fused_steps is 1
    std::vector<std::uint32_t> cells;
};

/// Of a word that fits the degree (stencil/automaton.h, cell_states). \throw std::invalid_argument, TooManyStates
[[nodiscard]] StartCells start_cells(const IntervalSystem& system, int degree, WordView word, Ends ends,
                                     const PlanOptions& options);

/// Makes the table of so many steps for the wanted states; none where it would not be precise (never for one step).
struct StepFuser {
    std::function<std::optional<FusedStencils>(int steps, const std::vector<bool>& wanted)> table;
    std::size_t width = 2; ///< weights in a row of several steps, at most
};

/// The rows of intervals, in 106 bits. `system` must outlive it.
[[nodiscard]] StepFuser interval_fuser(std::shared_ptr<const StencilAutomaton> automaton, const IntervalSystem& system);

class RefinementPlan {
public:
    /// Of any cell automaton; `fuser` is called here and not kept. \throw as below
    RefinementPlan(std::shared_ptr<const CellAutomaton> automaton, std::vector<std::uint32_t> cells, int steps,
                   const StepFuser& fuser, const PlanOptions& options = {});

    /// Of a word that fits the degree (stencil/automaton.h, cell_states) and steps >= 0.
    /// \throw std::invalid_argument, TooManyStates, std::length_error for more than 2^62 points
    RefinementPlan(const IntervalSystem& system, int degree, WordView word, Ends ends, int steps,
                   const PlanOptions& options = {});

    /// Of cells whose states in the automaton of the system are known already.
    RefinementPlan(const IntervalSystem& system, std::shared_ptr<const StencilAutomaton> automaton,
                   std::vector<std::uint32_t> cells, int steps, const PlanOptions& options = {});

    [[nodiscard]] int steps() const { return static_cast<int>(sizes_.size()) - 1; }
    /// Points after 0, 1, … steps().
    [[nodiscard]] const std::vector<std::uint64_t>& sizes() const { return sizes_; }
    [[nodiscard]] std::size_t input_size() const { return sizes_.front(); }
    [[nodiscard]] std::size_t output_size() const { return sizes_.back(); }
    /// How many steps each block does at once, first to last.
    [[nodiscard]] std::vector<int> blocks() const;
    /// Without rows, unless single steps were asked for or it was given.
    [[nodiscard]] const CellAutomaton& automaton() const { return *automaton_; }
    /// The state of each cell of the word.
    [[nodiscard]] const std::vector<std::uint32_t>& cells() const { return cells_; }
    /// The state of each cell after all steps.
    [[nodiscard]] std::vector<std::uint32_t> final_cells() const;
    /// Bytes that apply() needs beside input and output, for points of `dimension` coordinates of `scalar_bytes`.
    [[nodiscard]] std::uint64_t work_bytes(std::size_t dimension, std::size_t scalar_bytes) const;

    /// The refined points: `points` has input_size() rows of `dimension` coordinates, `out` output_size(). Scalar is
    /// double or float. \throw std::invalid_argument for other sizes
    template<typename Scalar>
    void apply(std::span<const Scalar> points, std::size_t dimension, std::span<Scalar> out,
               const ApplyOptions& options = {}) const;

    /// The same for `polygons` polygons over the same word, one after the other in both spans; they, not their points,
    /// are shared among the threads. \throw std::invalid_argument for other sizes
    template<typename Scalar>
    void apply_each(std::span<const Scalar> points, std::size_t polygons, std::size_t dimension, std::span<Scalar> out,
                    const ApplyOptions& options = {}) const;

private:
    RefinementPlan(const IntervalSystem& system, StartCells start, int steps, const PlanOptions& options);
    void choose_blocks(int steps, const StepFuser& fuser, const PlanOptions& options);

    struct Block {
        int first_step = 0;
        std::shared_ptr<const FusedStencils> stencils;
    };

    [[nodiscard]] std::uint64_t size_before(const Block& block) const {
        return sizes_[static_cast<std::size_t>(block.first_step)];
    }
    /// The states of the cells before each block.
    [[nodiscard]] std::vector<CellArray> block_cells() const;
    template<typename Scalar>
    void apply_blocks(const std::vector<CellArray>& cells, const Scalar* points, std::size_t dimension, Scalar* out,
                      const ApplyOptions& options) const;

    std::shared_ptr<const CellAutomaton> automaton_;
    std::vector<std::uint32_t> cells_; ///< state of each cell of the word
    std::vector<std::uint64_t> sizes_;
    std::vector<Block> blocks_;
};

} // namespace internode
