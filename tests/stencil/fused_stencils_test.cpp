// SPDX-License-Identifier: MIT

#include "internode/stencil/fused_stencils.h"

#include "internode/curve/knots.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/stride.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace internode {
namespace {

using tests::bundled_systems;
using tests::sample_systems;
using tests::system_of;
using tests::word_of;

const int highest_degree = tests::in_full() ? 5 : 3;
const std::size_t most_rows = tests::in_full() ? 4000 : 400;

std::vector<bool> every(const StencilAutomaton& automaton) {
    return std::vector<bool>(automaton.state_count(), true);
}

std::optional<FusedStencils> table_of(const StencilAutomaton& automaton, const IntervalSystem& system, int steps,
                                      const std::vector<bool>& wanted) {
    return IntervalFuser(std::make_shared<const StencilAutomaton>(automaton), system).table(steps, wanted);
}

/// A word with all symbols that occur, closed, and one with zeros at its ends.
std::vector<CellState> some_cells(const IntervalSystem& system, int degree) {
    Word word;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i)
        if (system.occurs(to_symbol(i))) word.insert(word.end(), 2, to_symbol(i));
    std::vector<CellState> cells = cell_states(word, degree, Ends::Circular);
    const std::vector<CellState> ends = cell_states(clamped(word, degree), degree, Ends::Open);
    cells.insert(cells.end(), ends.begin(), ends.end());
    return cells;
}

/// Each weight against the exact one of the automaton of σᵏ: within the rounding of the nearest double.
void check_against_exact(const IntervalSystem& system, int degree, int steps, const std::string& name,
                         tests::Compared& compared) {
    SCOPED_TRACE(name + ", degree " + std::to_string(degree) + ", steps " + std::to_string(steps));
    const StencilAutomaton automaton = make_automaton(system, degree, some_cells(system, degree), max_states);
    const auto fused = table_of(automaton, system, steps, every(automaton));
    ASSERT_TRUE(fused.has_value());
    if (fused->row_count() > most_rows) return;
    const IntervalSystem whole = power(system, steps);
    const StencilAutomaton exact = make_automaton(whole, degree, some_cells(system, degree), max_states);
    for (std::uint32_t state = 0; state < automaton.state_count(); ++state) {
        std::uint32_t same = 0;
        try {
            same = exact.find(automaton.state(state));
        } catch (const std::out_of_range&) {
            continue; // met only between the steps
        }
        const auto children = exact.children(same);
        ASSERT_EQ(fused->rows(state), children.size());
        for (std::size_t i = 0; i < children.size(); ++i) {
            const std::size_t row = fused->first_row[state] + i;
            EXPECT_EQ(automaton.state(fused->descendants[row]), exact.state(children[i].state));
            const auto weights = exact.weights(children[i].row);
            for (std::size_t k = 0; k < weights.size(); ++k) {
                const double got = fused->weights[row * weights.size() + k];
                // Half a unit in the last place, and what 106 bits leave of an amplified 0.
                EXPECT_LE(std::abs(got - weights[k]), 0x1p-53 * weights[k] + 0x1p-60) << "row " << row;
                ++compared;
            }
        }
    }
}

TEST(FusedStencils, AreTheRowsOfTheAutomatonOfThePower) {
    tests::Compared compared;
    for (const auto& [name, text] : sample_systems())
        for (int degree = 1; degree <= highest_degree; ++degree)
            for (const int steps : {1, 2, 3, 4}) check_against_exact(system_of(text), degree, steps, name, compared);
}

TEST(FusedStencils, AreTheRowsOfTheAutomatonOfThePowerForBundledGrammars) {
    tests::Compared compared;
    for (const auto& [name, system] : bundled_systems())
        for (const int steps : {2, 3}) check_against_exact(system, 3, steps, name, compared);
}

TEST(FusedStencils, SumToOneWithinTheRoundingOfEachWeight) {
    for (const auto& [name, text] : sample_systems())
        for (int degree = 1; degree <= 8; ++degree) {
            const IntervalSystem system = system_of(text);
            const StencilAutomaton automaton = make_automaton(system, degree, some_cells(system, degree), max_states);
            const auto fused = table_of(automaton, system, 5, every(automaton));
            ASSERT_TRUE(fused.has_value()) << name;
            for (std::size_t row = 0; row < fused->row_count(); ++row) {
                double sum = 0;
                for (std::size_t k = 0; k < fused->width; ++k) sum += fused->weights[row * fused->width + k];
                EXPECT_NEAR(sum, 1, degree * std::numeric_limits<double>::epsilon()) << name << " " << degree;
            }
        }
}

TEST(FusedStencils, KeepOnlyTheStatesThatAreWanted) {
    const IntervalSystem system = system_of("L->SL, S->L");
    const StencilAutomaton automaton =
        make_automaton(system, 3, cell_states(word_of(system, "LSLLS"), 3, Ends::Circular), max_states);
    std::vector<bool> wanted(automaton.state_count());
    wanted[1] = true;
    const auto some = table_of(automaton, system, 4, wanted);
    const auto all = table_of(automaton, system, 4, every(automaton));
    ASSERT_TRUE(some && all);
    EXPECT_EQ(some->row_count(), all->rows(1));
    const auto first = all->weights.begin() + static_cast<std::ptrdiff_t>(all->first_row[1] * all->width);
    EXPECT_TRUE(std::equal(some->weights.begin(), some->weights.end(), first));
}

TEST(FusedStencils, SayWhenLengthsAreTooUneven) {
    // An interval beside one 10^12 times as long: at degree 5 the blossom leaves its interval by too much.
    const IntervalSystem system = system_of("A->AA, B->BB\nlength A = 1\nlength B = 1000000000000");
    const StencilAutomaton automaton =
        make_automaton(system, 5, cell_states(word_of(system, "AABBBAB"), 5, Ends::Circular), max_states);
    EXPECT_TRUE(table_of(automaton, system, 1, every(automaton)).has_value());
    EXPECT_FALSE(table_of(automaton, system, 2, every(automaton)).has_value());
}

TEST(FusedStencils, OfOneStepTakeExactRowsWherePairsOfDoublesDoNotSuffice) {
    const IntervalSystem system = system_of("A->AA, B->BB\nlength A = 1\nlength B = 1000000000000");
    const std::vector<CellState> cells =
        cell_states(word_of(system, "AAAAAAAAAAAABBBBBBBBBBBBBBAB"), 5, Ends::Circular);
    const StencilAutomaton exact = make_automaton(system, 5, cells, max_states);
    const StencilAutomaton bare = make_automaton(system, 5, cells, max_states, AutomatonRows::None);
    const auto of_exact = table_of(exact, system, 1, every(exact));
    const auto of_bare = table_of(bare, system, 1, every(bare));
    ASSERT_TRUE(of_exact && of_bare);
    ASSERT_GT(of_exact->row_count(), 30U);
    EXPECT_EQ(of_bare->descendants, of_exact->descendants);
    ASSERT_EQ(of_bare->weights.size(), of_exact->weights.size());
    std::size_t equal = 0;
    for (std::size_t i = 0; i < of_bare->weights.size(); ++i) {
        EXPECT_NEAR(of_bare->weights[i], of_exact->weights[i], 0x1p-80) << "what pairs of doubles cannot tell from 0";
        equal += of_bare->weights[i] == of_exact->weights[i] ? 1 : 0;
    }
    EXPECT_GT(equal, of_bare->weights.size() * 3 / 4);
}

TEST(FusedStencils, RefuseNoStepsAndAWrongWish) {
    const IntervalSystem system = system_of("A->AA");
    const StencilAutomaton automaton =
        make_automaton(system, 2, cell_states(word_of(system, "AAA"), 2, Ends::Circular), max_states);
    EXPECT_THROW((void)table_of(automaton, system, 0, every(automaton)), std::invalid_argument);
    EXPECT_THROW((void)table_of(automaton, system, 1, {}), std::invalid_argument);
}

} // namespace
} // namespace internode
