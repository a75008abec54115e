// SPDX-License-Identifier: MIT

#include "tests/point/systems.h"

#include "internode/point/growth.h"
#include "internode/point/start_word.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace internode {
namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

std::optional<std::uint64_t> predicted(const std::string& text, std::uint64_t cycles, std::uint64_t limit = no_limit) {
    const PointSystem system = point_system(text);
    return predicted_length(system, axiom_word(system), cycles, limit);
}

TEST(Growth, CountsWhatContextFreeRulesMake) {
    const std::string fibonacci = "points\naxiom L\nL -> S L\nS -> L\n";
    EXPECT_EQ(predicted(fibonacci, 0), 1U);
    EXPECT_EQ(predicted(fibonacci, 10), 144U);
    EXPECT_EQ(predicted("points\naxiom A B\nA -> .\n", 1), 1U);
    EXPECT_EQ(predicted("points\naxiom A\ntable p\nA -> A A\ntable q\nA -> A A A\ncycle p^2 q\n", 2), 144U);
}

TEST(Growth, SaturatesAndEndsForABillionCycles) {
    EXPECT_EQ(predicted("points\naxiom X\nX -> X X\n", 1'000'000'000, 1000), 1001U);
    EXPECT_EQ(predicted("points\naxiom X\nX -> X X\n", 1'000'000'000), no_limit);
    EXPECT_EQ(predicted("points\naxiom X\nX -> Y\n", 1'000'000'000), 1U);
    // Two letters that change places for ever are not counted to the end.
    EXPECT_EQ(predicted("points\naxiom X\nX -> Y\nY -> X\n", 1'000'000'000), std::nullopt);
}

TEST(Growth, RulesOfOneLetterMayDifferInNumbersButNotInLetters) {
    EXPECT_EQ(predicted("points\naxiom A(1)\na: A(x) : x > 1 -> A(x) A(x)\nA(x) -> A(x + 1) A(2)\n", 5), 32U);
    EXPECT_EQ(predicted("points\naxiom A(1)\na: A(x) : x > 1 -> A(x) A(x)\nA(x) -> A(x + 1)\n", 5), std::nullopt);
    EXPECT_EQ(predicted("points\naxiom A(1)\na: A(x) : x > 1 -> A(x) A(x)\n", 5), std::nullopt);
    EXPECT_EQ(predicted("points\naxiom A(1)\na: A(x) : x > 1 -> A(0)\n", 5), 1U);
}

TEST(Growth, ContextsNeverFailInARingOfOneLetter) {
    const std::string rule = "axiom P(1) P(2) P(3)\nP(u) < P(v) > P(w) -> P(u) P(w)\n";
    EXPECT_EQ(predicted("points\nring\n" + rule, 4), 48U);
    EXPECT_EQ(predicted("points\n" + rule, 4), std::nullopt);
}

TEST(Growth, PairsAreNotPredicted) {
    EXPECT_EQ(predicted("points\nring\naxiom P P\nP P -> P\n", 1), std::nullopt);
}

TEST(Growth, IsTheLengthOfTheWordForRandomRules) {
    std::mt19937 random(5);
    const auto below = [&](unsigned bound) { return static_cast<unsigned>(random() % bound); };
    for (int i = 0; i < 300; ++i) {
        std::string text = "points\naxiom A B C\n";
        for (const char* letter : {"A", "B", "C"}) {
            text += std::string(letter) + " ->";
            const unsigned count = below(4);
            for (unsigned k = 0; k < count; ++k) text += std::string(" ") + "ABC"[below(3)];
            text += count == 0 ? " .\n" : "\n";
        }
        const PointSystem system = point_system(text);
        ModuleWord word = axiom_word(system);
        for (std::uint64_t cycles = 1; cycles <= 5; ++cycles) {
            word = derive_step(system, word, cycles).word;
            ASSERT_EQ(predicted(text, cycles), word.size()) << text;
        }
    }
}

} // namespace
} // namespace internode
