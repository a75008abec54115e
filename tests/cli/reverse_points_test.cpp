// SPDX-License-Identifier: MIT
//
// reverse with a point grammar: derived rules, grammars that reduce, numbers of points, phases, pictures.

#include "tests/cli/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace internode::tests {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr const char* coast_file = "data/curves/iceland-coast.csv";

TEST(ReversePoints, TakesTheCoastFourLevelsDownInBothPhases) {
    const Workspace here;
    const Outcome even = here.run({"reverse", "@s0/13", coast_file, "-n", "4", "--cut"});
    ASSERT_EQ(even.code, 0) << even.err;
    EXPECT_THAT(even.out, HasSubstr("4820 points, the last 4 cut off: 4816"));
    EXPECT_THAT(even.out, HasSubstr("P(v_l) < P(v_a) P(v_b) > P(v_r) -> P(-1/4 v_l + 3/4 v_a + 3/4 v_b - 1/4 v_r)"));
    EXPECT_THAT(even.out, HasSubstr("     4     301"));
    const Outcome odd = here.run({"reverse", "@s0/13", coast_file, "-n", "4", "--cut", "--phase", "1"});
    EXPECT_NE(even.out, odd.out);
}

TEST(ReversePoints, TheDerivedRuleAndEquation38AreTheSame) {
    const Workspace here;
    for (const char* phase : {"0", "1"}) {
        const Outcome derived =
            here.run({"reverse", "@s0/13", coast_file, "-n", "3", "--cut", "--phase", phase, "--format", "csv"});
        const Outcome typed =
            here.run({"reverse", "@s0/38", coast_file, "-n", "3", "--cut", "--phase", phase, "--format", "csv"});
        ASSERT_EQ(derived.code, 0) << derived.err;
        EXPECT_EQ(derived.out, typed.out);
    }
}

TEST(ReversePoints, GivesBackThePolygonThatWasRefined) {
    const Workspace here;
    ASSERT_EQ(here.run({"subdivide", "@s0/13", "data/curves/pebble.csv", "-n", "2", "-o", "fine.csv"}).code, 0);
    const Outcome back = here.run({"reverse", "@s0/13", "fine.csv", "-n", "2", "--format", "csv"});
    ASSERT_EQ(back.code, 0) << back.err;
    EXPECT_EQ(back.out, here.run({"subdivide", "@s0/13", "data/curves/pebble.csv", "-n", "0"}).out);
}

TEST(ReversePoints, WritesItsRulesAsAGrammar) {
    const Workspace here;
    const Outcome cubic = here.run({"reverse", "@s0/22", "--rules"});
    ASSERT_EQ(cubic.code, 0) << cubic.err;
    EXPECT_THAT(cubic.out, HasSubstr("gain 3\npoints \"s0/22 reversed\"\nring\n"));
    EXPECT_THAT(cubic.out, EndsWith("P(v_l) < P(v_a) P(v_b) -> P(-1/2 v_l + 2 v_a - 1/2 v_b)\n"));
    ASSERT_EQ(here.run({"reverse", "@s0/22", "--rules", "-o", "back.lsys"}).code, 0);
    EXPECT_EQ(here.run({"format", "back.lsys"}).code, 0);
    EXPECT_THAT(here.run({"reverse", "@s0/22", "--rules", "--window", "7"}).out, HasSubstr("v_ll"));
    EXPECT_THAT(here.run({"reverse", "@s0/25", "--rules"}).out, EndsWith("P(v_a) P(v_b) -> P(v_a)\n"));
    EXPECT_EQ(here.run({"reverse", "@s0/38", "--rules"}).code, 2);
}

TEST(ReversePoints, DrawsTheOriginalAndAllPhases) {
    const Workspace here;
    const Outcome done = here.run({"reverse", "@s0/38", coast_file, "-n", "4", "--cut", "-q", "--picture", "phases.svg",
                                   "--coarse", "coarse.csv"});
    ASSERT_EQ(done.code, 0) << done.err;
    const std::string picture = here.read("phases.svg");
    EXPECT_THAT(picture, HasSubstr(">original: 4816 points<"));
    EXPECT_THAT(picture, HasSubstr(">phase 0: 301 points<"));
    EXPECT_THAT(picture, HasSubstr(">phase 1: 301 points<"));
    EXPECT_THAT(here.read("coarse.csv"), testing::StartsWith("x_km,y_km\n"));
    ASSERT_EQ(here.run({"reverse", "@s0/38", coast_file, "-n", "4", "--cut", "-o", "same.svg"}).code, 0);
}

TEST(ReversePoints, SaysWhichNumbersOfPointsArePossible) {
    const Workspace here;
    const Outcome refused = here.run({"reverse", "@s0/13", coast_file, "-n", "4"});
    EXPECT_EQ(refused.code, 3);
    EXPECT_THAT(refused.err, HasSubstr("--cut to 4816, --resample to the nearer of 4816 and 4832"));
    EXPECT_THAT(here.run({"reverse", "@s0/13", coast_file, "-n", "4", "--resample"}).out,
                HasSubstr("resampled to 4816"));
    EXPECT_EQ(here.run({"reverse", "@s0/13", "data/curves/pebble.csv", "-n", "60"}).code, 3);
    EXPECT_EQ(here.run({"reverse", "@s0/13", "data/curves/pebble.csv", "-n", "18446744073709551615"}).code, 3);
}

TEST(ReversePoints, RefusesWhatBelongsToOtherKinds) {
    const Workspace here;
    EXPECT_EQ(here.run({"reverse", "@s0/13", coast_file, "-n", "1", "-d", "2"}).code, 2);
    EXPECT_EQ(here.run({"reverse", "@s0/13", coast_file, "-n", "1", "--word", "L"}).code, 2);
    EXPECT_EQ(here.run({"reverse", "@s0/13"}).code, 2);
    EXPECT_EQ(here.run({"reverse", "@fibonacci"}).code, 2);
    EXPECT_EQ(here.run({"reverse", "@fibonacci", "data/curves/leaf.csv", "-d", "2", "--phase", "1"}).code, 2);
    const Outcome open = here.run({"reverse", "@s0/34-36", coast_file});
    EXPECT_EQ(open.code, 3);
    EXPECT_THAT(open.err, HasSubstr("open words"));
    EXPECT_EQ(
        here.run({"reverse", "-e", "points halves; ring; P(u) < P(v) -> P(1/2 u + 1/2 v) P(1/2 u + 1/2 v)", "--rules"})
            .code,
        3);
}

} // namespace
} // namespace internode::tests
