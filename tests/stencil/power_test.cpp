// SPDX-License-Identifier: MIT
//
// The automaton of σ^k, applied once, is the automaton of σ applied k times: letter by letter, state by state and point
// by point, exactly in K.

#include "internode/curve/knots.h"
#include "internode/stencil/automaton.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/small_grammars.h"
#include "tests/fixtures/stride.h"
#include "tests/reference/step_matrix.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

/// A polygon with points in Q, and the states of its cells.
struct Exact {
    std::vector<std::uint32_t> states;
    std::vector<Number> points;
};

/// Points that no relation holds between by accident: squares modulo a prime.
Exact polygon(const StencilAutomaton& automaton, const std::vector<CellState>& cells) {
    Exact result;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        result.states.push_back(automaton.find(cells[i]));
        result.points.emplace_back(static_cast<long>((i * i * 7919 + 104729) % 1009) - 500);
    }
    return result;
}

Exact step(const StencilAutomaton& automaton, const Exact& old) {
    const auto size = static_cast<std::ptrdiff_t>(old.points.size());
    Exact result;
    for (std::ptrdiff_t cell = 0; cell < size; ++cell) {
        const std::uint32_t state = old.states[static_cast<std::size_t>(cell)];
        for (const StencilAutomaton::Child& child : automaton.children(state)) {
            Number point;
            std::ptrdiff_t parent = cell + automaton.offset(state);
            for (const Number& weight : automaton.exact_weights(child.row))
                point += weight * old.points[static_cast<std::size_t>((parent++ % size + size) % size)];
            result.states.push_back(child.state);
            result.points.push_back(std::move(point));
        }
    }
    return result;
}

void expect_power_is_repetition(const IntervalSystem& system, const Word& word, int degree, Ends ends, int most = 3) {
    const std::vector<CellState> cells = cell_states(word, degree, ends);
    const StencilAutomaton once = make_automaton(system, degree, cells, max_states);
    Exact repeated = step(once, polygon(once, cells));
    for (int k = 2; k <= most; ++k) {
        repeated = step(once, repeated);
        const StencilAutomaton several = make_automaton(power(system, k), degree, cells, max_states);
        EXPECT_LE(several.state_count(), once.state_count());
        const Exact direct = step(several, polygon(several, cells));
        ASSERT_EQ(direct.points, repeated.points) << "degree " << degree << ", " << k << " steps";
        for (std::size_t i = 0; i < direct.states.size(); ++i)
            ASSERT_EQ(several.state(direct.states[i]), once.state(repeated.states[i]));
    }
}

/// All symbols once or more, at least `letters` of them.
Word some_word(const IntervalSystem& system, std::size_t letters) {
    Word word;
    for (std::size_t i = 0; i < std::max(letters, system.rules().size()); ++i)
        word.push_back(to_symbol(i % system.rules().size()));
    return word;
}

enum class Shape { Closed, Open, Clamped };
constexpr Shape shapes[] = {Shape::Closed, Shape::Open, Shape::Clamped};

void expect_power_is_repetition(const IntervalSystem& system, int degree, Shape shape, int most = 3) {
    const auto d = static_cast<std::size_t>(degree);
    switch (shape) {
    case Shape::Closed:
        return expect_power_is_repetition(system, some_word(system, 2), degree, Ends::Circular, most);
    case Shape::Open:
        return expect_power_is_repetition(system, some_word(system, 2 * d + 2), degree, Ends::Open, most);
    case Shape::Clamped:
        return expect_power_is_repetition(system, clamped(some_word(system, 2), degree), degree, Ends::Open, most);
    }
}

/// One or two symbols: every shape, two and three steps. Three symbols: every grammar and degree, shapes in turn.
void expect_power_is_repetition_for(const IntervalSystem& system, std::size_t turn) {
    const bool small = system.alphabet().size() <= 2;
    for (int degree = 1; degree <= 3; ++degree)
        for (const Shape shape : shapes)
            if (small || (turn + static_cast<std::size_t>(degree)) % 3 == static_cast<std::size_t>(shape))
                expect_power_is_repetition(system, degree, shape, small || turn % 4 == 0 ? 3 : 2);
}

/// The grammars in shares, so that several run side by side.
constexpr std::size_t shares = 8;

class PowerOfSmallGrammars : public testing::TestWithParam<std::size_t> {};

TEST_P(PowerOfSmallGrammars, IsRepetition) {
    const std::size_t step = tests::stride(shares);
    const std::vector<IntervalGrammar> grammars = tests::small_grammars(3, 3);
    std::size_t valid = 0;
    for (std::size_t i = GetParam(); i < grammars.size() && !HasFailure(); i += step) {
        const Verdict verdict = validate(grammars[i]);
        if (!verdict.system) continue;
        SCOPED_TRACE(i);
        expect_power_is_repetition_for(*verdict.system, valid++);
    }
    EXPECT_GT(valid, grammars.size() / step / 4);
}

INSTANTIATE_TEST_SUITE_P(All, PowerOfSmallGrammars, testing::Range(std::size_t{0}, shares));

TEST(Power, IsRepetitionForEveryBundledGrammar) {
    for (const auto& [name, system] : tests::bundled_systems()) {
        SCOPED_TRACE(name);
        for (int degree = 1; degree <= 3; ++degree)
            for (const Shape shape : shapes) expect_power_is_repetition(system, degree, shape);
    }
}

TEST(Power, IsRepetitionBetweenEmptyIntervals) {
    const IntervalSystem fibonacci = tests::system_of("L->SL, S->L");
    for (const char* word : {"LS0L", "L00SS0", "S000LL", "0LS00"})
        expect_power_is_repetition(fibonacci, tests::word_of(fibonacci, word), 3, Ends::Circular);
}

TEST(Power, HasTheProductOfTheStepMatrices) {
    const IntervalSystem fibonacci = tests::system_of("L->SL, S->L");
    for (int degree = 1; degree <= 3; ++degree) {
        for (const Ends ends : {Ends::Circular, Ends::Open}) {
            const Word word = some_word(fibonacci, 2 * static_cast<std::size_t>(degree) + 3);
            const reference::Step step = reference::step_of(fibonacci, word, degree, ends);
            EXPECT_EQ(reference::gather_matrix(power(fibonacci, 2), word, degree, ends),
                      reference::product(reference::gather_matrix(fibonacci, step.word, degree, ends),
                                         reference::gather_matrix(fibonacci, word, degree, ends)));
        }
    }
}

TEST(Automaton, AnswersQuestionsAboutItsRows) {
    const IntervalSystem fibonacci = tests::system_of("L->SL, S->L");
    const Word word = clamped(tests::word_of(fibonacci, "LSLLSLSL"), 3);
    const std::vector<CellState> cells = cell_states(word, 3, Ends::Open);
    const StencilAutomaton automaton = make_automaton(fibonacci, 3, cells, max_states);
    std::vector<Word> windows;
    for (std::uint32_t state = 0; state < automaton.state_count(); ++state) {
        const Word& window = automaton.state(state).window;
        if (std::ranges::find(windows, window) == windows.end()) windows.push_back(window);
    }
    EXPECT_EQ(automaton.window_count(), windows.size());
    EXPECT_LT(automaton.window_count(), automaton.state_count());
    for (std::uint32_t row = 0; row < automaton.row_count(); ++row) {
        EXPECT_EQ(automaton.row_sum(row), Number(1));
        const auto [first, last] = automaton.support(row);
        ASSERT_LE(first, last);
        ASSERT_LT(last, automaton.width());
        for (std::size_t i = 0; i < automaton.width(); ++i) {
            const bool inside = i >= first && i <= last;
            EXPECT_TRUE(inside || automaton.weights(row)[i] == 0);
        }
        EXPECT_NE(automaton.weights(row)[first], 0);
        EXPECT_NE(automaton.weights(row)[last], 0);
    }
    // A clamped end keeps its point: the row (1, 0, 0, 0).
    const StencilAutomaton::Child end = automaton.children(automaton.find(cells.front())).front();
    EXPECT_EQ(automaton.support(end.row).last, 0U);
}

} // namespace
} // namespace internode
