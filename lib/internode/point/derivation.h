// SPDX-License-Identifier: MIT
//
// What a derivation is asked and what it answers.

#pragma once

#include "internode/expression/expression.h"
#include "internode/point/limits.h"
#include "internode/point/module_word.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
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
    SourcePlace place; ///< the rule or the expression; bytes 0 when the whole grammar is meant
    std::string message;
    std::string hint;
};

struct Derivation {
    ModuleWord word; ///< the last whole word
    std::optional<DerivationProblem> problem;
    std::uint64_t work = 0; ///< letters compared and numbers computed
};

/// What one step did, for traces and derivation trees. For each module of the new word: its parent (the first module of
/// the strict predecessor) and the modules of the old word whose parameters it read.
struct StepRecord {
    std::vector<std::size_t> parent;
    std::vector<std::vector<std::size_t>> read;     ///< contexts only, without the strict predecessor
    std::vector<std::optional<std::uint32_t>> rule; ///< index in grammar().rules; none: identity
};

} // namespace internode
