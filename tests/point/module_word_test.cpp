// SPDX-License-Identifier: MIT

#include "internode/point/module_word.h"

#include "internode/point/start_word.h"
#include "internode/point/strands.h"
#include "tests/point/systems.h"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ModuleWord, PrintsNumbersAndPoints) {
    const PointSystem system =
        point_system("points\naxiom A(4) A(3.5) P((0, 1/3), 2) E [ Q((1, 2, 3)) ]\nA(x) -> A(x)\n");
    EXPECT_EQ(shown(system, axiom_word(system)), "A(4) A(3.5) P((0, 0.3333333333333333), 2) E [ Q((1, 2, 3)) ]");
}

TEST(ModuleWord, TheInputSaysWhatPointsBecome) {
    const std::vector<double> points{0, 1, 2, 3, 4, 5};
    const auto word = [&](const std::string& input, std::span<const double> some) {
        const PointSystem system = point_system("points\n" + input + "P(v, s) -> P(v, s)\nQ(v) -> Q(v)\n");
        return shown(system, input_word(system, some));
    };
    EXPECT_EQ(word("input P(v, 2) E | P(v, 0) E | P(v, 2)\n", points), "P((0, 1), 2) E P((2, 3), 0) E P((4, 5), 2)");
    EXPECT_EQ(word("input P(v, 2) E | P(v, 0) E | P(v, 2)\n", std::span(points).first(4)),
              "P((0, 1), 2) E P((2, 3), 2)");
    EXPECT_EQ(word("input # Q(v) #\n", points), "# Q((0, 1)) Q((2, 3)) Q((4, 5)) #");
    EXPECT_EQ(word("input Q(1/2 v) E\n", points), "Q((0, 0.5)) E Q((1, 1.5)) E Q((2, 2.5)) E");
}

TEST(ModuleWord, WithoutAnInputPointsBecomeP) {
    const PointSystem system = point_system("points\nP(v) -> P(v)\n", {.dimension = 3});
    EXPECT_EQ(shown(system, input_word(system, std::vector<double>{1, 2, 3, 4, 5, 6})), "P((1, 2, 3)) P((4, 5, 6))");
    const PointSystem both = point_system("points\naxiom P((0, 0))\nP(v) -> P(v)\n");
    EXPECT_EQ(shown(both, input_word(both, std::vector<double>{1, 2})), "P((1, 2))");
}

TEST(ModuleWord, RefusesPolygonsThatAreNone) {
    const PointSystem system = point_system("points\nP(v) -> P(v)\n");
    EXPECT_THROW(static_cast<void>(input_word(system, {})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(input_word(system, std::vector<double>{1, 2, 3})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(input_word(system, std::vector<double>{1, std::numeric_limits<double>::infinity()})),
                 std::invalid_argument);
    const PointSystem numbers = point_system("points\naxiom P(1)\nP(v) -> P(v)\n");
    EXPECT_THROW(static_cast<void>(input_word(numbers, std::vector<double>{1, 2})), std::invalid_argument);
    const PointSystem axiom = point_system("points\naxiom P((1, 2))\nP(v) -> P(v)\n", {.start = PointStart::Axiom});
    EXPECT_THROW(static_cast<void>(input_word(axiom, std::vector<double>{1, 2})), std::invalid_argument);
}

TEST(ModuleWord, RefusesAnAxiomThatIsNotThere) {
    const PointSystem system = point_system("points\nP(v) -> P(v)\n");
    EXPECT_THROW(static_cast<void>(axiom_word(system)), std::invalid_argument);
    const PointSystem input = point_system("points\naxiom P((1, 2))\nP(v) -> P(v)\n", {.start = PointStart::Input});
    EXPECT_THROW(static_cast<void>(axiom_word(input)), std::invalid_argument);
}

PointStrands drawn(const std::string& axiom, bool ring = false) {
    const PointSystem system =
        point_system(std::string("points\n") + (ring ? "ring\n" : "") + "axiom " + axiom + "\nP(v) -> P(v)\n");
    return strands(axiom_word(system), system, 0);
}

TEST(Strands, JoinPointsAlongTheWord) {
    const PointStrands open = drawn("P((1, 2)) E P((3, 4)) A(5)");
    EXPECT_EQ(open.dimension, 2U);
    EXPECT_THAT(open.points, ElementsAre(1, 2, 3, 4));
    ASSERT_EQ(open.strands.size(), 1U);
    EXPECT_THAT(open.strands[0].points, ElementsAre(0, 1));
    EXPECT_FALSE(open.strands[0].closed);
    EXPECT_TRUE(drawn("P((1, 2)) P((3, 4))", true).strands[0].closed);
}

TEST(Strands, BranchesBeginAtThePointBeforeThem) {
    const PointStrands tree = drawn("P((0, 0)) [ E P((1, 0)) [ P((2, 0)) ] P((3, 0)) ] [ E ] P((4, 0))");
    ASSERT_EQ(tree.strands.size(), 3U);
    EXPECT_THAT(tree.strands[0].points, ElementsAre(0, 4));
    EXPECT_THAT(tree.strands[1].points, ElementsAre(0, 1, 3));
    EXPECT_THAT(tree.strands[2].points, ElementsAre(1, 2));
}

TEST(Strands, ABranchAtTheBeginningOfARingBeginsAtItsEnd) {
    const PointStrands tree = drawn("[ P((0, 0)) ] P((1, 0)) P((2, 0)) [ P((3, 0)) ]", true);
    ASSERT_EQ(tree.strands.size(), 3U);
    EXPECT_THAT(tree.strands[0].points, ElementsAre(2, 0));
    EXPECT_FALSE(tree.strands[0].closed);
    EXPECT_THAT(tree.strands[1].points, ElementsAre(1, 2));
    EXPECT_TRUE(tree.strands[1].closed);
}

TEST(Strands, ModulesWithTwoPointsAreLines) {
    const PointStrands lines = drawn("L((0, 1), 7, (2, 3)) P((4, 5)) T((0, 0), (1, 1), (2, 2)) L((6, 7), 8, (9, 10))");
    EXPECT_THAT(lines.lines, ElementsAre(0, 1, 2, 3, 6, 7, 9, 10));
    EXPECT_THAT(lines.points, ElementsAre(4, 5));
}

TEST(Strands, KeepTheDimensionOfTheFirst) {
    const PointStrands mixed = drawn("A(1) P((4, 5)) Q((1, 2, 3)) P((6, 7))");
    EXPECT_EQ(mixed.dimension, 2U);
    EXPECT_EQ(mixed.size(), 2U);
    EXPECT_EQ(drawn("A(1)").size(), 0U);
    EXPECT_THAT(drawn("A(1)").strands, IsEmpty());
}

} // namespace
} // namespace internode
