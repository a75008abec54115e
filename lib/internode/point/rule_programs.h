// SPDX-License-Identifier: MIT
//
// The rules of a point system with their expressions compiled: what a derivation runs.

#pragma once

#include "internode/expression/program.h"
#include "internode/grammar/points/point_grammar.h"
#include "internode/point/layout.h"
#include "internode/point/module_word.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace internode {

/// A module of an axiom, an input or a successor; the places of its arguments are in the grammar.
struct ModulePrograms {
    Symbol letter{};
    std::vector<Program> arguments;
};

struct RulePrograms {
    std::optional<Program> condition;
    std::optional<Program> weight;
    std::vector<ModulePrograms> successor;
};

/// One list of rules, of the derivation or of an interpretation pass.
struct RuleSetPrograms {
    std::vector<RulePrograms> rules; ///< one per rule; empty for a rule that no word can reach
    /// By table (one entry without tables) and by first letter of the strict predecessor: the rules that words can
    /// reach, in their order.
    std::vector<std::vector<std::vector<std::uint32_t>>> by_letter;
    /// Letters that begin a strict predecessor of several modules, by table.
    std::vector<std::vector<bool>> begins_several;
};

struct PointPrograms {
    std::vector<Program> functions;    ///< the functions of the definitions
    std::vector<RuleSetPrograms> sets; ///< 0: the derivation; k: interpretation pass k
    ModuleWord axiom;                  ///< empty without one
};

/// All but the axiom. Cost: linear in the grammar. Precondition: the layouts are those of the grammar.
[[nodiscard]] PointPrograms make_programs(const PointGrammar& grammar, std::span<const KnownNumber> constants,
                                          std::span<const Layout> layouts);

} // namespace internode
