// SPDX-License-Identifier: MIT
//
// Checks in turn: dimension and constants, costs and tables, the kinds of parameters, end markers, the cycle. What
// relies on earlier ones is left out where these found problems. Programs and the axiom's values are made of a grammar
// without problems only.

#include "internode/point/point_system.h"

#include "internode/expression/constants.h"
#include "internode/expression/known_value.h"
#include "internode/expression/limits.h"
#include "internode/point/layouts.h"
#include "internode/point/limits.h"
#include "internode/point/module_writer.h"
#include "internode/point/rule_programs.h"
#include "internode/text/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace internode {

namespace {

/// The rules of each table in the order of the text: its own and those without a table.
std::vector<std::vector<std::uint32_t>> rules_by_table(const PointGrammar& grammar) {
    std::vector<std::vector<std::uint32_t>> rules(std::max<std::size_t>(1, grammar.tables.size()));
    for (std::uint32_t i = 0; i < grammar.rules.size(); ++i)
        for (std::uint32_t table = 0; table < rules.size(); ++table)
            if (grammar.rules[i].table.value_or(table) == table) rules[table].push_back(i);
    return rules;
}

} // namespace

class PointSystemMaker {
public:
    PointSystemMaker(PointGrammar grammar, const PointSettings& settings)
        : settings_(settings) {
        system_.grammar_ = std::move(grammar);
        system_.dimension_ = settings.dimension;
        system_.start_ = settings.start;
    }

    CheckedPointSystem make() {
        check_dimension();
        system_.constants_ = constant_values(system_.grammar_.definitions, settings_.constants, problems_);
        if (problems_.empty()) {
            check_costs();
            check_tables();
            system_.layouts_ = infer_layouts(system_.grammar_, settings_, problems_);
            check_end_markers();
            expand_cycle();
        }
        if (problems_.empty()) make_programs_and_axiom();
        if (!problems_.empty()) return {std::nullopt, std::move(problems_)};
        system_.rules_of_ = rules_by_table(system_.grammar_);
        return {std::move(system_), {}};
    }

private:
    void check_dimension() {
        if (settings_.dimension >= 1 && settings_.dimension <= max_dimension) return;
        problems_.push_back({{},
                             fmt::format("points of {} coordinates", settings_.dimension),
                             fmt::format("1 to {} are allowed", max_dimension)});
    }

    void check_costs() {
        const std::vector<std::uint64_t> costs = definition_costs(system_.grammar_.definitions);
        const auto check = [&](const Expression& expression) {
            if (operations(expression, costs) > max_expression_operations)
                problems_.push_back({expression.place,
                                     fmt::format("more than {} operations when the functions that are called are "
                                                 "written out",
                                                 max_expression_operations),
                                     "a function that calls another twice doubles its work"});
        };
        for_each_expression(check);
    }

    void check_tables() {
        const PointGrammar& grammar = system_.grammar_;
        const std::size_t entries = grammar.rules.size() + grammar.letters.size();
        if (grammar.tables.empty() || entries <= max_table_entries / grammar.tables.size()) return;
        problems_.push_back({{},
                             fmt::format("{} tables for {} rules and letters", grammar.tables.size(), entries),
                             fmt::format("their product may be {}", max_table_entries)});
    }

    /// A rule that waits for an end marker which no word has would never be applied.
    void check_end_markers() {
        const PointGrammar& grammar = system_.grammar_;
        const std::optional<Symbol> marker = end_marker(grammar);
        if (!problems_.empty() || !marker) return;
        const auto check = [&](const std::vector<PointRule>& rules, const Layout& layout) {
            if (layout[to_index(*marker)]) return;
            for (const PointRule& rule : rules)
                if (std::ranges::count(rule.left, *marker) + std::ranges::count(rule.right, *marker) > 0)
                    problems_.push_back({rule.place, "a context with `#`, which nothing puts into a word",
                                         "`input # P(v) #` puts one at each end of a polygon"});
        };
        check(grammar.rules, system_.layouts_.front());
        for (std::size_t pass = 0; pass < grammar.interpretations.size(); ++pass)
            check(grammar.interpretations[pass], system_.layouts_[pass]);
    }

    void for_each_expression(const auto& visit) {
        const PointGrammar& grammar = system_.grammar_;
        const auto visit_word = [&](const std::vector<ModuleTemplate>& word) {
            for (const ModuleTemplate& one : word)
                for (const Expression& argument : one.arguments) visit(argument);
        };
        const auto visit_rules = [&](const std::vector<PointRule>& rules) {
            for (const PointRule& rule : rules) {
                if (rule.condition) visit(*rule.condition);
                if (rule.weight) visit(*rule.weight);
                visit_word(rule.successor);
            }
        };
        if (grammar.axiom) visit_word(*grammar.axiom);
        if (grammar.input)
            for (const auto* part : {&grammar.input->first, &grammar.input->each, &grammar.input->last})
                visit_word(*part);
        visit_rules(grammar.rules);
        for (const std::vector<PointRule>& pass : grammar.interpretations) visit_rules(pass);
        for (const CycleItem& item : grammar.cycle)
            if (item.count) visit(*item.count);
    }

    void make_programs_and_axiom() {
        auto programs =
            std::make_shared<PointPrograms>(make_programs(system_.grammar_, system_.constants_, system_.layouts_));
        if (system_.grammar_.axiom && settings_.start != PointStart::Input) {
            ProgramMaker maker(system_.scope());
            ModuleWriter writer(maker.functions());
            for (const ModuleTemplate& one : *system_.grammar_.axiom) {
                ModulePrograms compiled{one.letter, {}};
                for (const Expression& argument : one.arguments) compiled.arguments.push_back(maker.make(argument, {}));
                if (const std::optional<std::size_t> refused = writer.write(compiled, {}, programs->axiom))
                    problems_.push_back({one.arguments[*refused].place, "a parameter of the axiom is not finite", ""});
            }
        }
        system_.programs_ = std::move(programs);
    }

    void expand_cycle() {
        if (!problems_.empty()) return;
        if (system_.grammar_.tables.empty()) system_.cycle_.emplace_back();
        for (const CycleItem& item : system_.grammar_.cycle) {
            const std::optional<std::uint64_t> count = count_of(item);
            if (!count) continue;
            if (*count > max_cycle_steps - system_.cycle_.size()) {
                problems_.push_back({item.place, fmt::format("a cycle of more than {} steps", max_cycle_steps), ""});
                return;
            }
            system_.cycle_.insert(system_.cycle_.end(), *count, item.table);
        }
    }

    /// How often the table is applied, saturating above max_cycle_steps.
    std::optional<std::uint64_t> count_of(const CycleItem& item) {
        if (!item.count) return 1;
        if (!expect_type({}, "the count", *item.count, {}, system_.grammar_.definitions, problems_))
            return std::nullopt;
        const KnownNumber value = evaluate_known(*item.count, {}, system_.scope());
        if (!value.exact || value.exact->get_den() != 1 || *value.exact < 0) {
            problems_.push_back({item.count->place,
                                 fmt::format("a table is applied {} times",
                                             value.exact ? to_string(*value.exact) : "an irrational number of"),
                                 "the count is a whole number, 0 or more"});
            return std::nullopt;
        }
        return *value.exact > max_cycle_steps ? max_cycle_steps + 1 : value.exact->get_num().get_ui();
    }

    const PointSettings& settings_;
    PointSystem system_;
    std::vector<PointProblem> problems_;
};

DefinitionScope PointSystem::scope() const {
    return {grammar_.definitions, constants_};
}

bool PointSystem::is_pseudo(std::optional<std::uint32_t> table) const {
    return std::ranges::any_of(rules_of(table),
                               [&](std::uint32_t rule) { return grammar_.rules[rule].predecessor.size() > 1; });
}

CheckedPointSystem make_point_system(PointGrammar grammar, const PointSettings& settings) {
    return PointSystemMaker(std::move(grammar), settings).make();
}

} // namespace internode
