// SPDX-License-Identifier: MIT
//
// Pieces of W modules to each side, for one W after the other: explore() finds the states, or says that W is too small.
// reaches() and classes() say which of them are one; assemble() makes the automaton.

#include "internode/point/compile/compile.h"

#include "internode/point/compile/state_classes.h"
#include "internode/stencil/kernel.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace internode {
namespace {

/// Widths of pieces, one after the other.
constexpr std::array<std::size_t, 12> piece_widths{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};

/// Why no piece could decide, seen in the grammar alone.
std::vector<ExactStop> obstacles(const PointSystem& system) {
    const PointGrammar& grammar = system.grammar();
    std::vector<ExactStop> reasons;
    const auto is_used = [&](std::optional<Symbol> letter) {
        return letter && system.layout()[to_index(*letter)].has_value();
    };
    if (is_used(branch_open(grammar))) reasons.push_back({{}, "has branches"});
    for (const PointRule& rule : grammar.rules) {
        if (rule.predecessor.size() > 1) reasons.push_back({rule.place, "has a strict predecessor of several modules"});
        if (rule.weight) reasons.push_back({rule.place, "is chosen by chance"});
    }
    for (std::size_t i = 0; i < grammar.letters.size(); ++i)
        if (grammar.letters.names()[i].front() == '?' && is_used(to_symbol(i)))
            reasons.push_back({{}, "asks its surroundings by `" + grammar.letters.names()[i] + "`"});
    return reasons;
}

/// All points of all words have one dimension.
std::optional<ExactStop> dimensions(const PointSystem& system) {
    Extent extent = 0;
    for (const auto& parameters : system.layout()) {
        if (!parameters) continue;
        for (const Extent each : *parameters) {
            if (each == 0) continue;
            if (extent != 0 && each != extent) return ExactStop{{}, "has points of several dimensions"};
            extent = each;
        }
    }
    if (extent == 0) return ExactStop{{}, "has no points"};
    return std::nullopt;
}

} // namespace

/// From explored states and their classes to the automaton: one state for each class, as its first member has it.
class CompiledGrammarMaker {
public:
    static CompiledGrammar assemble(Exploration exploration, const PointSystem& system, StartWord start) {
        const std::vector<Reach> reach = reaches(exploration.states);
        const std::vector<Emission> owned = emissions(exploration);
        const std::vector<std::uint32_t> class_of = classes(exploration.states, reach, owned);
        CompiledGrammar compiled;
        add_states(exploration, owned, class_of, compiled);
        compiled.automaton_ = std::make_shared<const CellAutomaton>(make_cell_automaton(compiled.rules_));
        compiled.kinds_ = exploration.kinds.kinds();
        for (const ModuleKind& kind : compiled.kinds_)
            compiled.is_point_.push_back(exploration.kinds.points_of(kind.letter));
        for (const Reach& one : reach)
            compiled.fused_width_ = std::max(compiled.fused_width_, static_cast<std::size_t>(one.last - one.first + 1));
        std::vector<std::uint32_t> shown;
        for (const std::uint32_t state : exploration.starts) shown.push_back(class_of[state]);
        CellsOfStart cells = start_cells(shown, system, start, exploration.side);
        compiled.cells_ = std::move(cells.states);
        compiled.interior_ = cells.interior;
        return compiled;
    }

private:
    static void add_states(Exploration& exploration, const std::vector<Emission>& owned,
                           const std::vector<std::uint32_t>& class_of, CompiledGrammar& compiled) {
        CellRules rules = own_rules(exploration.states);
        std::vector<bool> seen(rules.size());
        for (std::size_t i = 0; i < rules.size(); ++i) {
            if (seen[class_of[i]]) continue;
            assert(class_of[i] == compiled.rules_.size() && "classes are numbered as they are met");
            seen[class_of[i]] = true;
            for (CellChild& child : rules[i]) child.state = class_of[child.state];
            compiled.rules_.push_back(rules[i]);
            compiled.emissions_.push_back({owned[i].kinds, owned[i].slot});
            auto& around = compiled.surroundings_.emplace_back();
            for (PieceChild& child : exploration.states[i].children)
                around.push_back({child.first, std::move(child.rows)});
        }
    }
};

Compilation compile(const PointSystem& system, StartWord start, const CompileLimits& limits) {
    require_start(system, start);
    Compilation result;
    result.reasons = obstacles(system);
    if (std::optional<ExactStop> stop = dimensions(system)) result.reasons.push_back(*std::move(stop));
    if (!result.reasons.empty()) return result;
    ExactBudget budget{limits.work};
    for (const std::size_t side : piece_widths) {
        if (side > limits.side) break;
        ExplorationResult explored = explore(system, start, side, limits.states, budget);
        if (explored.stop) {
            result.reasons.push_back(*std::move(explored.stop));
            return result;
        }
        if (!explored.exploration) continue;
        CompiledGrammar compiled = CompiledGrammarMaker::assemble(*std::move(explored.exploration), system, start);
        if (compiled.automaton().width() <= max_row_width)
            result.compiled = std::move(compiled);
        else
            result.reasons.push_back(too_wide());
        return result;
    }
    result.reasons.push_back({{}, "needs letters that lie further away with every cycle"});
    return result;
}

} // namespace internode
