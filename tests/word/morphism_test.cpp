// SPDX-License-Identifier: MIT

#include "internode/word/morphism.h"
#include "tests/fixtures/words.h"
#include "tests/reference/persistent_words.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace internode;
using tests::morphism;
using tests::word;

namespace {

/// Fibonacci: a = L -> SL, b = S -> L.
Word concatenated(Word a, const Word& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

} // namespace

TEST(Morphism, RewritesAllLettersAtOnceAndKeepsZeros) {
    EXPECT_EQ(tests::fibonacci_rules()(word("baaba")), word("ababaaba"));
    EXPECT_EQ(tests::fibonacci_rules()(word("00ab0")), word("00baa0"));
    EXPECT_EQ(tests::fibonacci_rules()(Word{}), Word{});
}

TEST(Morphism, TurnsConcatenationIntoConcatenation) {
    for (const Morphism& system : tests::all_systems(2, 2))
        for (const char* left : {"", "a", "ab0"})
            for (const char* right : {"", "b", "0ba"})
                EXPECT_EQ(system(concatenated(word(left), word(right))),
                          concatenated(system(word(left)), system(word(right))));
}

TEST(Morphism, RefusesARuleWithAnEmptySuccessor) {
    EXPECT_THROW(Morphism({word("a"), Word{}}), std::invalid_argument);
}

TEST(Morphism, RefusesASymbolWithoutARule) {
    EXPECT_THROW(morphism({"ab"}), std::invalid_argument);
    EXPECT_THROW(morphism({"a0"}), std::invalid_argument);
}

TEST(Morphism, RefusesTheImageOfAForeignLetter) {
    EXPECT_THROW((void)tests::fibonacci_rules()(word("c")), std::out_of_range);
}

TEST(MorphismPower, IsTheMorphismAppliedSoManyTimes) {
    for (const Morphism& system : tests::all_systems(2, 2)) {
        Word expected = word("a0b");
        for (int exponent = 1; exponent <= 4; ++exponent) {
            expected = system(expected);
            EXPECT_EQ(power(system, exponent)(word("a0b")), expected);
        }
    }
}

TEST(MorphismPower, RefusesPowersBelowOne) {
    EXPECT_THROW((void)power(tests::fibonacci_rules(), 0), std::invalid_argument);
    EXPECT_THROW((void)power(tests::fibonacci_rules(), -1), std::invalid_argument);
}

TEST(Rewritten, IsTheWordAfterSoManyStepsHoweverManyGoTogether) {
    for (const Morphism& system : tests::all_systems(2, 2))
        for (const std::size_t repeats : {0, 1, 9, 60}) {
            Word start;
            for (std::size_t i = 0; i < repeats; ++i) start = concatenated(std::move(start), word("a0b"));
            Word expected = start;
            for (int steps = 0; steps <= 6; ++steps) {
                EXPECT_EQ(rewritten(system, start, steps), expected) << steps << " steps of " << start.size();
                expected = system(expected);
            }
        }
}

TEST(Rewritten, GoesOnWhereAPowerWouldBeTooLong) {
    Word start;
    for (int i = 0; i < 3000; ++i) start = concatenated(std::move(start), word("ab0aab"));
    Word expected = start;
    const Morphism system = morphism({"aab", "abbbaaaaaaaaaaaaaaaaaaaa"});
    for (int step = 0; step < 4; ++step) expected = system(expected);
    ASSERT_GT(expected.size(), 1'000'000U);
    EXPECT_EQ(rewritten(system, start, 4), expected);
}

TEST(Rewritten, RefusesFewerThanNoSteps) {
    EXPECT_THROW((void)rewritten(tests::fibonacci_rules(), word("a"), -1), std::invalid_argument);
}

TEST(LetterCounts, AreThoseOfTheWordItself) {
    for (const Morphism& system : tests::all_systems(2, 3)) {
        Word current = word("ab0a");
        for (std::uint64_t steps = 0; steps <= 4; ++steps) {
            const LetterCounts expected = letter_counts(system, current);
            const LetterCounts counts = letter_counts(system, word("ab0a"), steps);
            EXPECT_EQ(counts.symbols, expected.symbols);
            EXPECT_EQ(counts.zeros, 1U);
            EXPECT_EQ(counts.total, current.size());
            EXPECT_FALSE(counts.saturated);
            current = system(current);
        }
    }
}

TEST(LetterCounts, SaturateExactlyAboveTheCap) {
    // Fibonacci from S: 1, 1, 2, 3, 5, 8, 13, …
    EXPECT_FALSE(letter_counts(tests::fibonacci_rules(), word("b"), 6, 13).saturated);
    EXPECT_TRUE(letter_counts(tests::fibonacci_rules(), word("b"), 6, 12).saturated);
    EXPECT_TRUE(letter_counts(tests::fibonacci_rules(), word("bbb"), 0, 2).saturated);
}

TEST(LetterCounts, SaturateBeforeTheyOverflow) {
    // 18 · 8^n letters: 2^64 and 2^61 more in step 20.
    const Morphism eightfold = morphism({"aaaaaaaa", "bbbbbbbb"});
    const Word start = word("aaaaaabbbbbbbbbbbb");
    constexpr std::uint64_t largest_cap = (std::uint64_t{1} << 63) - 1;
    const LetterCounts before = letter_counts(eightfold, start, 19, largest_cap);
    EXPECT_EQ(before.total, std::uint64_t{18} << 57);
    EXPECT_FALSE(before.saturated);
    EXPECT_TRUE(letter_counts(eightfold, start, 20, largest_cap).saturated);
}

TEST(LetterCounts, EndAtOnceForABillionSteps) {
    EXPECT_TRUE(letter_counts(tests::fibonacci_rules(), word("a"), 1'000'000'000).saturated);
    const LetterCounts fixed = letter_counts(morphism({"a"}), word("aa"), 1'000'000'000);
    EXPECT_EQ(fixed.total, 2U);
    EXPECT_FALSE(fixed.saturated);
}

TEST(LetterCounts, CountALinearGrowthToItsLastStep) {
    // a -> ab, b -> b: one more letter a step.
    EXPECT_EQ(letter_counts(morphism({"ab", "b"}), word("a"), 1'000'000).total, 1'000'001U);
}
