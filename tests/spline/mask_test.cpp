// SPDX-License-Identifier: MIT

#include "internode/spline/mask.h"

#include "internode/spline/blossom.h"
#include "internode/word/factors.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/stride.h"
#include "tests/reference/step_matrix.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace internode {
namespace {

using reference::boehm_rows;
using tests::system_of;
using tests::word_of;

bool has_length(const Word& word) {
    return std::ranges::any_of(word, [](Symbol letter) { return letter != zero_interval; });
}

/// What every mask must satisfy: the factors of σ(w) by position, weights of [0, 1], Boehm's weights, and the masses
/// Σ_l weight_l |support of l| / ρ = |support of w|.
void expect_mask(const IntervalSystem& system, const Word& word) {
    const std::size_t d = word.size() - 1;
    const Mask result = mask(system, word);
    const std::vector<Word> factors = windows(system.rules()(word), d + 1, Ends::Open);
    const reference::Matrix inserted = boehm_rows(system, word, d);
    ASSERT_EQ(result.entries.size(), factors.size());
    ASSERT_EQ(result.entries.size(), inserted.size());
    EXPECT_EQ(result.word, word);
    Number mass;
    for (std::size_t l = 0; l < factors.size(); ++l) {
        EXPECT_EQ(result.entries[l].word, factors[l]);
        const Number& weight = result.entries[l].weight;
        EXPECT_EQ(weight, inserted[l][0]);
        EXPECT_GE(weight.sign(), 0);
        EXPECT_LE(weight, Number(1));
        mass += weight * knots(system, factors[l]).back();
    }
    EXPECT_EQ(mass, system.ratio() * knots(system, word).back());
}

TEST(Mask, OfFibonacciIsAsPrinted) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const Number phi = fibonacci.ratio();
    const Mask result = mask(fibonacci, word_of(fibonacci, "LSL"));
    ASSERT_EQ(result.entries.size(), 3U);
    EXPECT_EQ(result.entries[0].word, word_of(fibonacci, "SLL"));
    EXPECT_EQ(result.entries[0].weight, Number(2) * phi - Number(3));
    EXPECT_EQ(result.entries[1].word, word_of(fibonacci, "LLS"));
    EXPECT_EQ(result.entries[1].weight, Number(1));
    EXPECT_EQ(result.entries[2].word, word_of(fibonacci, "LSL"));
    EXPECT_EQ(result.entries[2].weight, Number(2) - phi);
}

TEST(Mask, OfAllEightFibonacciDecompositionsAgreesWithKnotInsertion) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (const Word& word : all_words(2, 3, 8)) expect_mask(fibonacci, word);
}

TEST(Mask, OfUniformBisectionIsBinomial) {
    const IntervalSystem uniform = system_of("A->AA");
    const Mask cubic = mask(uniform, word_of(uniform, "AAAA"));
    std::vector<Number> weights;
    for (const MaskEntry& entry : cubic.entries) weights.push_back(entry.weight);
    EXPECT_EQ(weights,
              (std::vector<Number>{Rational(1, 8), Rational(1, 2), Rational(3, 4), Rational(1, 2), Rational(1, 8)}));
}

TEST(Mask, AgreesWithKnotInsertionWhereIntervalsAreEmpty) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (std::size_t m = 2; m <= 5; ++m)
        for (const Word& word : tests::words_with_zeros(2, m))
            if (has_length(word)) expect_mask(fibonacci, word);
}

TEST(Mask, AgreesWithKnotInsertionForEveryBundledGrammar) {
    const std::size_t largest_degree = tests::in_full() ? 6 : 4;
    for (const auto& [name, system] : tests::bundled_systems()) {
        SCOPED_TRACE(name);
        for (std::size_t d = 1; d <= largest_degree; ++d) {
            const std::vector<Word> words = persistent_words(system.rules(), d + 1, 100'000);
            const std::size_t stride = words.size() / 15 + 1;
            for (std::size_t i = 0; i < words.size(); i += stride) expect_mask(system, words[i]);
        }
    }
}

TEST(Mask, FibonacciHasAFewPersistentDecompositions) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    for (std::size_t d = 1; d <= 8; ++d) EXPECT_EQ(persistent_words(fibonacci.rules(), d + 1, 1000).size(), d + 2);
}

TEST(Mask, RefusesWhatIsNotADecomposition) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    EXPECT_THROW((void)mask(fibonacci, Word{}), std::invalid_argument);
    EXPECT_THROW((void)mask(fibonacci, word_of(fibonacci, "L")), std::invalid_argument);
    EXPECT_THROW((void)mask(fibonacci, word_of(fibonacci, "000")), std::invalid_argument);
}

} // namespace
} // namespace internode
