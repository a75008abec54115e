// SPDX-License-Identifier: MIT
//
// validate on point grammars: exit codes, the whole report, JSON.

#include "tests/cli/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace internode::tests {
namespace {

using testing::HasSubstr;

TEST(ValidatePoints, PrintsTheWholeReport) {
    const Workspace here;
    const Outcome outcome = here.run({"validate", "@s0/13"});
    EXPECT_EQ(outcome.code, 0);
    for (const char* const part :
         {"s0/13: valid\n", "a(z) = 1/4 z^-1 (1 + z)^3", "Chaikin's corner cutting", "compiles      to an automaton",
          "convergence   proved", "C^1 (proved)", "`intervals A -> A A` at degree 2"})
        EXPECT_THAT(outcome.out, HasSubstr(part));
    EXPECT_EQ(outcome.err, "");
}

TEST(ValidatePoints, SaysNotValidByItsExitCodeWithRuleSumAndLine) {
    const Workspace here;
    const Outcome outcome = here.run({"validate", "-e", "points wrong\nring\nq: P(u) < P(v) -> P(1/4 u + v)"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.out, HasSubstr("line 3: rule 1 (`q`), module 1: in `1/4 u + v` the coefficients sum to 5/4"));
}

TEST(ValidatePoints, LooksAtTheConstantsThatAreSet) {
    const Workspace here;
    const std::string four = "points\nw = 1/16\nring\n"
                             "P(u) < P(v) > P(p) P(q) -> P(v) P(-w u + (1/2 + w) v + (1/2 + w) p - w q)";
    EXPECT_THAT(here.run({"validate", "-e", four, "--set", "w=1/8"}).out,
                HasSubstr("4-point scheme with tension w = 1/8"));
    EXPECT_THAT(here.run({"validate", "@s0/25", "--json", "--color", "never"}).out,
                HasSubstr("validate @s0/25 --json --color never\""));
    EXPECT_THAT(here.run({"validate", "@s1/14-16", "--set", "t=1/3", "--json"}).out,
                HasSubstr("validate @s1/14-16 --set 't=1/3' --json\""));
    EXPECT_EQ(here.run({"validate", "-e", four, "--set", "v=1/8"}).code, 2);
    EXPECT_EQ(here.run({"validate", "-e", four, "--set", "w"}).code, 2);
    EXPECT_EQ(here.run({"validate", "@fibonacci", "--set", "w=1/8"}).code, 2);
}

TEST(ValidatePoints, RefusesWhatIsNoGrammar) {
    const Workspace here;
    const Outcome outcome = here.run({"validate", "-e", "points\nP(v) -> P(v"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out, "");
}

TEST(ValidatePoints, JsonNamesTheGrammarAsItWasCalled) {
    const Workspace here;
    ASSERT_EQ(here.run({"validate", "@s0/25", "-o", "v.json"}).code, 0);
    const std::string json = here.read("v.json");
    EXPECT_THAT(json, HasSubstr("\"internode-point-validation\""));
    EXPECT_THAT(json, HasSubstr("\"command\": \"internode validate @s0/25\""));
    EXPECT_THAT(json, HasSubstr("4-point scheme with tension w = 1/16 (Dyn, Levin and Gregory)"));
    EXPECT_THAT(here.run({"validate", "@s0/25", "--json"}).out, HasSubstr("\"internode-point-validation\""));
}

} // namespace
} // namespace internode::tests
