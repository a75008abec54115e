// SPDX-License-Identifier: MIT

#include "internode/point/interpreter.h"

#include "internode/point/start_word.h"
#include "tests/point/systems.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The problem that ends a derivation from the axiom; empty without one.
std::string problem_after(const std::string& text, std::uint64_t cycles, const DeriveOptions& options = {}) {
    const PointSystem system = point_system(text);
    const Derivation done = derive(system, axiom_word(system), cycles, options);
    return done.problem ? done.problem->message : "";
}

/// The part of the text that the problem is about.
std::string place_after(const std::string& text, std::uint64_t cycles) {
    const PointSystem system = point_system(text);
    const Derivation done = derive(system, axiom_word(system), cycles);
    return done.problem ? text.substr(done.problem->place.offset, done.problem->place.bytes) : "no problem";
}

TEST(Interpreter, TheFirstRuleThatMatchesWins) {
    EXPECT_EQ(after("points\naxiom A(1) A(3)\n a: A(x) : x > 2 -> B\n b: A(x) -> C\n c: A(x) -> D\n", 1), "C B");
}

TEST(Interpreter, ModulesWithoutARuleStayAsTheyAre) {
    EXPECT_EQ(after("points\naxiom A(1) B((0.5, 2), 7) E\nA(x) -> A(x + 1)\n", 3), "A(4) B((0.5, 2), 7) E");
}

TEST(Interpreter, AnEmptySuccessorErases) {
    EXPECT_EQ(after("points\naxiom A B A\nA -> .\n", 1), "B");
    EXPECT_EQ(after("points\naxiom A A\nA -> .\n", 5), "");
    EXPECT_EQ(after("points\naxiom A A\nA -> .\n", 1'000'000'000'000), "");
}

TEST(Interpreter, AllModulesAreRewrittenAtOnce) {
    EXPECT_EQ(after("points\naxiom A B B B\nA < B -> A\nA -> B\n", 1), "B A B B");
}

TEST(Interpreter, RingsGoRoundAndOpenWordsEnd) {
    const std::string rules = "axiom A(1) A(2) A(3)\nA(x) < A(y) > A(z) -> A(100 x + 10 y + z)\n";
    EXPECT_EQ(after("points\nring\n" + rules, 1), "A(312) A(123) A(231)");
    EXPECT_EQ(after("points\n" + rules, 1), "A(1) A(123) A(3)");
    EXPECT_EQ(after("points\naxiom # A A #\n# < A -> B\nA > # -> C\n", 1), "# B C #");
}

TEST(Interpreter, ARingOfOneModuleIsItsOwnNeighbour) {
    EXPECT_EQ(after("points\nring\naxiom A(2)\nA(w) A(x) < A(y) > A(z) -> A(w + x + y + z)\n", 2), "A(32)");
}

TEST(Interpreter, ContextsStepOverBranches) {
    const std::string text = "points\naxiom A(1) [ B(2) [ B(3) ] B(4) ] A(5)\nA(x) < A(y) -> A(10 x + y)\n"
                             "A(x) < B(y) -> B(10 x + y)\nB(x) < B(y) -> B(10 x + y)\n";
    EXPECT_EQ(after(text, 1), "A(1) [ B(12) [ B(23) ] B(24) ] A(15)");
}

TEST(Interpreter, TablesFollowTheCycle) {
    const std::string text = "points\naxiom A\nE -> F\ntable p\nA -> B E\ntable q\nB -> C\ncycle p q^2\n";
    const PointSystem system = point_system(text);
    const ModuleWord axiom = axiom_word(system);
    EXPECT_EQ(shown(system, derive_step(system, axiom, 0).word), "B E");
    EXPECT_EQ(shown(system, derive_step(system, axiom, 1).word), "A");
    EXPECT_EQ(shown(system, derive_step(system, axiom, 3).word), "B E");
    EXPECT_EQ(after(text, 1), "C F");
}

TEST(Interpreter, ACycleWithoutStepsChangesNothing) {
    EXPECT_EQ(after("points\naxiom A\ntable p\nA -> A A\ncycle p^0\n", 1'000'000'000), "A");
}

const std::string pairs = "axiom A(1) A(2) A(3) A(4) A(5) A(6)\nA(x) A(y) -> B(x, y)\n";

TEST(Interpreter, PairsFollowThePhaseInARing) {
    const std::string ring = "points\nring\n" + pairs;
    EXPECT_EQ(after(ring, 1), "B(1, 2) B(3, 4) B(5, 6)");
    EXPECT_EQ(after(ring, 1, {.phase = 1}), "B(2, 3) B(4, 5) B(6, 1)");
    EXPECT_EQ(after(ring, 1, {.phase = 2}), "B(3, 4) B(5, 6) B(1, 2)");
    EXPECT_EQ(after(ring, 1, {.phase = 13}), "B(2, 3) B(4, 5) B(6, 1)");
}

TEST(Interpreter, ARingIsTurnedOnceACycle) {
    const std::string text = "points\nring\naxiom A(1) A(2) A(3)\ntable p\nA(x) -> A(x)\ncycle p^2\n";
    EXPECT_EQ(after(text, 1, {.phase = 1}), "A(2) A(3) A(1)");
    EXPECT_EQ(after(text, 2, {.phase = 1}), "A(3) A(1) A(2)");
}

TEST(Interpreter, InAnOpenWordModulesBeforeThePhaseAreOutOfReach) {
    EXPECT_EQ(after("points\naxiom A(1) A(2) A(3)\nA(x) A(y) -> B(x, y)\n", 1, {.phase = 1}), "A(1) B(2, 3)");
}

TEST(Interpreter, WhatIsLeftOverOfPairsIsRefused) {
    const std::string text = "points\nring\naxiom A(1) A(2) A(3)\nd: A(x) A(y) -> B(x, y)\n";
    EXPECT_EQ(problem_after(text, 1),
              "module 3, `A`, is left over: rule `d` needs 2 modules in a row that are not yet rewritten");
    EXPECT_EQ(problem_after(text, 1, {.phase = 1}),
              "module 1, `A`, is left over: rule `d` needs 2 modules in a row that are not yet rewritten");
    EXPECT_EQ(place_after(text, 1), "d: A(x) A(y) -> B(x, y)");
    EXPECT_EQ(after(text + "A(x) -> C(x)\n", 1), "B(1, 2) C(3)");
}

TEST(Interpreter, LongAndShortPredecessorsAreTriedInOneOrder) {
    EXPECT_EQ(after("points\naxiom A A A B A A\nA A A -> X\nA A -> Y\nA -> Z\n", 1), "X B Y");
    EXPECT_EQ(after("points\naxiom A A A\nA -> Z\nA A -> Y\n", 1), "Z Z Z");
}

TEST(Interpreter, RefusesValuesThatAreNotFiniteWithTheirRule) {
    const std::string text = "points\naxiom A(1) A(0)\ninverse: A(x) -> A(1/x)\n";
    EXPECT_EQ(problem_after(text, 1), "rule `inverse` gives `A` a parameter that is not finite, at module 2");
    EXPECT_EQ(place_after(text, 1), "1/x");
    EXPECT_EQ(problem_after("points\naxiom A(-1)\nA(x) -> A(sqrt(x))\n", 1),
              "this rule of `A` gives `A` a parameter that is not finite, at module 1");
    EXPECT_THAT(problem_after("points\naxiom A(10)\nA(x) -> A(x x)\n", 12), HasSubstr("not finite"));
    EXPECT_THAT(problem_after("points\naxiom A((1, 0))\nA(v) -> A(v/v.y)\n", 1), HasSubstr("not finite"));
}

TEST(Interpreter, ConditionsMayMeetInfinityAndNaN) {
    EXPECT_EQ(after("points\naxiom A(0)\na: A(x) : 1/x > 5 -> B\n", 1), "B");
    EXPECT_EQ(after("points\naxiom A(0)\na: A(x) : x/x == x/x -> B\n", 1), "A(0)");
}

TEST(Interpreter, KeepsTheLastWholeWordWhenAStepFails) {
    const PointSystem system = point_system("points\naxiom A(2)\nA(x) -> A(x - 1) B(1/(x - 1))\n");
    const Derivation done = derive(system, axiom_word(system), 5);
    ASSERT_TRUE(done.problem);
    EXPECT_EQ(shown(system, done.word), "A(1) B(1)");
}

TEST(Interpreter, RefusesLongWordsBeforeTheWorkWhereGrowthIsContextFree) {
    const std::string text = "points\naxiom X\nX -> X X\n";
    EXPECT_EQ(problem_after(text, 1'000'000'000), "after 1000000000 cycles the word would have more than "
                                                  "1000000000000000000 modules; 10000000 are allowed");
    EXPECT_EQ(problem_after(text, 5, {.max_modules = 31}),
              "after 5 cycles the word would have 32 modules; 31 are allowed");
    EXPECT_EQ(problem_after(text, 5, {.max_modules = 32}), "");
    const PointSystem system = point_system(text);
    EXPECT_EQ(derive(system, axiom_word(system), 1'000'000'000).work, 0U);
}

TEST(Interpreter, RefusesLongWordsAsTheyHappenWithTheirLength) {
    const std::string text = "points\naxiom A B\nA > B -> A A\nA -> A A\nB -> B B B\n";
    const std::string conditional = "points\naxiom X(0)\na: X(n) : n < 100 -> X(n + 1) X(n + 1) X(n + 1)\n";
    EXPECT_EQ(problem_after(conditional, 100, {.max_modules = 100}), "the word would have 243 modules, more than 100");
    EXPECT_EQ(problem_after(text, 3, {.max_modules = 34}),
              "after 3 cycles the word would have 35 modules; 34 are allowed");
}

TEST(Interpreter, NumbersOfAWordAreBoundedToo) {
    const std::string text =
        "points\naxiom X(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)\n"
        "X(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r) -> X(a, b, c, d, e, f, g, h, i, j, k, "
        "l, m, n, o, p, q, r)^2\n";
    EXPECT_EQ(problem_after(text, 6, {.max_modules = 64}), "the word would have more than 1024 numbers");
}

TEST(Interpreter, WorkIsBoundedToo) {
    std::string context;
    for (int i = 0; i < 90; ++i) context += "A ";
    const std::string text = "points\nring\naxiom A^100\n" + context + "< A > " + context + "-> A\n";
    EXPECT_EQ(problem_after(text, 1000, {.max_work = 1'000'000}),
              "more than 1000000 letters compared and numbers computed");
    EXPECT_EQ(problem_after(text, 10, {.max_work = 1'000'000}), "");
}

TEST(Interpreter, DrawsInProportionToTheWeights) {
    const std::string text = "points\naxiom A^8000\na: A -> B : 1\nb: A -> C : 3\n";
    std::map<char, int> counts;
    for (const char letter : after(text, 1, {.seed = 7})) ++counts[letter];
    // The standard deviation is sqrt(8000 · 1/4 · 3/4) = 39.
    EXPECT_NEAR(counts['B'], 2000, 200);
    EXPECT_EQ(counts['B'] + counts['C'], 8000);
}

TEST(Interpreter, DrawsDependOnSeedStepAndPositionAlone) {
    const std::string rules = "a: A -> A B : 1\nb: A -> A C : 1\n";
    const std::string text = "points\naxiom A^40\n" + rules;
    EXPECT_EQ(after(text, 2, {.seed = 3}), after(text, 2, {.seed = 3}));
    EXPECT_NE(after(text, 2, {.seed = 3}), after(text, 2, {.seed = 4}));
    const PointSystem system = point_system(text);
    const ModuleWord axiom = axiom_word(system);
    EXPECT_NE(derive_step(system, axiom, 0).word, derive_step(system, axiom, 1).word);
    const std::string shorter = after("points\naxiom A^20\n" + rules, 1);
    EXPECT_EQ(after(text, 1).substr(0, shorter.size()), shorter);
}

TEST(Interpreter, DrawsAmongTheRulesThatMatch) {
    EXPECT_EQ(after("points\naxiom A(1)\na: A(x) : x > 5 -> B : 1000\nb: A(x) -> C : x\n", 1), "C");
    EXPECT_EQ(after("points\naxiom A^9\na: A -> B\nb: A -> C : 1000\n", 1), "B B B B B B B B B");
    // A predecessor of another length is not drawn.
    EXPECT_EQ(after("points\naxiom A A\na: A -> B : 1\nb: A A -> C : 1000000\n", 1), "B B");
}

TEST(Interpreter, RefusesWeightsThatAreNone) {
    const std::string text = "points\naxiom A(0)\nless: A(x) -> B : x - 1\n";
    EXPECT_EQ(problem_after(text, 1), "the weight of rule `less` is not a number above 0");
    EXPECT_EQ(place_after(text, 1), "x - 1");
    EXPECT_THAT(problem_after("points\naxiom A(0)\na: A(x) -> B : x/x\n", 1), HasSubstr("not a number above 0"));
    EXPECT_EQ(problem_after("points\naxiom A(0)\na: A(x) -> B : 1/x\n", 1),
              "the weights of the rules that match add up to infinity");
}

TEST(Interpreter, TheEnvironmentFillsQueryModulesBeforeEachStep) {
    const std::string text = "points\naxiom A(0) ?Q(0, 0) A(0) ?Q(0, 0)\nA(s) > ?Q(x, y) -> A(s + x + y)\n";
    std::vector<std::size_t> asked;
    const Query query = [&](const ModuleWord& word, std::size_t position, std::span<double> values) {
        asked.push_back(position);
        values[0] = static_cast<double>(position);
        values[1] = static_cast<double>(word.size()) / 8;
        return position == 1;
    };
    EXPECT_EQ(after(text, 2, {.query = query}), "A(3) ?Q(1, 0.5) A(0) ?Q(0, 0)");
    EXPECT_THAT(asked, ElementsAre(1, 3, 1, 3));
}

TEST(Interpreter, WhatTheEnvironmentLeavesStays) {
    const Query silent = [](const ModuleWord&, std::size_t, std::span<double>) { return false; };
    EXPECT_EQ(after("points\naxiom A(0) ?Q(2)\nA(s) > ?Q(x) -> A(s + x)\n", 2, {.query = silent}), "A(4) ?Q(2)");
}

TEST(Interpreter, RefusesAnAnswerThatIsNotFinite) {
    const Query query = [](const ModuleWord&, std::size_t, std::span<double> values) {
        values[0] = std::numeric_limits<double>::infinity();
        return true;
    };
    EXPECT_EQ(problem_after("points\naxiom A ?Q(0)\nA -> A\n", 1, {.query = query}),
              "the query `?Q`, module 2, got a value that is not finite");
}

TEST(Interpreter, InterpretationPassesFollowEachOther) {
    const PointSystem system = point_system("points\naxiom P(1) E P(2)\nE -> E\ninterpretation\nP(x) -> Q(10 x)\n"
                                            "interpretation\nQ(x) < E > Q(y) -> L(x, y)\nE -> X\n");
    const Derivation drawn = interpret(system, axiom_word(system));
    ASSERT_FALSE(drawn.problem);
    EXPECT_EQ(shown(system, drawn.word, 2), "Q(10) L(10, 20) Q(20)");
}

TEST(Interpreter, InterpretationObeysTheLimitOfModules) {
    const PointSystem system = point_system("points\naxiom P^3\nP -> P\ninterpretation\nP -> P^4\n");
    EXPECT_FALSE(interpret(system, axiom_word(system), {.max_modules = 12}).problem);
    const Derivation refused = interpret(system, axiom_word(system), {.max_modules = 11});
    ASSERT_TRUE(refused.problem);
    EXPECT_EQ(refused.problem->message, "the word would have 12 modules, more than 11");
}

TEST(Interpreter, RecordsParentsRulesAndWhatWasRead) {
    const PointSystem system = point_system("points\nring\naxiom A B C\nC < A > B -> A D\nB C -> E\n");
    StepRecord record;
    const Derivation done = derive_step(system, axiom_word(system), 0, {}, record);
    EXPECT_EQ(shown(system, done.word), "A D E");
    EXPECT_THAT(record.parent, ElementsAre(0, 0, 1));
    EXPECT_THAT(record.rule, ElementsAre(0U, 0U, 1U));
    EXPECT_THAT(record.read, ElementsAre(ElementsAre(2, 1), ElementsAre(2, 1), ElementsAre()));
}

TEST(Interpreter, RecordsOfATurnedRingNameTheModulesAsTheyWere) {
    const PointSystem system = point_system("points\nring\naxiom A(1) A(2) A(3)\nA(x) > A(y) -> A(y)\n");
    StepRecord record;
    const Derivation done = derive_step(system, axiom_word(system), 0, {.phase = 2}, record);
    EXPECT_EQ(shown(system, done.word), "A(1) A(2) A(3)");
    EXPECT_THAT(record.parent, ElementsAre(2, 0, 1));
    EXPECT_THAT(record.read, ElementsAre(ElementsAre(0), ElementsAre(1), ElementsAre(2)));
}

TEST(Interpreter, RecordsWhatStays) {
    const PointSystem system = point_system("points\naxiom A B\nA -> A\n");
    StepRecord record;
    static_cast<void>(derive_step(system, axiom_word(system), 0, {}, record));
    EXPECT_THAT(record.rule, ElementsAre(std::optional<std::uint32_t>(0), std::nullopt));
}

} // namespace
} // namespace internode
