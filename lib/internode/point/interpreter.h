// SPDX-License-Identifier: MIT
//
// Derivation as the papers define it: parallel rewriting, the first rule that matches wins, no rule is the identity.
// The reference for everything that is faster. Cost of a step: linear in the word times the length of the contexts.
//
// Stochastic rules: when the first rule that matches has a weight, one of all matching rules with a weight (and a
// strict predecessor as long) is drawn, with probability in proportion to the weights; the draw depends on the seed,
// the step and the position alone. Query modules get their parameters from the environment before every step and every
// interpretation pass.
//
// Strict predecessors of several modules (pseudo-L-systems, S0 section 7) are found from left to right, from module
// `phase` of a ring on; a module that begins such a predecessor but is not rewritten is left over: a problem.

#pragma once

#include "internode/point/limits.h"
#include "internode/point/module_word.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace internode {

/// Fills the parameters of the query module at `position`; false: leave them as they are.
using Query = std::function<bool(const ModuleWord& word, std::size_t position, std::span<double> values)>;

struct DeriveOptions {
    std::uint64_t max_modules = default_max_modules;
    std::uint64_t max_work = default_max_work; ///< letters compared and numbers computed, all steps together
    std::uint64_t phase =
        0; ///< a ring is read from its module number `phase` on, in each cycle's first step; in an open
           ///< word the modules before it are out of reach of strict predecessors of several modules
    std::uint64_t seed = 0;
    Query query{};
};

/// Why a derivation ended early: the place of the rule and what happened, with its numbers.
struct DerivationProblem {
    SourcePlace place; ///< of the rule or the expression; bytes 0 when the whole grammar is meant
    std::string message;
    std::string hint;
};

struct Derivation {
    ModuleWord word; ///< the last whole word
    std::optional<DerivationProblem> problem;
    std::uint64_t work = 0; ///< letters compared and numbers computed
};

/// One derivation step: step number `step` (from 0) of the whole derivation, which decides the table.
[[nodiscard]] Derivation derive_step(const PointSystem& system, const ModuleWord& word, std::uint64_t step,
                                     const DeriveOptions& options = {});

/// `cycles` whole cycles. A word that would exceed options.max_modules is refused with the length it would have: before
/// the first step where growth is context-free (predicted_length), else in the step where it happens.
[[nodiscard]] Derivation derive(const PointSystem& system, const ModuleWord& word, std::uint64_t cycles,
                                const DeriveOptions& options = {});

/// The interpretation passes, all of them, after the derivation; each is one rewriting and obeys max_modules.
[[nodiscard]] Derivation interpret(const PointSystem& system, const ModuleWord& word,
                                   const DeriveOptions& options = {});

/// Interpretation pass number `pass` (from 0) alone, on the word after the passes before it.
[[nodiscard]] Derivation interpret_pass(const PointSystem& system, const ModuleWord& word, std::size_t pass,
                                        const DeriveOptions& options = {});

/// The length of the word after so many cycles, saturating at `limit` + 1, by the growth matrix: none when the rules of
/// a letter differ in the letters of their successors, have strict predecessors of several modules, or may fail to
/// match without being the identity. In a ring of one letter contexts never fail. Cost: at most 2 10^7 letters counted;
/// none beyond.
[[nodiscard]] std::optional<std::uint64_t> predicted_length(const PointSystem& system, const ModuleWord& word,
                                                            std::uint64_t cycles, std::uint64_t limit);

/// What one step did, for traces and derivation trees: for each module of the new word its parent (the first module of
/// the strict predecessor) and the modules of the old word whose parameters it read.
struct StepRecord {
    std::vector<std::size_t> parent;
    std::vector<std::vector<std::size_t>> read;     ///< contexts only, without the strict predecessor
    std::vector<std::optional<std::uint32_t>> rule; ///< index in grammar().rules; none: identity
};
[[nodiscard]] Derivation derive_step(const PointSystem& system, const ModuleWord& word, std::uint64_t step,
                                     const DeriveOptions& options, StepRecord& record);

} // namespace internode
