// SPDX-License-Identifier: MIT

#include "internode/stencil/cell_rules.h"

#include "internode/stencil/automaton.h"
#include "tests/fixtures/interval_systems.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace internode {
namespace {

using tests::system_of;
using tests::word_of;

CellRow row(std::ptrdiff_t first, std::vector<Number> weights) {
    return {first, std::move(weights)};
}

const Number one_half = Rational(1, 2);

TEST(Trimmed, LeavesNoZeroAtAnEnd) {
    EXPECT_EQ(trimmed(row(3, {0, 0, one_half, 0, one_half, 0})), row(5, {one_half, 0, one_half}));
    EXPECT_EQ(trimmed(row(3, {0, 0})), row(0, {}));
    EXPECT_EQ(trimmed(row(-2, {1})), row(-2, {1}));
}

TEST(CellAutomaton, IsMadeOfRulesAndGivesThemBack) {
    // State 0 has no children, state 1 has rows that lie apart.
    const CellRules rules{{}, {{0, row(2, {1})}, {1, row(-1, {one_half, one_half})}, {1, row(0, {})}}};
    const CellAutomaton automaton = make_cell_automaton(rules);
    EXPECT_EQ(automaton.width(), 4U);
    EXPECT_EQ(automaton.offset(1), -1);
    EXPECT_TRUE(automaton.children(0).empty());
    EXPECT_EQ(rules_of(automaton), rules);
    EXPECT_THROW((void)make_cell_automaton({{{1, row(0, {1})}}}), std::invalid_argument);
}

TEST(CellAutomaton, OfIntervalsGivesItsRulesBack) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const StencilAutomaton automaton =
        make_automaton(fibonacci, 3, cell_states(word_of(fibonacci, "LSLLS"), 3, Ends::Circular), max_states);
    const CellRules rules = rules_of(automaton);
    EXPECT_EQ(rules_of(make_cell_automaton(rules)), rules);
}

TEST(EquivalentStates, AreToldApartByColorsRowsAndChildren) {
    const CellRow a = row(0, {one_half, one_half});
    const CellRow b = row(0, {1});
    // 0 and 1 do the same; 2 has another row; 3 leads to 2.
    const CellRules rules{{{0, a}, {1, a}}, {{1, a}, {0, a}}, {{2, a}, {2, b}}, {{2, a}, {2, a}}};
    const std::vector<std::uint32_t> labels = row_labels(rules);
    EXPECT_EQ(equivalent_states(rules, labels), (std::vector<std::uint32_t>{0, 0, 1, 2}));
    const std::vector<std::uint32_t> colors{0, 1, 0, 0};
    EXPECT_EQ(equivalent_states(rules, labels, colors), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(NormalForm, ForgetsNamesDoublesAndTheOrigin) {
    const CellRow a = row(4, {one_half, one_half});
    const CellRow b = row(5, {1});
    const CellRules one{{{1, a}}, {{0, b}, {2, b}}, {{1, a}}};
    const CellRules other{{{1, row(-1, {1})}, {1, row(-1, {1})}}, {{0, row(-2, {one_half, one_half})}}};
    const std::uint32_t first[] = {0};
    const std::uint32_t second[] = {1};
    EXPECT_EQ(normal_form(one, first), normal_form(other, second));
    const CellRules normal = normal_form(one, first).rules;
    ASSERT_EQ(normal.size(), 2U);
    EXPECT_EQ(normal[0].size(), 1U);
    EXPECT_EQ(normal[1].size(), 2U);
    EXPECT_FALSE(normal_form(one, first) == normal_form(other, first));
}

TEST(NormalForm, KnowsFibonacciByItsRules) {
    // A renamed copy, with one letter more that does the same: L -> S L, S -> M, M -> S L is the same system.
    const IntervalSystem a = system_of("L->SL, S->L");
    const IntervalSystem b = system_of("L->SM, M->SL, S->L");
    const auto form = [](const IntervalSystem& system, const std::string& word) {
        const std::vector<CellState> cells = cell_states(word_of(system, word), 2, Ends::Circular);
        const StencilAutomaton automaton = make_automaton(system, 2, cells, max_states);
        std::vector<std::uint32_t> start;
        for (const CellState& cell : cells) start.push_back(automaton.find(cell));
        return normal_form(rules_of(automaton), start);
    };
    EXPECT_EQ(form(a, "LSLLS"), form(b, "LSMLS"));
}

} // namespace
} // namespace internode
