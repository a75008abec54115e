// SPDX-License-Identifier: MIT

#include "internode/point/rule_programs.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

/// The extents of a rule's formals; none when a letter of it is in no word.
std::optional<std::vector<Extent>> extents_of(const PointRule& rule, const Layout& layout) {
    std::vector<Extent> extents;
    for (const auto* part : {&rule.left, &rule.predecessor, &rule.right})
        for (const Symbol letter : *part) {
            const auto& parameters = layout[to_index(letter)];
            if (!parameters) return std::nullopt;
            extents.insert(extents.end(), parameters->begin(), parameters->end());
        }
    return extents;
}

RulePrograms compile_rule(const PointRule& rule, std::span<const Extent> extents, ProgramMaker& maker) {
    RulePrograms programs;
    if (rule.condition) programs.condition = maker.make(*rule.condition, extents);
    if (rule.weight) programs.weight = maker.make(*rule.weight, extents);
    for (const ModuleTemplate& one : rule.successor) {
        ModulePrograms& made = programs.successor.emplace_back();
        made.letter = one.letter;
        for (const Expression& argument : one.arguments) made.arguments.push_back(maker.make(argument, extents));
    }
    return programs;
}

class RuleSetMaker {
public:
    RuleSetMaker(const PointGrammar& grammar, std::size_t tables, ProgramMaker& maker)
        : letters_(grammar.letters.size())
        , maker_(maker) {
        set_.by_letter.assign(tables, std::vector<std::vector<std::uint32_t>>(letters_));
        set_.begins_several.assign(tables, std::vector<bool>(letters_, false));
    }

    RuleSetPrograms make(std::span<const PointRule> rules, const Layout& layout) {
        for (std::uint32_t i = 0; i < rules.size(); ++i) {
            const std::optional<std::vector<Extent>> extents = extents_of(rules[i], layout);
            set_.rules.push_back(extents ? compile_rule(rules[i], *extents, maker_) : RulePrograms());
            if (extents) list(rules[i], i);
        }
        return std::move(set_);
    }

private:
    void list(const PointRule& rule, std::uint32_t index) {
        assert(!rule.predecessor.empty());
        const std::size_t letter = to_index(rule.predecessor.front());
        const std::size_t first = rule.table.value_or(0);
        const std::size_t last = rule.table ? first + 1 : set_.by_letter.size();
        for (std::size_t table = first; table < last; ++table) {
            set_.by_letter[table][letter].push_back(index);
            if (rule.predecessor.size() > 1) set_.begins_several[table][letter] = true;
        }
    }

    std::size_t letters_;
    ProgramMaker& maker_;
    RuleSetPrograms set_;
};

} // namespace

PointPrograms make_programs(const PointGrammar& grammar, std::span<const KnownNumber> constants,
                            std::span<const Layout> layouts) {
    assert(layouts.size() == 1 + grammar.interpretations.size());
    ProgramMaker maker({grammar.definitions, constants});
    PointPrograms programs;
    programs.sets.push_back(RuleSetMaker(grammar, std::max<std::size_t>(1, grammar.tables.size()), maker)
                                .make(grammar.rules, layouts.front()));
    for (std::size_t pass = 0; pass < grammar.interpretations.size(); ++pass)
        programs.sets.push_back(RuleSetMaker(grammar, 1, maker).make(grammar.interpretations[pass], layouts[pass]));
    programs.functions = maker.functions();
    return programs;
}

} // namespace internode
