// SPDX-License-Identifier: MIT

#include "internode/stencil/automaton.h"

#include "internode/algebra/fraction.h"
#include "internode/curve/knots.h"
#include "internode/spline/window.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/stride.h"
#include "tests/reference/nearest.h"
#include "tests/reference/step_matrix.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

namespace internode {
namespace {

using reference::boehm_matrix;
using reference::gather_matrix;
using reference::Matrix;
using reference::product;
using reference::scatter_matrix;
using testing::ElementsAre;
using tests::system_of;
using tests::word_of;

/// A word of `count` letters that has every symbol: cut from an image of the alphabet, or repeated.
Word rewritten_word(const IntervalSystem& system, std::size_t count) {
    Word word;
    for (std::size_t i = 0; i < system.rules().size(); ++i) word.push_back(to_symbol(i));
    while (word.size() < count) word = system.rules()(word);
    word.resize(count);
    return word;
}

void expect_same_step_by_three_routes(const IntervalSystem& system, const Word& word, int degree, Ends ends) {
    const Matrix gathered = gather_matrix(system, word, degree, ends);
    EXPECT_EQ(gathered, scatter_matrix(system, word, degree, ends));
    EXPECT_EQ(gathered, boehm_matrix(system, word, degree, ends));
    for (const std::vector<Number>& row : gathered) {
        Number sum;
        for (const Number& weight : row) {
            EXPECT_GE(weight.sign(), 0);
            sum += weight;
        }
        EXPECT_EQ(sum, Number(1));
    }
}

TEST(CellStates, OfAClosedWordHaveTheirIntervalInTheMiddle) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const std::vector<CellState> states = cell_states(word_of(fibonacci, "LLS"), 2, Ends::Circular);
    EXPECT_THAT(states, ElementsAre(CellState{word_of(fibonacci, "SLL"), 0}, CellState{word_of(fibonacci, "LLS"), 0},
                                    CellState{word_of(fibonacci, "LSL"), 0}));
}

TEST(CellStates, OfAShortClosedWordWrapMoreThanOnce) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    EXPECT_THAT(cell_states(word_of(fibonacci, "L"), 3, Ends::Circular),
                ElementsAre(CellState{word_of(fibonacci, "LLLLL"), 0}));
    EXPECT_THAT(cell_states(word_of(fibonacci, "LS"), 3, Ends::Circular),
                ElementsAre(CellState{word_of(fibonacci, "LSLSL"), 0}, CellState{word_of(fibonacci, "SLSLS"), 0}));
}

TEST(CellStates, OfEmptyIntervalsLeadTheNextOne) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const Word window = word_of(fibonacci, "0LS");
    EXPECT_THAT(cell_states(word_of(fibonacci, "L00LS0"), 2, Ends::Circular),
                ElementsAre(CellState{word_of(fibonacci, "0L0"), 0}, CellState{window, 2}, CellState{window, 1},
                            CellState{window, 0}, CellState{word_of(fibonacci, "LS0"), 0},
                            CellState{word_of(fibonacci, "0L0"), 1}));
}

TEST(CellStates, OfAnOpenWordBeginWithThePointsBeforeTheDomain) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const Word first = word_of(fibonacci, "SLS");
    EXPECT_THAT(cell_states(word_of(fibonacci, "LSLSLL"), 2, Ends::Open),
                ElementsAre(CellState{first, 2}, CellState{first, 1}, CellState{first, 0},
                            CellState{word_of(fibonacci, "LSL"), 0}));
}

TEST(CellStates, RefuseWordsThatDoNotFit) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const auto states = [&](const char* word, int degree, Ends ends) {
        return cell_states(word_of(fibonacci, word), degree, ends);
    };
    EXPECT_THROW((void)states("", 2, Ends::Circular), std::invalid_argument);
    EXPECT_THROW((void)states("L", 0, Ends::Circular), std::invalid_argument);
    EXPECT_THROW((void)states("00", 2, Ends::Circular), std::invalid_argument);
    EXPECT_THROW((void)states("L000S", 2, Ends::Circular), std::invalid_argument);
    EXPECT_THROW((void)states("LLLL", 2, Ends::Open), std::invalid_argument);
    EXPECT_THROW((void)states("LL0LLL", 2, Ends::Open), std::invalid_argument);
    EXPECT_THROW((void)states("LLL0LL", 2, Ends::Open), std::invalid_argument);
    EXPECT_THROW((void)states("LLL000LLL", 2, Ends::Open), std::invalid_argument);
}

/// The states of a word's cells by their numbers, or nothing for a word that has none.
std::optional<std::vector<CellState>> numbered_states(const Word& word, int degree, Ends ends) {
    try {
        const NumberedCells numbered = numbered_cells(word, degree, ends);
        std::vector<CellState> states;
        std::uint32_t next = 0;
        for (const std::uint32_t cell : numbered.cells) {
            EXPECT_LE(cell, next) << "numbers come in the order of the cells";
            if (cell == next) ++next;
            states.push_back(numbered.states.at(cell));
        }
        EXPECT_EQ(next, numbered.states.size());
        for (std::size_t i = 0; i < numbered.states.size(); ++i)
            EXPECT_EQ(std::ranges::find(numbered.states, numbered.states[i]) - numbered.states.begin(), i);
        return states;
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

TEST(NumberedCells, AreTheStatesOfEverySmallWordEachOnce) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const Word letters = word_of(fibonacci, "LS0");
    std::size_t with_states = 0;
    for (std::size_t size = 0; size <= 7; ++size) {
        std::vector<std::size_t> digits(size, 0);
        for (bool more = true; more;) {
            Word word;
            for (const std::size_t digit : digits) word.push_back(letters[digit]);
            for (const int degree : {1, 2, 3})
                for (const Ends ends : {Ends::Circular, Ends::Open}) {
                    std::optional<std::vector<CellState>> expected;
                    try {
                        expected = cell_states(word, degree, ends);
                        ++with_states;
                    } catch (const std::invalid_argument&) {
                    }
                    EXPECT_EQ(numbered_states(word, degree, ends), expected);
                }
            const auto carry = std::ranges::find_if(digits, [](std::size_t digit) { return digit < 2; });
            std::fill(digits.begin(), carry, 0);
            more = carry != digits.end();
            if (more) ++*carry;
        }
    }
    EXPECT_GT(with_states, 5000U);
}

TEST(Automaton, OfFibonacciIsSmall) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (int degree = 1; degree <= 12; ++degree) {
        Word word = word_of(fibonacci, "L");
        while (word.size() < 400) word = fibonacci.rules()(word);
        const std::vector<CellState> cells = cell_states(word, degree, Ends::Circular);
        const StencilAutomaton automaton = make_automaton(fibonacci, degree, cells, max_states);
        EXPECT_EQ(automaton.state_count(), 2 * static_cast<std::size_t>(degree));
        EXPECT_EQ(automaton.degree(), degree);
        EXPECT_EQ(automaton.width(), static_cast<std::size_t>(degree) + 1);
    }
}

TEST(Automaton, HoldsTransientWindowsOfItsWord) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const std::vector<CellState> cells = cell_states(word_of(fibonacci, "SSSSS"), 3, Ends::Circular);
    EXPECT_EQ(make_automaton(fibonacci, 3, cells, max_states).state_count(), 9U);
}

TEST(Automaton, SharesEqualRows) {
    const IntervalSystem sederberg = system_of("A->AA, B->BB");
    const std::vector<CellState> cells = cell_states(word_of(sederberg, "ABBA"), 3, Ends::Circular);
    const StencilAutomaton automaton = make_automaton(sederberg, 3, cells, max_states);
    EXPECT_GT(automaton.state_count(), 2U);
    EXPECT_EQ(automaton.row_count(), 2U) << "all lengths are 1: the rows of uniform subdivision";
}

TEST(Automaton, GivesEveryStateItsWindowsRows) {
    for (const auto& [name, text] : tests::sample_systems()) {
        SCOPED_TRACE(name);
        const IntervalSystem system = system_of(text);
        for (int degree = 1; degree <= 4; ++degree) {
            const auto d = static_cast<std::size_t>(degree);
            const std::vector<CellState> cells = cell_states(rewritten_word(system, 2 * d + 4), degree, Ends::Open);
            const StencilAutomaton automaton = make_automaton(system, degree, cells, max_states);
            for (std::uint32_t s = 0; s < automaton.state_count(); ++s) {
                const CellState state = automaton.state(s);
                EXPECT_EQ(automaton.find(state), s);
                EXPECT_EQ(automaton.offset(s), static_cast<std::ptrdiff_t>(state.lead) - degree);
                const WindowStencils stencils = window_stencils(system, state.window);
                const std::size_t children = state.lead == 0 ? stencils.children.size() : 1;
                ASSERT_EQ(automaton.children(s).size(), children);
                for (std::size_t c = 0; c < children; ++c) {
                    const StencilAutomaton::Child child = automaton.children(s)[c];
                    EXPECT_EQ(automaton.state(child.state), (CellState{stencils.child_windows[c], state.lead}));
                    const auto& row = state.lead == 0 ? stencils.children[c] : stencils.leading[state.lead - 1];
                    EXPECT_TRUE(std::ranges::equal(automaton.exact_weights(child.row), row));
                }
            }
        }
    }
}

TEST(Automaton, RoundsEveryWeightOnce) {
    for (const auto& [name, text] : tests::sample_systems()) {
        const IntervalSystem system = system_of(text);
        const std::vector<CellState> cells = cell_states(rewritten_word(system, 12), 4, Ends::Open);
        const StencilAutomaton automaton = make_automaton(system, 4, cells, max_states);
        for (std::uint32_t row = 0; row < automaton.row_count(); ++row)
            for (std::size_t i = 0; i < automaton.width(); ++i)
                EXPECT_TRUE(reference::is_nearest(automaton.weights(row)[i], automaton.exact_weights(row)[i])) << name;
    }
}

TEST(Automaton, RefusesMoreStatesThanAllowed) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const std::vector<CellState> cells = cell_states(word_of(fibonacci, "LSLLSL"), 3, Ends::Circular);
    EXPECT_THROW((void)make_automaton(fibonacci, 3, cells, 5), TooManyStates);
    const StencilAutomaton automaton = make_automaton(fibonacci, 3, cells, max_states);
    EXPECT_NO_THROW((void)make_automaton(fibonacci, 3, cells, automaton.state_count()));
    EXPECT_THROW((void)make_automaton(fibonacci, 3, cells, automaton.state_count() - 1), TooManyStates);
}

TEST(Automaton, RefusesStatesThatAreNone) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const auto make = [&](int degree, const char* window, std::uint32_t lead) {
        return make_automaton(fibonacci, degree, {{word_of(fibonacci, window), lead}}, max_states);
    };
    EXPECT_THROW((void)make(0, "L", 0), std::invalid_argument);
    EXPECT_THROW((void)make(13, "L", 0), std::invalid_argument);
    EXPECT_THROW((void)make(2, "L", 0), std::invalid_argument);
    EXPECT_THROW((void)make(2, "L0L", 0), std::invalid_argument);
    EXPECT_THROW((void)make(2, "LSL", 3), std::invalid_argument);
    const StencilAutomaton automaton = make(2, "LSL", 0);
    EXPECT_THROW((void)automaton.find({word_of(fibonacci, "SSS"), 0}), std::out_of_range);
    EXPECT_THROW((void)automaton.find({word_of(fibonacci, "LSL"), 1}), std::out_of_range);
}

TEST(Step, OfAClosedWordIsTheSameGatheredScatteredAndInserted) {
    for (const auto& [name, text] : tests::sample_systems()) {
        SCOPED_TRACE(name);
        const IntervalSystem system = system_of(text);
        for (int degree = 1; degree <= 4; ++degree)
            for (const std::size_t letters : {1U, 2U, 3U, 7U})
                expect_same_step_by_three_routes(system, rewritten_word(system, letters), degree, Ends::Circular);
    }
}

TEST(Step, OfAnOpenWordIsTheSameGatheredScatteredAndInserted) {
    for (const auto& [name, text] : tests::sample_systems()) {
        SCOPED_TRACE(name);
        const IntervalSystem system = system_of(text);
        for (int degree = 1; degree <= 4; ++degree)
            for (const std::size_t more : {0U, 1U, 4U})
                expect_same_step_by_three_routes(
                    system, rewritten_word(system, 2 * static_cast<std::size_t>(degree) + 1 + more), degree,
                    Ends::Open);
    }
}

TEST(Step, WithEmptyIntervalsIsTheSameGatheredScatteredAndInserted) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (int degree = 1; degree <= 4; ++degree) {
        for (std::size_t zeros = 1; zeros <= static_cast<std::size_t>(degree); ++zeros) {
            Word broken = word_of(fibonacci, "LS");
            broken.insert(broken.end(), zeros, zero_interval);
            broken.push_back(to_symbol(1));
            expect_same_step_by_three_routes(fibonacci, broken, degree, Ends::Circular);
            expect_same_step_by_three_routes(fibonacci, clamped(broken, degree), degree, Ends::Open);
            const Word ends = rewritten_word(fibonacci, static_cast<std::size_t>(degree));
            Word open = ends;
            open.insert(open.end(), broken.begin(), broken.end());
            open.insert(open.end(), ends.begin(), ends.end());
            expect_same_step_by_three_routes(fibonacci, open, degree, Ends::Open);
        }
    }
}

TEST(Step, OfClosedWordsWithAnyZerosIsTheSameByThreeRoutes) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (const Word& word : tests::words_with_zeros(2, 5)) {
        for (int degree = 1; degree <= 3; ++degree) {
            try {
                (void)cell_states(word, degree, Ends::Circular);
            } catch (const std::invalid_argument&) {
                continue; // more than `degree` zeros in a row
            }
            expect_same_step_by_three_routes(fibonacci, word, degree, Ends::Circular);
        }
    }
}

TEST(Step, OfAClampedWordKeepsItsEnds) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (int degree = 1; degree <= 6; ++degree) {
        const Word word = clamped(word_of(fibonacci, "LSLLSL"), degree);
        const Matrix matrix = gather_matrix(fibonacci, word, degree, Ends::Open);
        EXPECT_EQ(matrix.front().front(), Number(1));
        EXPECT_EQ(matrix.back().back(), Number(1));
        EXPECT_EQ(matrix.front()[1], Number(0));
        EXPECT_EQ(matrix.back()[matrix.back().size() - 2], Number(0));
    }
}

TEST(Step, TwiceIsOneStepOfTheSquaredSystem) {
    for (const auto& [name, text] : tests::sample_systems()) {
        SCOPED_TRACE(name);
        const IntervalSystem once = system_of(text);
        IntervalGrammar grammar = once.grammar();
        grammar.rules = power(grammar.rules, 2);
        const Verdict verdict = validate(grammar);
        ASSERT_TRUE(verdict.system);
        const IntervalSystem& squared = *verdict.system;
        const Number ratio = once.ratio() * once.ratio();
        // The squared system may live in a smaller field, generated by ρ².
        const auto same_number = [&](const Number& number) {
            Number sum;
            Number power_of_ratio(1);
            for (const Rational& coefficient : number.coefficients(squared.field())) {
                sum += Number(coefficient) * power_of_ratio;
                power_of_ratio *= ratio;
            }
            return sum;
        };
        const auto lengths_agree = [&] {
            for (std::size_t i = 0; i < once.lengths().size(); ++i)
                if (same_number(squared.lengths()[i]) != once.lengths()[i]) return false;
            return true;
        };
        if (!lengths_agree()) continue; // two final classes where there was one period
        for (int degree = 1; degree <= 3; ++degree) {
            for (const Ends ends : {Ends::Circular, Ends::Open}) {
                const Word word = rewritten_word(once, 2 * static_cast<std::size_t>(degree) + 2);
                const reference::Step step = reference::step_of(once, word, degree, ends);
                const Matrix twice =
                    product(gather_matrix(once, step.word, degree, ends), gather_matrix(once, word, degree, ends));
                Matrix direct = gather_matrix(squared, word, degree, ends);
                for (std::vector<Number>& row : direct)
                    for (Number& weight : row) weight = same_number(weight);
                EXPECT_EQ(direct, twice);
            }
        }
    }
}

TEST(Automaton, OfManySymbolsHasAFewStatesEach) {
    const std::size_t symbols = tests::in_full() ? 5000 : 200;
    IntervalGrammar grammar;
    std::vector<Word> rules;
    Word word;
    for (std::size_t i = 0; i < symbols; ++i) {
        const Symbol symbol = grammar.alphabet.add(std::string("A").append(std::to_string(i)));
        rules.push_back({symbol, symbol});
        word.push_back(symbol);
        grammar.lengths.push_back({symbol, fraction(static_cast<long>(i % 97) + 2, 3)});
    }
    grammar.rules = Morphism(rules);
    const Verdict verdict = validate(grammar);
    ASSERT_TRUE(verdict.system);
    const std::vector<CellState> cells = cell_states(word, 3, Ends::Circular);
    // abcde; aabbc, abbcc; aabbb, abbbb, bbbbc, bbbcc; bbbbb.
    EXPECT_EQ(make_automaton(*verdict.system, 3, cells, max_states).state_count(), 8 * symbols);
}

} // namespace
} // namespace internode
