// SPDX-License-Identifier: MIT

#include "internode/word/factors.h"
#include "tests/fixtures/stride.h"
#include "tests/fixtures/words.h"
#include "tests/reference/persistent_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

using namespace internode;
using testing::ElementsAreArray;
using testing::IsEmpty;
using tests::all_systems;
using tests::morphism;
using tests::word;
using tests::words;

namespace {

constexpr std::size_t plenty = 1'000'000;

const std::size_t stride = tests::stride();

/// Fibonacci: a = L -> SL, b = S -> L.
} // namespace

TEST(Windows, OfAnOpenWordStopAtItsEnd) {
    EXPECT_THAT(windows(word("aaba"), 2, Ends::Open), ElementsAreArray(words({"aa", "ab", "ba"})));
    EXPECT_THAT(windows(word("ab"), 3, Ends::Open), IsEmpty());
    EXPECT_THAT(windows(Word{}, 1, Ends::Open), IsEmpty());
}

TEST(Windows, OfACircularWordStartAtEveryLetter) {
    EXPECT_THAT(windows(word("aab"), 2, Ends::Circular), ElementsAreArray(words({"aa", "ab", "ba"})));
    EXPECT_THAT(windows(word("ab"), 5, Ends::Circular), ElementsAreArray(words({"ababa", "babab"})));
    EXPECT_THAT(windows(Word{}, 2, Ends::Circular), IsEmpty());
}

TEST(Windows, RefuseTheSizeZero) {
    EXPECT_THROW((void)windows(word("a"), 0, Ends::Open), std::invalid_argument);
}

TEST(Factors, AreTheWindowsOnceEach) {
    EXPECT_THAT(factors(word("abab0ab"), 2, Ends::Open), ElementsAreArray(words({"ab", "ba", "b0", "0a"})));
    EXPECT_THAT(factors(word("aaaa"), 3, Ends::Circular), ElementsAreArray(words({"aaa"})));
}

TEST(AllWords, AreSortedAndComplete) {
    EXPECT_THAT(all_words(2, 2, 4), ElementsAreArray(words({"aa", "ab", "ba", "bb"})));
    EXPECT_EQ(all_words(3, 4, plenty).size(), 81U);
    EXPECT_THAT(all_words(0, 3, plenty), IsEmpty());
}

TEST(AllWords, RefuseMoreThanTheLimitWithoutOverflow) {
    EXPECT_THROW((void)all_words(2, 2, 3), TooManyWords);
    EXPECT_THROW((void)all_words(1'000'000, 50, plenty), TooManyWords);
    EXPECT_THROW((void)all_words(2, 64, plenty), TooManyWords);
    EXPECT_THROW((void)all_words(2, 0, plenty), std::invalid_argument);
}

TEST(FactorGraph, OfFibonacciIsTheFigureOfThePaper) {
    // d = 2 (Fig. 3): of the eight words of three letters, S = b repeated is left behind at once.
    const FactorGraph graph = factor_graph(tests::fibonacci_rules(), all_words(2, 3, 8), 8);
    std::vector<Word> persistent;
    for (std::size_t i = 0; i < graph.words.size(); ++i)
        if (graph.persistent[i]) persistent.push_back(graph.words[i]);
    EXPECT_THAT(persistent, ElementsAreArray(words({"aab", "aba", "baa", "bab"})));
}

TEST(FactorGraph, ArcsAreTheFactorsOfTheImageByPosition) {
    for (const Morphism& system : all_systems(2, 2)) {
        const FactorGraph graph = factor_graph(system, all_words(2, 3, 8), 8);
        ASSERT_EQ(graph.arcs.size(), graph.words.size());
        for (std::size_t i = 0; i < graph.words.size(); ++i) {
            std::vector<Word> targets;
            for (const std::uint32_t target : graph.arcs[i]) targets.push_back(graph.words[target]);
            EXPECT_THAT(targets, ElementsAreArray(windows(system(graph.words[i]), 3, Ends::Open)));
        }
    }
}

TEST(FactorGraph, PersistentMeansOnACycleOrReachableFromOne) {
    const auto systems = all_systems(2, 3);
    tests::Compared compared;
    for (std::size_t s = 0; s < systems.size(); s += stride) {
        const FactorGraph graph = factor_graph(systems[s], {word("abb"), word("a0b"), word("abb")}, plenty);
        const auto walks = reference::walks(graph.arcs);
        for (std::size_t j = 0; j < graph.words.size(); ++j) {
            bool expected = false;
            for (std::size_t i = 0; i < graph.words.size(); ++i)
                expected = expected || (walks[i][i] && (i == j || walks[i][j]));
            EXPECT_EQ(graph.persistent[j], expected);
            ++compared;
        }
    }
}

TEST(FactorGraph, OrdersWordsBreadthFirstFromTheStart) {
    // a -> ba, b -> a: "bb" -> "aa" -> "ba", "ab" (from "baba"); nothing else follows.
    const FactorGraph graph = factor_graph(tests::fibonacci_rules(), {word("bb")}, plenty);
    EXPECT_THAT(graph.words, ElementsAreArray(words({"bb", "aa", "ba", "ab"})));
    EXPECT_THAT(graph.persistent, testing::ElementsAre(false, true, true, true));
}

TEST(FactorGraph, OfNothingIsEmpty) {
    EXPECT_THAT(factor_graph(tests::fibonacci_rules(), {}, plenty).words, IsEmpty());
}

TEST(FactorGraph, RefusesMoreWordsThanTheLimit) {
    EXPECT_THROW((void)factor_graph(tests::fibonacci_rules(), {word("bb")}, 3), TooManyWords);
    EXPECT_NO_THROW((void)factor_graph(tests::fibonacci_rules(), {word("bb")}, 4));
}

TEST(FactorGraph, RefusesStartWordsOfSeveralLengths) {
    EXPECT_THROW((void)factor_graph(tests::fibonacci_rules(), {word("a"), word("ab")}, plenty), std::invalid_argument);
    EXPECT_THROW((void)factor_graph(tests::fibonacci_rules(), {Word{}}, plenty), std::invalid_argument);
}

TEST(PersistentWords, OfFibonacciAreOneMoreThanTheirLength) {
    for (std::size_t m = 1; m <= 20; ++m)
        EXPECT_EQ(persistent_words(tests::fibonacci_rules(), m, plenty).size(), m + 1);
}

TEST(PersistentWords, KeepWhatAnAxiomBringsThoughNoLetterProducesIt) {
    // a -> aa, b -> bb: "ab" is never made, but an axiom that has it keeps it.
    EXPECT_THAT(persistent_words(morphism({"aa", "bb"}), 2, plenty), ElementsAreArray(words({"aa", "ab", "ba", "bb"})));
}

TEST(PersistentWords, KeepALetterThatOnlySurvivesInsideItsOwnImage) {
    // a -> bab, b -> bb: the images begin and end in b, so no seam between two of them ever shows the a.
    const Morphism system = morphism({"bab", "bb"});
    EXPECT_THAT(persistent_words(system, 2, plenty), ElementsAreArray(reference::persistent_words(system, 2)));
}

TEST(PersistentWords, EqualTheDefinitionForAllTwoLetterSystems) {
    const auto systems = all_systems(2, 3);
    tests::Compared compared;
    for (std::size_t s = 0; s < systems.size(); s += stride) {
        if (!reference::every_letter_grows(systems[s])) {
            EXPECT_THROW((void)persistent_words(systems[s], 2, plenty), std::invalid_argument);
            continue;
        }
        for (std::size_t m = 1; m <= 5; ++m, ++compared)
            EXPECT_EQ(persistent_words(systems[s], m, plenty), reference::persistent_words(systems[s], m));
    }
}

TEST(PersistentWords, EqualTheDefinitionForAllThreeLetterSystems) {
    const auto systems = all_systems(3, 3);
    tests::Compared compared;
    for (std::size_t s = 0; s < systems.size(); s += stride) {
        if (!reference::every_letter_grows(systems[s])) {
            EXPECT_THROW((void)persistent_words(systems[s], 2, plenty), std::invalid_argument);
            continue;
        }
        for (std::size_t m = 1; m <= (s % 97 == 0 ? 4U : 3U); ++m, ++compared)
            EXPECT_EQ(persistent_words(systems[s], m, plenty), reference::persistent_words(systems[s], m));
    }
}

TEST(PersistentWords, NeedNoHighPowerWhenOneLetterGrowsFastAndAnotherSlowly) {
    // a -> 12 a; b -> c -> d -> e -> f -> bb: |σ^k(b)| = 32 needs k = 25, where |σ^k(a)| = 12^25.
    const Morphism system = morphism({"aaaaaaaaaaaa", "c", "d", "e", "f", "bb"});
    const std::vector<Word> persistent = persistent_words(system, 33, plenty);
    EXPECT_TRUE(std::ranges::binary_search(persistent, Word(33, to_symbol(0))));
}

TEST(PersistentWords, OfSixtyFourSymbolsAreFound) {
    std::vector<Word> images{Word{to_symbol(63), to_symbol(63)}};
    for (std::size_t i = 1; i < 64; ++i) images.push_back(Word{to_symbol(i - 1)});
    EXPECT_EQ(persistent_words(Morphism(images), 2, plenty).size(), 4096U);
}

TEST(PersistentWords, OfNoSymbolsAreNone) {
    EXPECT_THAT(persistent_words(Morphism(), 3, plenty), IsEmpty());
}

TEST(PersistentWords, RefuseALetterThatDoesNotGrow) {
    EXPECT_THROW((void)persistent_words(morphism({"ab", "b"}), 2, plenty), std::invalid_argument);
    // It doubles once, and never again.
    EXPECT_THROW((void)persistent_words(morphism({"aa", "cc", "c"}), 2, plenty), std::invalid_argument);
}

TEST(PersistentWords, RefuseMoreThanTheLimit) {
    EXPECT_THROW((void)persistent_words(morphism({"aa", "bb", "cc"}), 2, 8), TooManyWords);
    EXPECT_NO_THROW((void)persistent_words(morphism({"aa", "bb", "cc"}), 2, 9));
}
