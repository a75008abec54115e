// SPDX-License-Identifier: MIT
//
// One parallel rewriting of a whole word: a derivation step or an interpretation pass.

#pragma once

#include "internode/point/derivation.h"
#include "internode/point/point_system.h"

#include <cstdint>
#include <optional>
#include <span>

namespace internode {

/// What is applied, and how it is read.
struct RewritingTask {
    const PointSystem& system;
    std::span<const PointRule> rules;
    std::size_t set = 0;          ///< the rules' index in system.programs().sets
    std::size_t table = 0;        ///< the table of that set
    std::uint64_t stream = 0;     ///< the stream of the random draws
    std::uint64_t first_pair = 0; ///< strict predecessors of several modules begin here or later
    std::uint64_t rotation = 0;   ///< how far the ring was turned; records and messages number modules as before
    std::uint64_t spent = 0;      ///< work of earlier steps, out of options.max_work
};

/// The new word, or the old one with the problem. Cost: the word times the letters of the rules.
[[nodiscard]] Derivation rewrite(const RewritingTask& task, ModuleWord word, const DeriveOptions& options,
                                 StepRecord* record);

} // namespace internode
