// SPDX-License-Identifier: MIT
//
// infer: what it writes can be read again as a grammar; what it refuses, and with which exit code.

#include "tests/cli/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace internode::tests {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(Infer, WritesTheProductionsOfThePaper) {
    const Workspace here;
    const Outcome chaikin = here.run({"infer", "data/matrices/chaikin.csv"});
    EXPECT_EQ(chaikin.code, 0) << chaikin.err;
    EXPECT_THAT(chaikin.out,
                EndsWith("points chaikin\nring\nP(v_l) < P(v) > P(v_r) -> P(1/4 v_l + 3/4 v) P(3/4 v + 1/4 v_r)\n"));
    EXPECT_THAT(chaikin.out, HasSubstr("//   d = -1    P(v_l) < P(v) -> P(3/4 v_l + 1/4 v) P(1/4 v_l + 3/4 v)\n"));
    EXPECT_THAT(here.run({"infer", "data/matrices/cubic.csv"}).out,
                EndsWith("-> P(1/8 v_l + 3/4 v + 1/8 v_r) P(1/2 v + 1/2 v_r)\n"));
    EXPECT_THAT(here.run({"infer", "data/matrices/four-point.csv"}).out,
                EndsWith("-> P(v) P(-1/16 v_l + 9/16 v + 9/16 v_r - 1/16 v_rr)\n"));
}

TEST(Infer, TakesAnyShiftOfTheMatrixAndNoOther) {
    const Workspace here;
    EXPECT_THAT(here.run({"infer", "data/matrices/chaikin.csv", "--shift", "-1"}).out,
                EndsWith("P(v_l) < P(v) -> P(3/4 v_l + 1/4 v) P(1/4 v_l + 3/4 v)\n"));
    EXPECT_THAT(here.run({"infer", "data/matrices/chaikin.csv", "--shift=5"}).out,
                EndsWith("P(v) > P(v_r) P(v_rr) P(v_rrr) -> P(3/4 v_rr + 1/4 v_rrr) P(1/4 v_rr + 3/4 v_rrr)\n"));
    const Outcome beyond = here.run({"infer", "data/matrices/chaikin.csv", "--shift", "12"});
    EXPECT_EQ(beyond.code, 2);
    EXPECT_THAT(beyond.err, HasSubstr("12 rows allow -11 to 11"));
    EXPECT_EQ(here.run({"infer", "data/matrices/chaikin.csv", "--shift", "x"}).code, 2);
}

TEST(Infer, OpenCurvesHaveTwoForms) {
    const Workspace here;
    const Outcome ordered = here.run({"infer", "data/matrices/chaikin-open.csv", "--open", "--name", "s0/34-36"});
    EXPECT_EQ(ordered.code, 0) << ordered.err;
    EXPECT_THAT(ordered.out, HasSubstr("right for 4 points or more"));
    EXPECT_THAT(ordered.out, HasSubstr("// regular from row 3 to row 10\n"));
    EXPECT_THAT(ordered.out, HasSubstr("//   # -> #\n"));
    EXPECT_THAT(ordered.out, EndsWith("\nP(v_l) < P(v) > P(v_r) -> P(1/4 v_l + 3/4 v) P(3/4 v + 1/4 v_r)\n"));
    const Outcome full =
        here.run({"infer", "data/matrices/chaikin-open.csv", "--open", "--long", "--name", "s0/28-33"});
    EXPECT_THAT(full.out, EndsWith("P(v) > # -> P(v)\n# -> #\n"));
}

TEST(Infer, OpenCurvesLeaveOutTheShiftsThatTheirEndsRefuse) {
    const Workspace here;
    const std::string matrix = "0 0 0 1\n3/4 1/4 0 0\n0 3/4 1/4 0\n0 0 3/4 1/4\n";
    const Outcome ring_shift = here.run({"infer", "-", "--open", "--shift", "1"}, matrix);
    EXPECT_EQ(ring_shift.code, 3);
    EXPECT_THAT(ring_shift.err, HasSubstr("near the other end"));
    const Outcome other = here.run({"infer", "-", "--open"}, matrix);
    EXPECT_EQ(other.code, 0) << other.err;
    EXPECT_THAT(other.out, EndsWith("# < P(v) > P(v_r) P(v_rr) P(v_rrr) -> P(v_rrr)\nP(v_l) < P(v) -> "
                                    "P(3/4 v_l + 1/4 v)\n"));
}

TEST(Infer, WritesAFileThatIsAGrammar) {
    const Workspace here;
    ASSERT_EQ(here.run({"infer", "data/matrices/chaikin-open.csv", "--open", "-o", "open.lsys"}).code, 0);
    EXPECT_THAT(here.read("open.lsys"), HasSubstr("\npoints \"chaikin-open\"\ninput "));
    EXPECT_EQ(here.run({"infer", "-"}, "%%MatrixMarket matrix array integer general\n2 1\n1\n1\n").code, 3);
    const Outcome piped = here.run({"infer", "-"}, "1 0 0\n1 0 0\n0 1 0\n0 1 0\n0 0 1\n0 0 1\n");
    EXPECT_EQ(piped.code, 0) << piped.err;
    EXPECT_THAT(piped.out, EndsWith("points inferred\nring\nP(v) -> P(v) P(v)\n"));
}

TEST(Infer, ReportsDotsAndIrregularRows) {
    const Workspace here;
    const Outcome dots = here.run({"infer", "-"}, "3/4, 1/4, 0\n:, :, :\n0, 1/4, 3/4\n");
    EXPECT_EQ(dots.code, 3);
    EXPECT_THAT(dots.err, HasSubstr("<stdin>:2:1: error: irregular: `:` cannot be interpreted"));
    const Outcome irregular = here.run({"infer", "-"}, "1 0 0\n1 0 0\n0 1 0\n0 1 0\n0 0 1\n0 1/2 1/2\n");
    EXPECT_EQ(irregular.code, 3);
    EXPECT_THAT(irregular.err, HasSubstr("row 6 breaks the pattern of row 2"));
    EXPECT_THAT(here.run({"infer", "-"}, "1 0 0 0\n0 1 0 0\n0 0 1/2 1/2\n1/2 0 0 1/2\n").err,
                HasSubstr("row 1 breaks the pattern of row 3"))
        << "of two patterns with as many rows, the first in the order of weights";
    EXPECT_THAT(here.run({"infer", "-"}, "1 0 0\n1/2 0 0\n0 1 0\n0 1/2 0\n0 0 1\n0 0 1/2\n").out,
                HasSubstr("// not affine: the weights of rows 2, 4, 6 do not sum to 1\n"));
}

TEST(Infer, RefusesWithTheReason) {
    const Workspace here;
    EXPECT_EQ(here.run({"infer"}).code, 2);
    EXPECT_EQ(here.run({"infer", "none.csv"}).code, 4);
    EXPECT_THAT(here.run({"infer", "data/matrices/chaikin-open.csv"}).err, HasSubstr("--open"));
    EXPECT_EQ(here.run({"infer", "data/matrices/chaikin.csv", "--open"}).code, 3);
    EXPECT_EQ(here.run({"infer", "data/matrices/chaikin.csv", "-o", "x.json"}).code, 2);
}

} // namespace
} // namespace internode::tests
