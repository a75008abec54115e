// SPDX-License-Identifier: MIT
//
// masks with a point grammar, and infer of what it writes: the identity on the schemes of the paper.

#include "tests/cli/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace internode::tests {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

TEST(MasksPoints, WritesTheMatrixOfThePaper) {
    const Workspace here;
    const Outcome four = here.run({"masks", "@s0/13", "--points", "4", "--format", "csv"});
    ASSERT_EQ(four.code, 0) << four.err;
    EXPECT_EQ(four.out, "3/4, 0, 0, 1/4\n3/4, 1/4, 0, 0\n1/4, 3/4, 0, 0\n0, 3/4, 1/4, 0\n"
                        "0, 1/4, 3/4, 0\n0, 0, 3/4, 1/4\n0, 0, 1/4, 3/4\n1/4, 0, 0, 3/4\n")
        << "eq. 7";
    EXPECT_THAT(here.run({"masks", "@s0/13", "--points", "4", "--matrix"}).out, HasSubstr("\n8 4 16\n1 1 0.75\n"));
    EXPECT_THAT(here.run({"masks", "@s0/13"}).out, HasSubstr("1/4  3/4  3/4  1/4"));
}

TEST(MasksPoints, InferenceOfTheMatrixIsTheGrammar) {
    const Workspace here;
    for (const char* name : {"13", "17", "18", "20", "22", "23", "25", "26"}) {
        const std::string grammar = std::string("@s0/") + name;
        ASSERT_EQ(here.run({"masks", grammar, "--points", "9", "-o", "m.csv"}).code, 0);
        const Outcome inferred = here.run({"infer", "m.csv", "--shift", "0", "--name", std::string("s0/") + name});
        ASSERT_EQ(inferred.code, 0) << inferred.err;
        EXPECT_THAT(inferred.out, EndsWith(here.run({"format", grammar}).out)) << name;
    }
    for (const char* form : {"28-33", "34-36"}) {
        const std::string grammar = std::string("@s0/") + form;
        ASSERT_EQ(here.run({"masks", grammar, "--points", "9", "-o", "m.mtx"}).code, 0);
        std::vector<std::string> command{"infer", "m.mtx", "--open", "--name", std::string("s0/") + form};
        if (form[0] == '2') command.emplace_back("--long");
        const Outcome inferred = here.run(command);
        ASSERT_EQ(inferred.code, 0) << inferred.err;
        const Outcome formatted = here.run({"format", grammar});
        ASSERT_EQ(formatted.code, 0);
        EXPECT_THAT(inferred.out, EndsWith(formatted.out)) << form;
    }
}

TEST(MasksPoints, WritesTheAutomaton) {
    const Workspace here;
    const Outcome json = here.run({"masks", "@s0/22", "--automaton"});
    ASSERT_EQ(json.code, 0) << json.err;
    EXPECT_THAT(json.out, HasSubstr("\"internode-cells\""));
    EXPECT_THAT(json.out, HasSubstr("\"1/8\", \"3/4\", \"1/8\""));
    EXPECT_THAT(here.run({"masks", "@s0/34-36", "--format", "c"}).out,
                HasSubstr("static inline size_t s0_34_36_step("));
    EXPECT_THAT(here.run({"masks", "@s0/22", "--format", "glsl"}).out, HasSubstr("s0_22_step(uint cell)"));
}

/// Chaikin on an open square by the C header, against subdivide.
TEST(MasksPoints, TheCHeaderDoesWhatSubdivideDoes) {
    const Workspace here;
    ASSERT_EQ(here.run({"masks", "@s0/34-36", "--points", "4", "-o", "step.h"}).code, 0);
    here.file("main.c", R"(#include "step.h"
#include <stdio.h>
int main(void) {
    const double points[8] = {0, 0, 0, 1, 1, 1, 1, 0};
    double once[12], twice[20];
    s0_34_36_state states[6], last[10];
    size_t count = s0_34_36_step(points, s0_34_36_start, 4, 2, once, states);
    count = s0_34_36_step(once, states, count, 2, twice, last);
    for (size_t i = 0; i < count; ++i) printf("%.17g,%.17g\n", twice[2 * i], twice[2 * i + 1]);
    return 0;
}
)");
    here.file("square.csv", "0,0\n0,1\n1,1\n1,0\n");
    const Outcome by_c = here.shell("cc -std=c99 -O2 -ffp-contract=off main.c -o main && ./main");
    ASSERT_EQ(by_c.code, 0) << by_c.err;
    const Outcome expected = here.run({"subdivide", "@s0/34-36", "square.csv", "-n", "2", "--format", "csv"});
    ASSERT_EQ(expected.code, 0) << expected.err;
    EXPECT_EQ(by_c.out, expected.out.substr(expected.out.find('\n') + 1));
}

TEST(MasksPoints, RefusesWhatBelongsToOtherKindsAndWhatHasNoMatrix) {
    const Workspace here;
    EXPECT_EQ(here.run({"masks", "@s0/13", "-d", "2"}).code, 2);
    EXPECT_EQ(here.run({"masks", "@s0/13", "--dot"}).code, 2);
    EXPECT_EQ(here.run({"masks", "@s0/13", "--points", "0"}).code, 2);
    EXPECT_EQ(here.run({"masks", "@fibonacci", "-d", "2", "--points", "3"}).code, 2);
    const Outcome degree = here.run({"masks", "@fibonacci"});
    EXPECT_EQ(degree.code, 2);
    EXPECT_THAT(degree.err, HasSubstr("-d is needed"));
    EXPECT_EQ(here.run({"masks", "@s0/38", "--automaton"}).code, 3);
}

} // namespace
} // namespace internode::tests
