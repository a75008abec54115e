// SPDX-License-Identifier: MIT
//
// Grammars and words that want to exhaust the interpreter: all is bounded by the letters of the word times those of the
// rules, counted and not timed.

#include "tests/point/systems.h"

#include "internode/point/start_word.h"
#include "tests/fixtures/stride.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace internode {
namespace {

const auto many = static_cast<std::size_t>(tests::times(1'000'000, 100'000));

/// A word of one letter without parameters.
ModuleWord repeated(const PointSystem& system, const std::vector<std::string>& letters, std::size_t times) {
    ModuleWord word;
    for (std::size_t i = 0; i < times; ++i)
        for (const std::string& letter : letters) word.push_back(*system.grammar().letters.find(letter), {});
    return word;
}

std::uint64_t work_of_step(const PointSystem& system, const ModuleWord& word) {
    const Derivation done = derive_step(system, word, 0);
    EXPECT_FALSE(done.problem);
    return done.work;
}

TEST(HostileDerivation, WorkIsLinearInTheWord) {
    for (const std::string text : {"points\nring\nP(u) < P(v) > P(w) -> P(1/4 u + 3/4 v) P(3/4 v + 1/4 w)\n",
                                   "points\nP(u) P(v) < P(w) : u.x > 3 -> .\nP(u) > P(v) -> P(u) P(v)\n"}) {
        const PointSystem system = point_system(text);
        const auto work = [&](std::size_t points) {
            return work_of_step(system, input_word(system, std::vector<double>(2 * points, 1.0)));
        };
        const std::uint64_t one_more = work(2001) - work(2000);
        EXPECT_EQ(work(4000), work(2000) + 2000 * one_more) << text;
        EXPECT_LT(one_more, 100U);
    }
}

TEST(HostileDerivation, WorkIsLinearInTheContexts) {
    const auto work = [&](std::size_t context) {
        std::string letters;
        for (std::size_t i = 0; i < context; ++i) letters += "A ";
        const PointSystem system = point_system("points\nring\naxiom A\n" + letters + " < A > " + letters + " -> A\n");
        return work_of_step(system, repeated(system, {"A"}, 3));
    };
    EXPECT_EQ(work(400) - work(200), work(300) - work(100));
    EXPECT_LE(work(400), 3 * 810U);
}

TEST(HostileDerivation, ManyBranchesOnOneStemAreSteppedOverAtOnce) {
    const PointSystem system = point_system("points\naxiom A [ B ]\nA < B -> B B\nA < A -> A\n");
    ModuleWord word = repeated(system, {"A"}, 1);
    const ModuleWord branches = repeated(system, {"[", "B", "]"}, many / 4);
    for (std::size_t i = 0; i < branches.size(); ++i) word.push_back(branches.letter(i), {});
    word.push_back(word.letter(0), {});
    EXPECT_LT(work_of_step(system, word), 20 * word.size());
}

TEST(HostileDerivation, AMillionNestedBranchesCostNoStack) {
    const PointSystem system = point_system("points\naxiom A [ A ]\nA < A -> A A\n");
    ModuleWord word = repeated(system, {"A", "["}, many / 2);
    const ModuleWord closing = repeated(system, {"]"}, many / 2);
    for (std::size_t i = 0; i < closing.size(); ++i) word.push_back(closing.letter(i), {});
    const Derivation done = derive_step(system, word, 0);
    ASSERT_FALSE(done.problem);
    // All but the first A become two.
    EXPECT_EQ(done.word.size(), word.size() + many / 2 - 1);
}

TEST(HostileDerivation, UnbalancedBracketsAreModules) {
    const PointSystem system = point_system("points\naxiom A [ A ]\nA < A -> B\n");
    const Derivation done = derive_step(system, repeated(system, {"]", "A", "A", "["}, 1), 0);
    ASSERT_FALSE(done.problem);
    EXPECT_EQ(shown(system, done.word), "] A B [");
}

TEST(HostileDerivation, AMillionModulesAreDerived) {
    const PointSystem system = point_system("points\nring\nP(u) < P(v) > P(w) -> P(1/4 u + 3/4 v) P(3/4 v + 1/4 w)\n");
    const std::vector<double> points(2 * (many / 2), 1.0);
    const Derivation done = derive(system, input_word(system, points), 1);
    ASSERT_FALSE(done.problem);
    ASSERT_EQ(done.word.size(), points.size());
    EXPECT_EQ(done.word.values(points.size() - 1)[1], 1.0);
}

TEST(HostileDerivation, SelfFeedingGrowthIsRefused) {
    for (const std::string text : {"points\naxiom A(2)\na: A(x) : x > 0 -> A(x) A(x + 1)\n",
                                   "points\nring\naxiom A E\nA < E > A -> E A E\nA -> A A\n",
                                   "points\naxiom A(2)\na: A(x) -> A(x) A(x) A(x) : 1\nb: A(x) -> A(x) A(x) : x\n"}) {
        const PointSystem system = point_system(text);
        const Derivation done = derive(system, axiom_word(system), 1'000'000'000, {.max_modules = 100'000});
        ASSERT_TRUE(done.problem) << text;
        EXPECT_LE(done.word.size(), 100'000U);
    }
}

TEST(HostileDerivation, ASuccessorOfAHundredThousandModulesIsCountedAndNotStored) {
    const PointSystem system = point_system("points\naxiom A\na: A : 1 == 1 -> A^90000\n");
    const Derivation done = derive(system, axiom_word(system), 3, {.max_modules = 1'000'000});
    ASSERT_TRUE(done.problem);
    EXPECT_EQ(done.problem->message, "the word would have 8100000000 modules, more than 1000000");
    EXPECT_EQ(done.word.size(), 90'000U);
}

} // namespace
} // namespace internode
