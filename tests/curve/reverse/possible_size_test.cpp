// SPDX-License-Identifier: MIT

#include "internode/curve/reverse/possible_size.h"

#include "internode/curve/refinement.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/random_curve.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using tests::fibonacci;
using tests::system_of;
using tests::word_of;

/// The points of a curve with these knots after the levels, by refining the word.
std::uint64_t refined(const IntervalSystem& system, const CoarseWord& coarse, const PossibleSize& size) {
    const Ends ends = coarse.ends == PolygonEnds::Closed ? Ends::Circular : Ends::Open;
    const CheckedKnots knots = make_knots(system, {coarse.degree, ends, size.word});
    EXPECT_TRUE(knots.knots.has_value());
    return refined_knots(*knots.knots, size.levels).size();
}

TEST(PossibleSize, AgreesWithTheRefinedWords) {
    for (const auto& [name, text] : tests::sample_systems()) {
        const IntervalSystem system = system_of(text);
        Word letters;
        for (std::size_t i = 0; i < system.alphabet().size(); ++i) letters.push_back(to_symbol(i));
        for (const PolygonEnds ends : {PolygonEnds::Open, PolygonEnds::Closed, PolygonEnds::Clamped})
            for (int levels = 0; levels <= 3; ++levels)
                for (std::uint64_t points = 5; points < 60; points += 7) {
                    const CoarseWord coarse{letters, true, ends, 3};
                    const PossibleSizes sizes = possible_sizes(system.rules(), coarse, levels, points);
                    ASSERT_TRUE(sizes.above) << name;
                    EXPECT_EQ(refined(system, coarse, *sizes.above), sizes.above->points) << name;
                    EXPECT_GE(sizes.above->points, points);
                    if (!sizes.below) continue;
                    EXPECT_EQ(refined(system, coarse, *sizes.below), sizes.below->points) << name;
                    EXPECT_LE(sizes.below->points, points);
                    // Nothing fits between: one letter more than below is above, or both are the same.
                    EXPECT_LE(sizes.above->word.size(), sizes.below->word.size() + 1);
                    EXPECT_EQ(sizes.exact(), sizes.below->points == points);
                }
    }
}

TEST(PossibleSize, FindsTheLevelsOfAGivenWord) {
    const Morphism rules = fibonacci().rules(); // |σ^s(A)| = 1, 2, 3, 5, 8, 13, …
    const CoarseWord coarse{{to_symbol(0)}, false, PolygonEnds::Closed, 2};
    const PossibleSizes exact = possible_sizes(rules, coarse, {}, 13);
    ASSERT_TRUE(exact.exact());
    EXPECT_EQ(exact.below->levels, 5);
    const PossibleSizes between = possible_sizes(rules, coarse, {}, 10);
    EXPECT_EQ(between.below->points, 8u);
    EXPECT_EQ(between.above->points, 13u);
    EXPECT_FALSE(between.exact());
    const PossibleSizes fixed = possible_sizes(rules, coarse, 3, 10);
    EXPECT_EQ(fixed.below->points, 5u);
    EXPECT_FALSE(fixed.above);
}

TEST(PossibleSize, TakesTheFewestLevelsWhereNothingSplits) {
    const IntervalSystem system = system_of("A->DD, B->A, C->B, D->C");
    const PossibleSizes sizes =
        possible_sizes(system.rules(), {word_of(system, "D"), false, PolygonEnds::Closed, 2}, {}, 2);
    ASSERT_TRUE(sizes.exact());
    EXPECT_EQ(sizes.above->levels, 4);
}

TEST(PossibleSize, EndsADomainWithALength) {
    const Word pattern{to_symbol(0), zero_interval};
    const PossibleSizes sizes =
        possible_sizes(fibonacci().rules(), {pattern, true, PolygonEnds::Clamped, 2}, 0, 6); // A0A0: not a domain
    EXPECT_EQ(sizes.below->points, 5u);
    EXPECT_EQ(sizes.above->points, 7u);
    const Word zero{zero_interval};
    EXPECT_FALSE(possible_sizes(fibonacci().rules(), {zero, true, PolygonEnds::Closed, 2}, 1, 6).above);
}

TEST(PossibleSize, RefusesWhatCannotBeAnswered) {
    const Morphism rules = fibonacci().rules();
    const Word one{to_symbol(0)};
    EXPECT_THROW((void)possible_sizes(rules, {{}, false, PolygonEnds::Closed, 2}, 1, 6), std::invalid_argument);
    EXPECT_THROW((void)possible_sizes(rules, {one, true, PolygonEnds::Closed, 2}, {}, 6), std::invalid_argument);
    EXPECT_THROW((void)possible_sizes(rules, {one, true, PolygonEnds::Closed, 2}, -1, 6), std::invalid_argument);
}

} // namespace
} // namespace internode
