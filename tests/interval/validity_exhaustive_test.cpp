// SPDX-License-Identifier: MIT

#include "internode/interval/validity.h"

#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/small_grammars.h"
#include "tests/fixtures/stride.h"
#include "tests/reference/slow_validity.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace internode {
namespace {

const std::size_t stride = tests::stride();

using reference::Matrix;
using tests::grammar_of;
using tests::short_words;

Matrix incidence(const Morphism& rules) {
    Matrix matrix(rules.size(), std::vector<int>(rules.size()));
    for (std::size_t i = 0; i < rules.size(); ++i)
        for (const Symbol symbol : rules.images()[i]) ++matrix[i][to_index(symbol)];
    return matrix;
}

/// Calls visit(grammar) for every grammar of n symbols and rules of up to 3 letters; returns how many there are.
template<class Visit>
std::size_t for_all_grammars(std::size_t n, const Visit& visit) {
    const std::vector<Word> words = short_words(n, 3);
    std::vector<std::size_t> choice(n);
    for (std::size_t count = 0;; ++count) {
        std::vector<Word> images;
        for (const std::size_t index : choice) images.push_back(words[index]);
        if (count % stride == 0) visit(grammar_of(Morphism(std::move(images))));
        std::size_t place = 0;
        while (place < n && ++choice[place] == words.size()) choice[place++] = 0;
        if (place == n) return count + 1;
    }
}

/// ρ a = M a, s M = ρ s, Σ s = 1, all exactly, and ρ > 1, a > 0.
void expect_laws(const Verdict& verdict, const Matrix& matrix) {
    ASSERT_TRUE(verdict.system);
    const Number& ratio = *verdict.ratio.exact;
    EXPECT_GT(ratio, Number(1));
    Number sum;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        Number image;
        for (std::size_t j = 0; j < matrix.size(); ++j) image += Number(matrix[i][j]) * *verdict.lengths[j].exact;
        EXPECT_EQ(image, ratio * *verdict.lengths[i].exact);
        EXPECT_GT(verdict.lengths[i].exact->sign(), 0);
        if (verdict.frequencies.empty()) continue;
        Number arrivals;
        for (std::size_t j = 0; j < matrix.size(); ++j)
            arrivals += Number(matrix[j][i]) * *verdict.frequencies[j].exact;
        EXPECT_EQ(arrivals, ratio * *verdict.frequencies[i].exact);
        EXPECT_GE(verdict.frequencies[i].exact->sign(), 0);
        sum += *verdict.frequencies[i].exact;
    }
    EXPECT_EQ(verdict.frequencies.empty(), verdict.free_lengths > 1);
    if (!verdict.frequencies.empty()) {
        EXPECT_EQ(sum, Number(1));
    }
}

std::string text(const IntervalGrammar& grammar) {
    std::string result;
    for (std::size_t i = 0; i < grammar.alphabet.size(); ++i)
        result += grammar.alphabet.names()[i] + " -> " + to_string(grammar.rules.images()[i], grammar.alphabet) + "  ";
    return result;
}

TEST(ValidityExhaustive, AgreesWithTheDefinitionForAllSmallGrammars) {
    std::map<Matrix, bool> expected;
    std::size_t count = 0;
    for (std::size_t n = 1; n <= 3; ++n) {
        count += for_all_grammars(n, [&](const IntervalGrammar& grammar) {
            const Matrix matrix = incidence(grammar.rules);
            const auto [place, is_new] = expected.try_emplace(matrix);
            if (is_new) place->second = reference::is_valid(matrix);
            const Verdict verdict = validate(grammar);
            ASSERT_EQ(verdict.decision, place->second ? Decision::Valid : Decision::Invalid) << text(grammar);
            ASSERT_EQ(verdict.reasons.empty(), place->second) << text(grammar);
            ASSERT_TRUE(verdict.exact) << text(grammar);
            if (is_new && place->second) expect_laws(verdict, matrix);
        });
    }
    EXPECT_EQ(count, 59518U);
}

/// Letters tend to stay among the first ones, so that classes of all kinds come up.
IntervalGrammar random_grammar(std::mt19937& random) {
    const std::size_t n = 2 + random() % 7;
    std::vector<Word> images(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t size = 1 + random() % 3;
        const std::size_t first = random() % 2 == 0 ? i : 0;
        while (images[i].size() < size) images[i].push_back(to_symbol(first + random() % (n - first)));
    }
    return grammar_of(Morphism(std::move(images)));
}

TEST(ValidityExhaustive, AgreesWithFloatingPointOnRandomGrammars) {
    std::mt19937 random(2012);
    std::size_t undecided = 0;
    std::size_t valid = 0;
    const std::size_t total = 3000;
    for (std::size_t i = 0; i < total; i += stride) {
        const IntervalGrammar grammar = random_grammar(random);
        const Matrix matrix = incidence(grammar.rules);
        const std::optional<bool> expected = reference::is_valid_in_floating_point(matrix);
        const Verdict verdict = validate(grammar);
        if (!expected)
            ++undecided;
        else
            ASSERT_EQ(verdict.decision, *expected ? Decision::Valid : Decision::Invalid) << text(grammar);
        if (verdict.decision != Decision::Valid) continue;
        ++valid;
        expect_laws(verdict, matrix);
    }
    EXPECT_LT(undecided * stride, total / 100);
    EXPECT_GT(valid * stride, total / 10);
}

TEST(ValidityExhaustive, BoundsNeverContradictTheExactDecision) {
    std::mt19937 random(1975);
    std::size_t decided = 0;
    constexpr std::size_t total = 1500;
    for (std::size_t i = 0; i < total; i += stride) {
        const IntervalGrammar grammar = random_grammar(random);
        const Verdict exact = validate(grammar);
        for (const ValidityLimits limits : {ValidityLimits{0, 32}, ValidityLimits{2, 32}, ValidityLimits{200, 1}}) {
            const Verdict bounded = validate(grammar, limits);
            EXPECT_LE(bounded.ratio.bounds.lower, exact.ratio.bounds.upper);
            EXPECT_GE(bounded.ratio.bounds.upper, exact.ratio.bounds.lower);
            if (bounded.decision == Decision::Undecided) {
                EXPECT_FALSE(bounded.reasons.empty());
                continue;
            }
            ++decided;
            ASSERT_EQ(bounded.decision, exact.decision) << text(grammar);
            for (std::size_t j = 0; j < bounded.lengths.size(); ++j) {
                EXPECT_LE(bounded.lengths[j].bounds.lower, exact.lengths[j].bounds.upper) << text(grammar);
                EXPECT_GE(bounded.lengths[j].bounds.upper, exact.lengths[j].bounds.lower) << text(grammar);
            }
            for (std::size_t j = 0; j < bounded.frequencies.size() && !exact.frequencies.empty(); ++j) {
                EXPECT_LE(bounded.frequencies[j].bounds.lower, exact.frequencies[j].bounds.upper) << text(grammar);
                EXPECT_GE(bounded.frequencies[j].bounds.upper, exact.frequencies[j].bounds.lower) << text(grammar);
            }
        }
    }
    EXPECT_GT(decided * stride, 2 * total);
}

} // namespace
} // namespace internode
