// SPDX-License-Identifier: MIT
//
// validate, masks, format, grammars, limits, word: what they say and what they refuse.

#include "tests/cli/command.h"

#include "internode/grammar/bundled.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace internode::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Validate, SaysValidAndInvalidByItsExitCode) {
    const Workspace here;
    EXPECT_EQ(here.run({"validate", "@fibonacci"}).code, 0);
    EXPECT_EQ(here.run({"validate", "-e", "L->SL, S->L"}).code, 0);
    EXPECT_EQ(here.run({"validate", "-"}, "intervals g\nL -> S L\nS -> L\n").code, 0);
    const Outcome invalid = here.run({"validate", "-e", "A1->A1A1A2, A2->A2"});
    EXPECT_EQ(invalid.code, 1);
    EXPECT_EQ(invalid.err, "");
    EXPECT_THAT(invalid.out, HasSubstr("never splits"));
}

TEST(Validate, JsonByFlagFormatOrExtensionIsTheSame) {
    const Workspace here;
    const Outcome flag = here.run({"validate", "@fibonacci", "--json"});
    ASSERT_EQ(flag.code, 0);
    ASSERT_EQ(here.run({"validate", "@fibonacci", "-o", "v.json"}).code, 0);
    EXPECT_THAT(flag.out, HasSubstr("\"internode-validation\""));
    EXPECT_THAT(here.read("v.json"), HasSubstr("\"exact\": [\"0\", \"1\"]"));
}

TEST(Grammars, ThatAreInvalidAreRefusedByOtherCommandsWithTheReasons) {
    const Workspace here;
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
             {"masks", "-e", "A->B, B->A", "-d", "2"},
             {"word", "-e", "A->B, B->A", "-n", "2", "--word", "A"},
             {"subdivide", "data/curves/fibonacci-open.json", "-e", "A->B, B->A", "-n", "1"}}) {
        const Outcome outcome = here.run(command);
        EXPECT_EQ(outcome.code, 3);
        EXPECT_THAT(outcome.err, HasSubstr("not a valid interval system"));
        EXPECT_EQ(outcome.out, "");
    }
}

TEST(Grammars, ErrorsShowPlaceLineCaretAndHint) {
    const Workspace here;
    here.file("bad.lsys", "intervals bad\nL -> S L\n");
    const Outcome outcome = here.run({"validate", "bad.lsys"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("bad.lsys:2:6: error: "));
    EXPECT_THAT(outcome.err, HasSubstr("^"));
    EXPECT_THAT(outcome.err, HasSubstr("write `S -> S` if it should stay whole"));
}

TEST(Grammars, AtMostTwentyErrorsAreShownAndTheRestIsCounted) {
    std::string text = "intervals many\n";
    for (int i = 0; i < 30; ++i) text += "A" + std::to_string(i) + " ->\n->\n";
    const Workspace here;
    here.file("many.lsys", text);
    const Outcome outcome = here.run({"validate", "many.lsys"});
    EXPECT_EQ(outcome.code, 3);
    std::size_t shown = 0;
    for (auto at = outcome.err.find(": error: "); at != std::string::npos; at = outcome.err.find(": error: ", at + 1))
        ++shown;
    EXPECT_EQ(shown, 20U);
    EXPECT_THAT(outcome.err, HasSubstr("more error"));
}

TEST(Terminal, NoControlByteOfTheUserReachesStderr) {
    const Workspace here;
    here.file("evil.lsys", "intervals x\nL -> \x1b[31m S\u202e \x07 L\n");
    std::string name = "a\x1b]0;owned\x07.lsys";
    here.file(name, "L -> S\n");
    for (const Outcome& outcome :
         {here.run({"validate", "evil.lsys"}), here.run({"validate", name}), here.run({"validate", "gone\x1b[2J"}),
          here.run({"masks\x1b[2J"}), here.run({"validate", "@x\x1b[2J"}),
          here.run({"subdivide", "@fibonacci", "p\x1b[2J", "-d", "2", "-n", "1"})}) {
        EXPECT_NE(outcome.code, 0);
        const auto control = [](char c) { return (c >= 0 && c < 32 && c != '\n') || c == 127; };
        EXPECT_TRUE(std::ranges::none_of(outcome.err, control)) << outcome.err;
        EXPECT_THAT(outcome.err, Not(HasSubstr("\u202e")));
    }
}

TEST(Terminal, ColourIsOnlyForThoseWhoAsk) {
    const Workspace here;
    EXPECT_THAT(here.run({"validate", "@nothing"}).err, Not(HasSubstr("\x1b")));
    EXPECT_THAT(here.run({"validate", "nowhere", "--color", "always"}).err, HasSubstr("\x1b[1;31merror:"));
    EXPECT_THAT(here.run({"--color", "always", "validate", "nowhere"}).err, HasSubstr("\x1b[1;31merror:"));
    EXPECT_THAT(here.run({"validate", "nowhere", "--color", "never"}).err, Not(HasSubstr("\x1b")));
}

TEST(Masks, EveryFormatComesOut) {
    const Workspace here;
    EXPECT_THAT(here.run({"masks", "@fibonacci", "-d", "2"}).out, HasSubstr("2φ−3"));
    EXPECT_THAT(here.run({"masks", "@fibonacci", "-d", "2", "--json"}).out, HasSubstr("\"internode-masks\""));
    EXPECT_THAT(here.run({"masks", "@fibonacci", "-d", "2", "--dot"}).out, HasSubstr("digraph"));
    EXPECT_THAT(here.run({"masks", "@fibonacci", "-d", "2", "--svg"}).out, HasSubstr("<svg"));
    const Outcome matrix = here.run({"masks", "@fibonacci", "-d", "2", "--matrix", "--word", "(LSL)"});
    EXPECT_THAT(matrix.out, HasSubstr("%%MatrixMarket matrix coordinate real general"));
    EXPECT_THAT(matrix.out, HasSubstr("\n5 3 "));
}

TEST(Masks, ExportsTheAutomatonAsJsonAndAsCode) {
    const Workspace here;
    EXPECT_THAT(here.run({"masks", "@fibonacci", "-d", "2", "--automaton"}).out, HasSubstr("\"internode-automaton\""));
    ASSERT_EQ(here.run({"masks", "@fibonacci", "-d", "2", "--automaton", "-o", "a.json"}).code, 0);
    EXPECT_THAT(here.read("a.json"), HasSubstr("\"start\": \"persistent\""));
    ASSERT_EQ(here.run({"masks", "@fibonacci", "-d", "2", "-o", "fib.h"}).code, 0);
    const std::string c = here.run({"masks", "@fibonacci", "-d", "2", "--format", "c"}).out;
    EXPECT_THAT(here.read("fib.h"), HasSubstr(c.substr(c.find("#ifndef"))));
    EXPECT_THAT(here.read("fib.h"), HasSubstr("-ffp-contract=off"));
    ASSERT_EQ(here.run({"masks", "@fibonacci", "-d", "2", "-o", "fib.comp"}).code, 0);
    EXPECT_THAT(here.read("fib.comp"), HasSubstr("void fibonacci_2_step(uint cell)"));
    const Outcome word = here.run({"masks", "@fibonacci", "-d", "3", "--automaton", "--word", "(SSSSS)"});
    EXPECT_THAT(word.out, HasSubstr("\"start\": \"word\""));
    EXPECT_EQ(here.run({"masks", "@fibonacci", "-d", "3", "--automaton", "--word", "LSL"}).code, 3);
    EXPECT_EQ(here.run({"masks", "@tribonacci", "-d", "12", "--all", "--format", "c"}).code, 3);
    EXPECT_EQ(here.run({"masks", "-e", "L->SL, S->L; axiom LS", "-d", "3", "--format", "c"}).code, 3);
}

TEST(Masks, ExportsSeveralStepsAtOnce) {
    const Workspace here;
    const Outcome fused = here.run({"masks", "@fibonacci", "-d", "2", "--automaton", "--steps", "3"});
    EXPECT_EQ(fused.code, 0) << fused.err;
    EXPECT_THAT(fused.out, HasSubstr("\"steps\": 3"));
    EXPECT_THAT(fused.out, HasSubstr("\"exact\": [\"1\", \"2\"]")) << "the ratio is φ³ = 1 + 2φ";
    EXPECT_THAT(here.run({"masks", "@fibonacci", "-d", "2", "--format", "c", "-n", "3"}).out,
                HasSubstr("fibonacci_3_2_step("));
    for (const char* many : {"25", "1000000000000"}) {
        const Outcome refused = here.run({"masks", "@fibonacci", "-d", "2", "--format", "c", "-n", many});
        EXPECT_EQ(refused.code, 3);
        EXPECT_THAT(refused.err, HasSubstr("more than 10000 letters"));
    }
}

TEST(Masks, SaysTheSizeOfExactWorkAndRefusesMinutesOfIt) {
    const Workspace here;
    EXPECT_THAT(here.run({"masks", "@fibonacci", "-d", "2", "-v"}).err, HasSubstr(" units of exact work"));
    EXPECT_THAT(here.run({"masks", "@fibonacci", "-d", "2", "--format", "c", "-v"}).err,
                HasSubstr(" units of exact work"));
    EXPECT_EQ(here.run({"masks", "@fibonacci", "-d", "2"}).err, "");
    for (const std::vector<std::string>& line : {std::vector<std::string>{"masks", "@tribonacci", "-d", "6", "--all"},
                                                 {"masks", "@slow-growth-8", "-d", "12", "--format", "c"}}) {
        const Outcome refused = here.run(line);
        EXPECT_EQ(refused.code, 3);
        EXPECT_THAT(refused.err, HasSubstr("units of work, more than the limit of 100000000"));
    }
}

TEST(Masks, RefusesWhatCannotBeShown) {
    const Workspace here;
    const Outcome circle = here.run({"masks", "@fibonacci", "-d", "7", "--all", "--svg"});
    EXPECT_EQ(circle.code, 3);
    EXPECT_THAT(circle.err, HasSubstr("--dot"));
    EXPECT_EQ(here.run({"masks", "@fibonacci", "-d", "2", "--matrix"}).code, 3);
    EXPECT_EQ(here.run({"masks", "@fibonacci", "-d", "2", "--matrix", "--word", "LS"}).code, 3);
    EXPECT_EQ(here.run({"masks", "@fibonacci", "-d", "2", "--matrix", "--word", "(LX)"}).code, 3);
    EXPECT_EQ(here.run({"masks", "@tribonacci", "-d", "12", "--all"}).code, 3);
    for (const std::string format : {"text", "json", "mtx", "dot", "svg"}) {
        const Outcome axiom = here.run({"masks", "-e", "L->SL, S->L; axiom LS", "-d", "3", "--format", format});
        EXPECT_EQ(axiom.code, 3) << format;
        EXPECT_THAT(axiom.err, HasSubstr("the axiom has 2 letters; an open word of degree 3 has at least 7"));
        EXPECT_EQ(here.run({"masks", "-e", "L->SL, S->L; axiom (L 0 0 0)", "-d", "2", "--format", format}).code, 3);
    }
}

TEST(WordCommand, RewritesAndCounts) {
    const Workspace here;
    const Outcome word = here.run({"word", "@fibonacci", "--word", "L", "-n", "4"});
    EXPECT_EQ(word.code, 0);
    EXPECT_THAT(word.out, HasSubstr("LSLSLLSL\n8 letters after 4 steps"));
    EXPECT_EQ(here.run({"word", "@fibonacci", "-n", "4"}).code, 3);
    const Outcome huge = here.run({"word", "@fibonacci", "--word", "L", "-n", "1000000000"});
    EXPECT_EQ(huge.code, 3);
    EXPECT_THAT(huge.err, HasSubstr("10000000"));
}

TEST(Format, IsANormalFormThatReadsBack) {
    const Workspace here;
    const Outcome once = here.run({"format", "-e", "L → S L; S → L"});
    ASSERT_EQ(once.code, 0);
    const Outcome twice = here.run({"format", "-"}, once.out);
    EXPECT_EQ(once.out, twice.out);
}

TEST(Format, TakesPointGrammarsToo) {
    const Workspace here;
    const Outcome once = here.run({"format", "@s0/13"});
    ASSERT_EQ(once.code, 0) << once.err;
    EXPECT_EQ(once.out, "points \"s0/13\"\nring\n"
                        "P(v_l) < P(v) > P(v_r) -> P(1/4 v_l + 3/4 v) P(3/4 v + 1/4 v_r)\n");
    EXPECT_EQ(here.run({"format", "-"}, once.out).out, once.out);
    const Outcome wrong = here.run({"format", "-e", "points x; P(v) -> P(u)"});
    EXPECT_EQ(wrong.code, 3);
    EXPECT_THAT(wrong.err, HasSubstr("<expression>:1:21: error: `u` is no parameter and no constant"));
}

TEST(GrammarsCommand, ListsEveryBundledGrammarAndPrintsEach) {
    const Workspace here;
    const Outcome list = here.run({"grammars"});
    for (const BundledGrammar& grammar : bundled_grammars()) {
        EXPECT_THAT(list.out, HasSubstr("@" + std::string(grammar.name) + " "));
        EXPECT_EQ(here.run({"grammars", std::string(grammar.name)}).out, grammar.text);
    }
    EXPECT_EQ(here.run({"grammars", "fibonaci"}).code, 2);
}

TEST(Limits, NamesEveryLimitWithItsNumber) {
    const Outcome limits = Workspace().run({"limits"});
    for (const char* word :
         {"grammar text", "symbols of a grammar", "letters of a rule", "digits of a number", "JSON depth",
          "polygon dimension", "degree of an exact field", "degree of a spline", "states of a stencil automaton",
          "exact work of a table", "words drawn on a circle", "--max-points"})
        EXPECT_THAT(limits.out, HasSubstr(word));
}

} // namespace
} // namespace internode::tests
