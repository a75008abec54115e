// SPDX-License-Identifier: MIT

#include "internode/spline/exact_work.h"

#include "internode/interval/decomposition_graph.h"
#include "internode/spline/window.h"
#include "internode/stencil/automaton.h"
#include "tests/fixtures/interval_systems.h"

#include <gmock/gmock.h>

#include <limits>
#include <vector>

namespace internode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tests::sample_systems;
using tests::system_of;

std::vector<CellState> all_cells(const IntervalSystem& system, int degree) {
    std::vector<CellState> cells;
    const std::size_t letters = 2 * static_cast<std::size_t>(degree) - 1;
    for (const Word& window : word_graph(system, letters, WordChoice::Persistent, 10'000).words)
        for (std::uint32_t lead = 0; lead <= static_cast<std::uint32_t>(degree); ++lead)
            cells.push_back({window, lead});
    return cells;
}

TEST(ExactWork, IsAnnouncedOnceAndBoundsTheRowsThatAreDerived) {
    for (const auto& [name, text] : sample_systems())
        for (const int degree : {1, 2, 3}) {
            SCOPED_TRACE(name);
            const IntervalSystem system = system_of(text);
            std::vector<std::uint64_t> announced;
            ExactLimits limits(10'000);
            limits.announce = [&](std::uint64_t work) { announced.push_back(work); };
            const StencilAutomaton automaton = make_automaton(system, degree, all_cells(system, degree), limits);
            ASSERT_EQ(announced.size(), 1U);
            // A step of a blossom or a division of a piece is at least one operation on a coefficient of each number.
            std::uint64_t steps = 0;
            const auto triangle = static_cast<std::uint64_t>(degree * (degree + 1) / 2);
            for (std::uint32_t state = 0; state < automaton.state_count(); ++state)
                steps += triangle * (1 + automaton.children(state).size());
            EXPECT_GE(announced[0], steps * static_cast<std::uint64_t>(system.field().degree()));
        }
}

TEST(ExactWork, IsRefusedBeforeItStartsWithBothNumbers) {
    const IntervalSystem system = system_of("A->AB, B->AC, C->A");
    std::vector<std::uint64_t> announced;
    ExactLimits limits(10'000);
    limits.announce = [&](std::uint64_t work) { announced.push_back(work); };
    (void)make_automaton(system, 3, all_cells(system, 3), limits);
    limits.work = announced.at(0);
    EXPECT_NO_THROW((void)make_automaton(system, 3, all_cells(system, 3), limits));
    announced.clear();
    --limits.work;
    try {
        (void)make_automaton(system, 3, all_cells(system, 3), limits);
        FAIL() << "not refused";
    } catch (const LimitExceeded& refusal) {
        EXPECT_THAT(refusal.what(), HasSubstr(std::to_string(limits.work + 1) + " units"));
        EXPECT_THAT(refusal.what(), HasSubstr("limit of " + std::to_string(limits.work)));
    }
    EXPECT_TRUE(announced.empty());
    // Without rows there is no exact work.
    limits.work = 0;
    EXPECT_NO_THROW((void)make_automaton(system, 3, all_cells(system, 3), limits, AutomatonRows::None));
}

TEST(ExactWork, GrowsWithDegreeAndFieldAndSaturates) {
    const IntervalSystem bisection = system_of("A->AA");
    const IntervalSystem quartic = system_of("A->AB, B->AC, C->AD, D->A");
    EXPECT_EQ(exact_work(bisection, 1, {1, 1}) * 6, exact_work(bisection, 3, {1, 1}));
    EXPECT_LT(exact_work(bisection, 3, {1, 1}), exact_work(quartic, 3, {1, 1}));
    EXPECT_EQ(exact_work(bisection, 3, {2, 5}), 7 * exact_work(bisection, 3, {1, 0}));
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    EXPECT_EQ(exact_work(bisection, 12, {most / 2, most / 2}), most);
}

TEST(ExactWork, ChildWindowsAreThoseOfTheRows) {
    for (const auto& [name, text] : sample_systems()) {
        SCOPED_TRACE(name);
        const IntervalSystem system = system_of(text);
        for (const Word& window : word_graph(system, 5, WordChoice::Persistent, 10'000).words)
            EXPECT_EQ(child_windows(system.rules(), window), window_stencils(system, window).child_windows);
    }
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    EXPECT_THAT(child_windows(fibonacci.rules(), tests::word_of(fibonacci, "SLS")),
                ElementsAre(tests::word_of(fibonacci, "LSL"), tests::word_of(fibonacci, "SLL")));
}

} // namespace
} // namespace internode
