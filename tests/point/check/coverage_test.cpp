// SPDX-License-Identifier: MIT

#include "internode/point/check/coverage.h"

#include "internode/grammar/points/parse_points.h"
#include "tests/fixtures/point_systems.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace internode {
namespace {

using tests::point_system;

Coverage coverage_of(std::string_view text) {
    return coverage(point_system(text));
}

const std::string chaikin = "P(u) < P(v) > P(p) -> P(1/4 u + 3/4 v) P(3/4 v + 1/4 p)\n";
const std::string four_point = "P(u) < P(v) > P(p) P(q) -> P(v) P(-1/16 u + 9/16 v + 9/16 p - 1/16 q)\n";

TEST(Coverage, RingsHaveNoEnds) {
    for (const std::string& rule : {chaikin, four_point}) {
        const Coverage result = coverage_of("points\nring\n" + rule);
        EXPECT_TRUE(result.staying.empty());
        EXPECT_TRUE(result.ends_complete);
        EXPECT_TRUE(result.unused.empty());
        EXPECT_EQ(result.points, 12U);
        EXPECT_EQ(result.complete.size(), 12U);
    }
}

TEST(Coverage, EndsOfOpenWordsMayStay) {
    const Coverage result = coverage_of("points\n" + chaikin);
    EXPECT_TRUE(result.ends_complete);
    ASSERT_FALSE(result.staying.empty());
    EXPECT_TRUE(std::ranges::all_of(result.staying, &StayingContext::outermost));
}

TEST(Coverage, PointsInsideTheWordMayNot) {
    // The last point but one has no neighbour after the next: nothing is inserted there.
    const PointSystem system = point_system("points\n" + four_point);
    const Coverage result = coverage(system);
    EXPECT_FALSE(result.ends_complete);
    EXPECT_TRUE(result.complete.empty());
    const auto inside = std::ranges::find(result.staying, false, &StayingContext::outermost);
    ASSERT_NE(inside, result.staying.end());
    EXPECT_EQ(to_string(inside->right, system.grammar().letters), "P");
    EXPECT_EQ(inside->largest, 12U);
}

TEST(Coverage, EndRulesMakeItComplete) {
    const Coverage result = coverage_of("points\ninput # P(v) #\n"
                                        "# < P(v) > P(p) P(q) P(r) -> P(v) P(1/2 v + 1/2 p)\n"
                                        "P(u) < P(v) > P(p) # -> P(v) P(1/2 v + 1/2 p)\n" +
                                        four_point);
    EXPECT_TRUE(result.ends_complete);
    EXPECT_TRUE(result.unused.empty());
    EXPECT_EQ(result.incomplete, (std::vector<std::size_t>{}));
}

TEST(Coverage, AGrammarForThreePointsIsCompleteForThem) {
    const Coverage result =
        coverage_of("points\ninput P(v) | Q(v) | P(v)\n"
                    "P(u) < Q(v) > P(p) -> Q(1/2 u + 1/2 v) P(1/4 u + 1/2 v + 1/4 p) Q(1/2 v + 1/2 p)\n");
    EXPECT_EQ(result.complete, (std::vector<std::size_t>{3}));
    EXPECT_TRUE(result.ends_complete);
    EXPECT_FALSE(result.incomplete.empty());
}

TEST(Coverage, ConditionsAreMeant) {
    const Coverage result = coverage_of("points\nring\ninput P(v, 1)\n"
                                        "P(u, a) < P(v, b) : a = 0 -> P(u, 0) P(1/2 u + 1/2 v, 0)\n");
    EXPECT_TRUE(result.staying.empty()) << "the letters fit, the condition says no";
    EXPECT_EQ(result.unused, (std::vector<std::uint32_t>{0}));
}

TEST(Coverage, LettersThatNothingMultipliesStayAsTheyAre) {
    const Coverage result = coverage_of("points\ninput P(v) E\nE -> E E\n");
    EXPECT_TRUE(result.staying.empty());
    EXPECT_TRUE(result.ends_complete);
}

TEST(Coverage, RulesThatEraseAreUsed) {
    EXPECT_TRUE(coverage_of("points\nP(u) < P(v) -> P(1/2 u + 1/2 v)\nP(v) -> .\n").unused.empty());
    EXPECT_EQ(coverage_of("points\nring\nP(v) -> P(v)\nP(v) -> .\nQ -> Q\n").unused, (std::vector<std::uint32_t>{2}))
        << "a rule that erases counts as used where its letters fit";
}

TEST(Coverage, TablesAreLookedAtOneByOne) {
    const PointSystem system = point_system("points\ntable p\nP(u) < P(v) -> P(u) P(v)\n"
                                            "table q\nP(u) < P(v) -> P(1/2 u + 1/2 v)\ncycle p q\n");
    for (const StayingContext& context : coverage(system).staying) EXPECT_EQ(context.table, 0U);
}

TEST(Coverage, DerivationsThatEndEarlyAreReported) {
    const Coverage result = coverage_of("points\nring\n"
                                        "P(u) < P(v) P(p) > P(q) -> P(-1/4 u + 3/4 v + 3/4 p - 1/4 q)\n");
    ASSERT_TRUE(result.problem);
    EXPECT_EQ(result.problem_points, 1U) << "a single point has no pair";
}

TEST(Coverage, WordsThatExplodeEndTheExploration) {
    const Coverage result = coverage_of("points\nring\nP(v) -> P(v)^1000\n");
    EXPECT_FALSE(result.problem);
    EXPECT_TRUE(result.ends_complete);
}

TEST(Coverage, AxiomsAreExplored) {
    const Coverage result = coverage_of("points\naxiom P((0, 0)) P((1, 0)) P((1, 1)) P((0, 1))\n" + four_point);
    EXPECT_EQ(result.points, 0U);
    EXPECT_FALSE(result.ends_complete);
    ASSERT_FALSE(result.staying.empty());
    EXPECT_EQ(result.staying.front().largest, 0U);
}

} // namespace
} // namespace internode
