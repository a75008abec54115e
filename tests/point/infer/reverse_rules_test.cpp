// SPDX-License-Identifier: MIT

#include "internode/point/infer/reverse_rules.h"

#include "internode/algebra/fraction.h"
#include "internode/io/matrix/fraction_matrix.h"
#include "internode/point/infer/inference.h"
#include "tests/reference/point_rows.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;

UniformMask mask(std::size_t arity, std::ptrdiff_t first, long denominator, const std::vector<long>& numerators) {
    UniformMask result{arity, first, {}};
    for (const long numerator : numerators) result.coefficients.push_back(fraction(numerator, denominator));
    return result;
}

const UniformMask chaikin_13 = mask(2, -1, 4, {1, 3, 3, 1});
const UniformMask chaikin_17 = mask(2, 0, 4, {1, 3, 3, 1});
const UniformMask cubic_22 = mask(2, -2, 8, {1, 4, 6, 4, 1});
const UniformMask four_point_25 = mask(2, -3, 16, {-1, 0, 9, 16, 9, 0, -1});

/// The ring matrix of a mask: m n rows.
RationalMatrix ring_matrix(const UniformMask& mask, std::size_t n) {
    const auto rows = static_cast<std::ptrdiff_t>(mask.arity * n);
    std::vector<std::vector<Rational>> dense(static_cast<std::size_t>(rows), std::vector<Rational>(n));
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = 0; k < mask.coefficients.size(); ++k) {
            const std::ptrdiff_t row = mask.first + static_cast<std::ptrdiff_t>(k + mask.arity * j);
            dense[static_cast<std::size_t>((row % rows + rows) % rows)][j] += mask.coefficients[k];
        }
    RationalMatrix matrix{n, {}};
    for (const std::vector<Rational>& row : dense) {
        RationalRow& sparse = matrix.rows.emplace_back();
        for (std::size_t j = 0; j < n; ++j)
            if (row[j] != 0) sparse.push_back({j, row[j]});
    }
    return matrix;
}

/// Checks A P = I on rings of 1 … 12 coarse points, A by rewriting.
void expect_left_inverse(const UniformMask& mask, const ReverseRule& rule) {
    const PointGrammar grammar = reverse_grammar("r", rule);
    for (std::size_t n = 1; n <= 12; ++n)
        EXPECT_EQ(tests::row_product(tests::row_matrix(grammar, mask.arity * n), ring_matrix(mask, n)),
                  tests::row_identity(n))
            << n;
}

TEST(ReverseRules, GiveEquation38ForChaikin) {
    const ReverseRule rule = reverse_rule(chaikin_13).value();
    EXPECT_EQ(rule.first, -1);
    EXPECT_THAT(rule.weights, ElementsAre(fraction(-1, 4), fraction(3, 4), fraction(3, 4), fraction(-1, 4)));
    EXPECT_EQ(gain(rule), 2);
    const PointProduction production = production_of(rule);
    EXPECT_EQ(
        production,
        (PointProduction{1,
                         2,
                         1,
                         false,
                         false,
                         {{{-1, fraction(-1, 4)}, {0, fraction(3, 4)}, {1, fraction(3, 4)}, {2, fraction(-1, 4)}}}}));
    expect_left_inverse(chaikin_13, rule);
}

TEST(ReverseRules, InvertEverySchemeOfThePaper) {
    const ReverseRule cubic = reverse_rule(cubic_22).value();
    EXPECT_EQ(cubic.first, -1);
    EXPECT_THAT(cubic.weights, ElementsAre(fraction(-1, 2), 2, fraction(-1, 2)));
    expect_left_inverse(cubic_22, cubic);
    const ReverseRule four_point = reverse_rule(four_point_25).value();
    EXPECT_THAT(four_point.weights, ElementsAre(1)) << "the old points are still there";
    expect_left_inverse(four_point_25, four_point);
    expect_left_inverse(chaikin_17, reverse_rule(chaikin_17).value());
}

TEST(ReverseRules, WiderWindowsInvertTooAndAmplifyLess) {
    for (const UniformMask& scheme : {chaikin_13, cubic_22, four_point_25}) {
        Rational last = gain(reverse_rule(scheme).value());
        for (std::size_t wider = 1; wider <= 4; ++wider) {
            const ReverseRule rule = reverse_rule(scheme, wider).value();
            expect_left_inverse(scheme, rule);
            Rational norm = 0;
            for (const Rational& weight : rule.weights) norm += weight * weight;
            EXPECT_LE(norm, last * last) << "the least norm is at most that of the narrower rule";
        }
        EXPECT_LT(gain(reverse_rule(scheme, 4).value()), last + 1);
    }
    EXPECT_LT(gain(reverse_rule(cubic_22, 2).value()), gain(reverse_rule(cubic_22).value()));
}

TEST(ReverseRules, OfAWindowHaveAsManyFinePointsAndAtMostOneMore) {
    for (const UniformMask& scheme : {chaikin_13, cubic_22, four_point_25}) {
        const std::size_t narrowest = reverse_rule(scheme)->weights.size();
        for (std::size_t points = 0; points <= 12; ++points) {
            const ReverseRule rule = reverse_rule_of_window(scheme, points).value();
            const std::size_t odd = points > narrowest ? (points - narrowest) % 2 : 0;
            EXPECT_EQ(rule.weights.size(), std::max(points, narrowest) + odd);
            EXPECT_EQ(rule.weights, reverse_rule(scheme, (rule.weights.size() - narrowest) / 2)->weights);
        }
        EXPECT_LE(reverse_rule_of_window(scheme, 1'000'000)->weights.size(), max_reverse_window);
    }
    EXPECT_FALSE(reverse_rule_of_window(mask(2, 0, 2, {1, 1, 1, 1}), 9));
}

TEST(ReverseRules, InvertAllLaneRiesenfeldSchemes) {
    std::vector<long> binomials{1, 1};
    long denominator = 1;
    for (int degree = 1; degree <= 7; ++degree) {
        binomials.push_back(0);
        for (std::size_t i = binomials.size() - 1; i > 0; --i) binomials[i] += binomials[i - 1];
        denominator *= 2;
        const UniformMask scheme = mask(2, -degree / 2, denominator, binomials);
        const auto rule = reverse_rule(scheme);
        ASSERT_TRUE(rule) << degree;
        expect_left_inverse(scheme, *rule);
    }
}

TEST(ReverseRules, InvertRandomSchemesOfEveryArityWhereverThatCanBe) {
    std::mt19937 random(3);
    const auto any = [&random](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
    int inverted = 0;
    for (int trial = 0; trial < 120; ++trial) {
        const auto arity = static_cast<std::size_t>(any(2, 3));
        std::vector<long> numerators{any(1, 4)};
        for (int k = any(1, 7); k > 0; --k) numerators.push_back(any(-4, 4));
        numerators.push_back(any(1, 4));
        const UniformMask scheme = mask(arity, any(-3, 3), 8, numerators);
        const auto rule = reverse_rule(scheme);
        if (!rule) continue;
        ++inverted;
        expect_left_inverse(scheme, *rule);
    }
    EXPECT_GT(inverted, 80);
}

TEST(ReverseRules, RefuseSchemesThatForgetTheirPoints) {
    EXPECT_FALSE(reverse_rule(mask(2, 0, 2, {1, 1, 1, 1}))) << "each new point twice, half way";
    EXPECT_FALSE(reverse_rule(mask(1, 0, 2, {1, 1}))) << "an average alone";
    EXPECT_TRUE(reverse_rule(mask(1, 0, 1, {2})));
    EXPECT_THROW((void)reverse_rule(UniformMask{0, 0, {1}}), std::invalid_argument);
    EXPECT_THROW((void)reverse_rule(UniformMask{}), std::invalid_argument);
}

/// The matrix (37) of S0 as printed, for n = 4 coarse points.
RationalMatrix matrix_37() {
    return read_fraction_csv("3/4 -1/4 0 0 0 0 -1/4 3/4\n-1/4 3/4 3/4 -1/4 0 0 0 0\n"
                             "0 0 -1/4 3/4 3/4 -1/4 0 0\n0 0 0 0 -1/4 3/4 3/4 -1/4\n",
                             "m")
        .matrix.value();
}

TEST(Erratum, Matrix37IsNoInverseOfMatrix14) {
    EXPECT_NE(tests::row_product(matrix_37(), ring_matrix(chaikin_13, 4)), tests::row_identity(4));
}

TEST(Erratum, Matrix37InvertsThePhaseOfEquation17UpToAShift) {
    const RationalMatrix product = tests::row_product(matrix_37(), ring_matrix(chaikin_17, 4));
    EXPECT_EQ(product, tests::rotated_rows(tests::row_identity(4), -1));
}

TEST(Erratum, Equation38InvertsThePairsOfEquation13AndNotTheOtherPhase) {
    const PointGrammar rule = reverse_grammar("r", reverse_rule(chaikin_13).value());
    for (std::size_t n = 3; n <= 8; ++n) {
        const RationalMatrix reverse = tests::row_matrix(rule, 2 * n);
        EXPECT_EQ(tests::row_product(reverse, ring_matrix(chaikin_13, n)), tests::row_identity(n));
        EXPECT_NE(tests::row_product(reverse, ring_matrix(chaikin_17, n)), tests::row_identity(n));
    }
}

} // namespace
} // namespace internode
