// SPDX-License-Identifier: MIT

#include "internode/report/mask_table.h"

#include "tests/report/systems.h"

#include <set>

namespace internode {
namespace {

using testing_report::fibonacci;
using testing_report::system_of;

constexpr std::size_t plenty = 10'000;

TEST(MaskTable, FibonacciHasDPlusTwoWordsAndTwoDWindows) {
    const IntervalSystem system = system_of(fibonacci);
    for (int degree = 1; degree <= 5; ++degree) {
        const MaskTable table = make_mask_table(system, degree, WordChoice::Default, plenty);
        EXPECT_EQ(table.choice, WordChoice::Persistent);
        EXPECT_EQ(table.graph.words.size(), static_cast<std::size_t>(degree) + 2);
        EXPECT_EQ(table.windows.size(), 2 * static_cast<std::size_t>(degree));
        EXPECT_EQ(table.masks.size(), table.graph.words.size());
        for (const WindowRow& row : table.windows) EXPECT_TRUE(row.persistent);
    }
}

TEST(MaskTable, WindowsAreClosedUnderChildrenAndStandOnce) {
    for (const char* const text : {"intervals\nL -> S L\nS -> L\naxiom (S S S S S)", "A -> A A\naxiom 0^3 A A A A 0^3",
                                   "L -> S L\nS -> L\naxiom L S L L S L L S L"}) {
        const MaskTable table = make_mask_table(system_of(text), 3, WordChoice::Default, plenty);
        std::set<Word> seen;
        for (const WindowRow& row : table.windows) {
            EXPECT_TRUE(seen.insert(row.stencils.window).second);
            ASSERT_EQ(row.children.size(), row.stencils.child_windows.size());
            for (std::size_t c = 0; c < row.children.size(); ++c)
                EXPECT_EQ(table.windows.at(row.children[c]).stencils.window, row.stencils.child_windows[c]);
        }
    }
}

TEST(MaskTable, AnAxiomAddsTransientWindows) {
    const MaskTable table = make_mask_table(system_of(fibonacci + "axiom (S S S S S)"), 3, WordChoice::Default, plenty);
    EXPECT_EQ(table.choice, WordChoice::Reachable);
    EXPECT_EQ(table.windows.size(), 9U);
    EXPECT_FALSE(table.windows.front().persistent);
    EXPECT_FALSE(table.has_leading);
}

TEST(MaskTable, OnlyEndsAndEmptyIntervalsHaveLeadingCells) {
    EXPECT_TRUE(make_mask_table(system_of("A -> A A\naxiom A A A A A"), 2, WordChoice::Default, plenty).has_leading);
    EXPECT_TRUE(make_mask_table(system_of("A -> A A\naxiom (A 0 A)"), 2, WordChoice::Default, plenty).has_leading);
}

TEST(MaskTable, AllTakesEveryWord) {
    const MaskTable table = make_mask_table(system_of(fibonacci), 2, WordChoice::All, plenty);
    EXPECT_EQ(table.masks.size(), 8U);
    EXPECT_EQ(table.windows.size(), 8U);
}

TEST(MaskTable, RefusesWhatDoesNotFit) {
    const IntervalSystem system = system_of(fibonacci);
    EXPECT_THROW((void)make_mask_table(system, 0, WordChoice::Default, plenty), std::invalid_argument);
    EXPECT_THROW((void)make_mask_table(system, 13, WordChoice::Default, plenty), std::invalid_argument);
    EXPECT_THROW((void)make_mask_table(system, 2, WordChoice::Reachable, plenty), std::invalid_argument);
    EXPECT_THROW((void)make_mask_table(system, 8, WordChoice::All, 1000), TooManyWords);
    EXPECT_THROW((void)make_mask_table(system, 3, WordChoice::Persistent, 3), TooManyWords);
    const IntervalSystem with_axiom = system_of(fibonacci + "axiom S L L S");
    EXPECT_THROW((void)make_mask_table(with_axiom, 2, WordChoice::Default, plenty), std::invalid_argument);
    EXPECT_NO_THROW((void)make_mask_table(with_axiom, 1, WordChoice::Default, plenty));
}

TEST(MaskTable, CountsItsExactWorkBeforeItStarts) {
    for (const WordChoice choice : {WordChoice::Persistent, WordChoice::All}) {
        const IntervalSystem system = system_of(fibonacci);
        ExactLimits limits(plenty);
        std::uint64_t work = 0;
        limits.announce = [&](std::uint64_t announced) { work = announced; };
        const MaskTable table = make_mask_table(system, 3, choice, limits);
        ExactCounts derived;
        for (const Mask& mask : table.masks) derived.rows += mask.entries.size();
        for (const WindowRow& window : table.windows)
            derived.rows += 1 + window.stencils.children.size() + window.stencils.leading.size();
        EXPECT_GE(work, exact_work(system, 3, derived));
        limits.work = work - 1;
        EXPECT_THROW((void)make_mask_table(system, 3, choice, limits), TooMuchWork);
    }
}

TEST(MaskTable, OfWholeMinutesIsRefused) {
    const IntervalSystem tribonacci = system_of("A->AB, B->AC, C->A");
    EXPECT_THROW((void)make_mask_table(tribonacci, 6, WordChoice::All, 200'000), TooMuchWork);
}

} // namespace
} // namespace internode
