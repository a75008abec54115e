// SPDX-License-Identifier: MIT
//
// Derivation as the papers define it: parallel rewriting, the first rule that matches wins, no rule is the identity.
// The reference for everything that is faster. Cost of a step: linear in the word times the length of the contexts.
//
// Stochastic rules: when the first rule that matches has a weight, one of all matching rules with a weight (and a
// strict predecessor as long) is drawn, with probability in proportion to the weights. The draw depends on the seed,
// the step and the position alone. Query modules get their parameters from the environment before every step and every
// interpretation pass.
//
// Strict predecessors of several modules (pseudo-L-systems, S0 section 7) are found from left to right, from module
// `phase` of a ring on. A module that begins such a predecessor but is not rewritten is left over: a problem.

#pragma once

#include "internode/point/derivation.h"
#include "internode/point/point_system.h"

#include <cstddef>
#include <cstdint>

namespace internode {

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

/// One derivation step with a record of what it did.
[[nodiscard]] Derivation derive_step(const PointSystem& system, const ModuleWord& word, std::uint64_t step,
                                     const DeriveOptions& options, StepRecord& record);

} // namespace internode
