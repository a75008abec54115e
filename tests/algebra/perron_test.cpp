// SPDX-License-Identifier: MIT

#include "internode/algebra/perron.h"
#include "internode/algebra/polynomial.h"
#include "tests/fixtures/stride.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace internode;
using testing::ElementsAre;

namespace {

using Dense = std::vector<std::vector<Integer>>;

const std::size_t stride = tests::stride();

SparseMatrix sparse(const Dense& matrix) {
    SparseMatrix result(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (std::size_t j = 0; j < matrix.size(); ++j)
            if (matrix[i][j] != 0)
                result[i].emplace_back(static_cast<std::uint32_t>(j),
                                       static_cast<std::uint32_t>(matrix[i][j].get_ui()));
    return result;
}

/// The n x n matrix whose entries are the digits of `number` in base 3.
Dense matrix_of(std::size_t n, std::size_t number) {
    Dense matrix(n, std::vector<Integer>(n));
    for (auto& row : matrix)
        for (Integer& entry : row) {
            entry = static_cast<unsigned long>(number % 3);
            number /= 3;
        }
    return matrix;
}

struct SmallMatrix {
    Dense matrix;
    PerronRoot root;
};

/// All 2 x 2 and 3 x 3 matrices of entries 0 … 2, with what perron_root says of them.
const std::vector<SmallMatrix>& small_matrices() {
    static const std::vector<SmallMatrix> all = [] {
        std::vector<SmallMatrix> result;
        const auto add = [&](const Dense& matrix) {
            result.push_back({matrix, perron_root(sparse(matrix), matrix.size()).value()});
        };
        for (std::size_t number = 0; number < 81; ++number) add(matrix_of(2, number));
        for (std::size_t number = 0; number < 19683; number += stride) add(matrix_of(3, number));
        return result;
    }();
    return all;
}

/// Whether x > ρ(M): then, and only then, all leading principal minors of xI - M are positive (an M-matrix).
bool is_above_radius(const Dense& matrix, const Rational& x) {
    const std::size_t n = matrix.size();
    std::vector<std::vector<Rational>> a(n, std::vector<Rational>(n));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) a[i][j] = (i == j ? x : Rational(0)) - matrix[i][j];
    for (std::size_t k = 0; k < n; ++k) { // elimination: the pivots are quotients of these minors
        if (a[k][k] <= 0) return false;
        for (std::size_t i = k + 1; i < n; ++i) {
            const Rational factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    return true;
}

/// ρ(M) in (lower, upper], by halving [-1, 6].
std::pair<Rational, Rational> slow_radius(const Dense& matrix) {
    std::pair<Rational, Rational> bounds{-1, 6};
    for (int step = 0; step < 32; ++step) {
        const Rational middle = (bounds.first + bounds.second) / 2;
        (is_above_radius(matrix, middle) ? bounds.second : bounds.first) = middle;
    }
    return bounds;
}

/// The other conjugates of a root of degree at most 3, by Vieta and Schur-Cohn, exactly.
bool slow_pisot(const NumberField& field) {
    const Number& root = field.generator();
    if (root <= Number(1)) return false;
    const auto coefficient = [&](std::size_t i) { return Number(Rational(field.minimal_polynomial()[i])); };
    const auto magnitude = [](const Number& number) { return number.sign() < 0 ? -number : number; };
    if (field.degree() == 1) return true;
    if (field.degree() == 2) return magnitude(-coefficient(1) - root) < Number(1);
    const Number sum = -coefficient(2) - root;
    const Number product = -coefficient(0) / root;
    return magnitude(product) < Number(1) && magnitude(sum) < product + 1;
}

bool is_irreducible(const Dense& matrix) {
    Dense power(matrix.size(), std::vector<Integer>(matrix.size()));
    Dense sum = power;
    for (std::size_t i = 0; i < matrix.size(); ++i) power[i][i] = 1;
    for (std::size_t step = 0; step < matrix.size(); ++step) {
        Dense next(matrix.size(), std::vector<Integer>(matrix.size()));
        for (std::size_t i = 0; i < matrix.size(); ++i)
            for (std::size_t j = 0; j < matrix.size(); ++j) {
                sum[i][j] += power[i][j];
                for (std::size_t k = 0; k < matrix.size(); ++k) next[i][j] += power[i][k] * matrix[k][j];
            }
        power = next;
    }
    return std::ranges::all_of(
        sum, [](const auto& row) { return std::ranges::all_of(row, [](const Integer& entry) { return entry > 0; }); });
}

/// A_1 -> A_n A_n, A_i -> A_(i-1): ρ^n = 2.
SparseMatrix slow_growth(std::uint32_t n) {
    SparseMatrix matrix{{{n - 1, 2}}};
    for (std::uint32_t i = 1; i < n; ++i) matrix.push_back({{i - 1, 1}});
    return matrix;
}

} // namespace

TEST(PerronRoot, IsTheSpectralRadiusOfAllSmallMatrices) {
    for (const auto& [matrix, root] : small_matrices()) {
        const auto [lower, upper] = slow_radius(matrix);
        ASSERT_GE(root.field.generator(), Number(lower));
        ASSERT_LE(root.field.generator(), Number(upper));
    }
}

TEST(PerronRoot, SplitsTheCharacteristicPolynomial) {
    for (const auto& [matrix, root] : small_matrices()) {
        const Polynomial& minimal = root.field.minimal_polynomial();
        Polynomial product = root.characteristic_cofactor;
        for (std::size_t i = 0; i < root.multiplicity; ++i) product = multiply(product, minimal);
        ASSERT_EQ(product, characteristic_polynomial(matrix));
        for (const auto& [part, multiplicity] : factor(root.characteristic_cofactor)) ASSERT_NE(part, minimal);
    }
}

TEST(PerronRoot, IsPisotWhenTheOtherConjugatesAreSmall) {
    for (const auto& [matrix, root] : small_matrices()) {
        ASSERT_EQ(root.pisot, slow_pisot(root.field)) << root.field.generator().to_double();
    }
}

TEST(PerronRoot, OfFibonacciIsTheGoldenRatio) {
    const auto root = perron_root({{{0, 1}, {1, 1}}, {{0, 1}}}, 2);
    ASSERT_TRUE(root);
    EXPECT_EQ(root->field, NumberField({-1, -1, 1}, 1, 2));
    EXPECT_EQ(root->field.generator().to_double(), 1.6180339887498949);
    EXPECT_TRUE(root->pisot);
}

TEST(PerronRoot, SquaredGoldenRatioIsPisotThoughItsPolynomialIsReciprocal) {
    const auto root = perron_root({{{0, 2}, {1, 1}}, {{0, 1}, {1, 1}}}, 2);
    ASSERT_TRUE(root);
    EXPECT_THAT(root->field.minimal_polynomial(), ElementsAre(1, -3, 1));
    EXPECT_TRUE(root->pisot);
}

TEST(PerronRoot, OfSalemTypeIsNotPisot) {
    // x^4 - 2x^3 - 2x + 1: x + 1/x = 1 ± sqrt(3), so two conjugates lie on the unit circle.
    const auto root = perron_root(sparse({{0, 0, 0, 1}, {1, 1, 0, 1}, {1, 0, 0, 0}, {0, 1, 1, 1}}), 4);
    ASSERT_TRUE(root);
    EXPECT_THAT(root->field.minimal_polynomial(), ElementsAre(1, -2, 0, -2, 1));
    EXPECT_FALSE(root->pisot);
}

TEST(PerronRoot, OfEqualRadiiIsOneFieldWhateverTheMatrix) {
    const auto first = perron_root({{{0, 1}, {1, 1}}, {{0, 1}}}, 8);
    const auto second = perron_root({{{1, 1}}, {{2, 1}}, {{0, 1}, {1, 2}}}, 8); // x^3 - 2x - 1 = (x + 1)(x^2 - x - 1)
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->field, second->field);
    EXPECT_EQ(first->field.generator(), second->field.generator());
    EXPECT_THAT(second->characteristic_cofactor, ElementsAre(1, 1));
}

TEST(PerronRoot, OfANilpotentMatrixIsZero) {
    const auto root = perron_root({{{1, 3}}, {}}, 1);
    ASSERT_TRUE(root);
    EXPECT_EQ(root->field.generator(), Number(0));
    EXPECT_EQ(root->multiplicity, 2U);
    EXPECT_FALSE(root->pisot);
}

TEST(PerronRoot, OfRadiiThatAgreeToManyDigitsIsTheLarger) {
    // Blocks of radius m = 65000, sqrt(m^2 - 1) and sqrt(m^2 + 1): they differ in the tenth digit.
    const auto integer = perron_root({{{0, 65000}}, {{2, 65001}}, {{1, 64999}}}, 2);
    ASSERT_TRUE(integer);
    EXPECT_EQ(integer->field.generator(), Number(65000));
    const auto root = perron_root({{{0, 65000}}, {{2, 1}}, {{1, 4225000001}}}, 2);
    ASSERT_TRUE(root);
    EXPECT_EQ(pow(root->field.generator(), 2), Number(4225000001L));
    EXPECT_THAT(root->characteristic_cofactor, ElementsAre(-65000, 1));
}

TEST(PerronRoot, IsEmptyAboveTheDegreeAllowed) {
    EXPECT_FALSE(perron_root(slow_growth(12), 11));
    const auto root = perron_root(slow_growth(32), 32);
    ASSERT_TRUE(root);
    EXPECT_EQ(pow(root->field.generator(), 32), Number(2));
    EXPECT_FALSE(root->pisot);
}

TEST(PerronRoot, RefusesAMatrixWithoutRowsOrWithForeignColumns) {
    EXPECT_THROW((void)perron_root({}, 3), std::invalid_argument);
    EXPECT_THROW((void)perron_root({{{1, 1}}}, 3), std::out_of_range);
}

TEST(EncloseRadius, HoldsTheExactRadiusOfAllSmallMatrices) {
    tests::Compared compared;
    for (const auto& [matrix, root] : small_matrices()) {
        if (!is_irreducible(matrix)) continue;
        const CertifiedRadius result = enclose_radius(sparse(matrix));
        ASSERT_LE(Number(to_rational(result.radius.lower)), root.field.generator());
        ASSERT_GE(Number(to_rational(result.radius.upper)), root.field.generator());
        ASSERT_LE(result.radius.upper - result.radius.lower, 4e-14 * result.radius.upper);
        ++compared;
    }
}

TEST(EncloseRadius, BoundsAreTheCollatzWielandtQuotientsOfTheVector) {
    tests::Compared compared;
    for (const auto& [matrix, root] : small_matrices()) {
        if (!is_irreducible(matrix)) continue;
        const CertifiedRadius result = enclose_radius(sparse(matrix));
        ASSERT_EQ(*std::ranges::min_element(result.vector), 1.0);
        for (std::size_t i = 0; i < matrix.size(); ++i) {
            Rational sum;
            for (std::size_t j = 0; j < matrix.size(); ++j) sum += matrix[i][j] * to_rational(result.vector[j]);
            const Rational quotient = sum / to_rational(result.vector[i]);
            ASSERT_LE(to_rational(result.radius.lower), quotient);
            ASSERT_GE(to_rational(result.radius.upper), quotient);
            ++compared;
        }
    }
}

TEST(EncloseRadius, IsExactOnAnExactEigenvector) {
    const CertifiedRadius two = enclose_radius({{{0, 1}, {1, 1}}, {{0, 2}}});
    EXPECT_EQ(two.radius.lower, 2.0);
    EXPECT_EQ(two.radius.upper, 2.0);
    const CertifiedRadius zero = enclose_radius({{}});
    EXPECT_EQ(zero.radius.lower, 0.0);
    EXPECT_EQ(zero.radius.upper, 0.0);
}

TEST(EncloseRadius, DoesNotOscillateOnAnImprimitiveMatrix) {
    for (const std::uint32_t n : {2U, 3U, 12U, 50U}) {
        const CertifiedRadius result = enclose_radius(slow_growth(n));
        const double radius = std::pow(2.0, 1.0 / n);
        EXPECT_NEAR(result.radius.lower, radius, 1e-13);
        EXPECT_NEAR(result.radius.upper, radius, 1e-13);
    }
}

TEST(EncloseRadius, StaysCertifiedWhereTheVectorWouldOverflow) {
    // A cycle of 100 nodes whose eigenvector spans (4·10^9 / ρ)^99: the iteration stops early, the bounds hold.
    SparseMatrix matrix;
    for (std::uint32_t i = 0; i + 1 < 100; ++i) matrix.push_back({{i + 1, i < 50 ? 4'000'000'000U : 1U}});
    matrix.push_back({{0, 1}});
    const CertifiedRadius result = enclose_radius(matrix);
    const double radius = std::sqrt(4e9);
    EXPECT_TRUE(std::isfinite(result.radius.upper));
    EXPECT_LE(result.radius.lower, radius);
    EXPECT_GE(result.radius.upper, radius);
}

TEST(EncloseRadius, BoundsAReducibleMatrixToo) {
    const CertifiedRadius result = enclose_radius({{{0, 2}, {1, 1}}, {{1, 3}}});
    EXPECT_LE(result.radius.lower, 3.0);
    EXPECT_GE(result.radius.upper, 3.0);
}

TEST(EncloseRadius, RefusesAMatrixWithoutRowsOrWithForeignColumns) {
    EXPECT_THROW((void)enclose_radius({}), std::invalid_argument);
    EXPECT_THROW((void)enclose_radius({{{1, 1}}}), std::invalid_argument);
}
