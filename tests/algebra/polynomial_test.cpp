// SPDX-License-Identifier: MIT

#include "internode/algebra/fraction.h"
#include "internode/algebra/polynomial.h"
#include "tests/reference/real_root.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

using namespace internode;
using reference::evaluate;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

namespace {

using Square = std::vector<std::vector<Integer>>;

/// All polynomials of the degree with coefficients -2 … 2, the leading one positive.
template<typename Check>
void for_all_polynomials(std::size_t degree, Check check) {
    std::vector<int> digits(degree + 1, -2);
    for (;;) {
        if (digits.back() > 0) check(Polynomial(digits.begin(), digits.end()));
        std::size_t i = 0;
        while (i <= degree && digits[i] == 2) digits[i++] = -2;
        if (i > degree) return;
        ++digits[i];
    }
}

bool squarefree(const Polynomial& polynomial) {
    for (const auto& [part, multiplicity] : factor(polynomial))
        if (multiplicity > 1) return false;
    return true;
}

} // namespace

TEST(Factor, SplitsIntoIrreduciblePolynomials) {
    // (x - 2)^2 (x^2 - x - 1) = x^4 - 5x^3 + 7x^2 - 4
    EXPECT_THAT(factor({-4, 0, 7, -5, 1}),
                UnorderedElementsAre(Pair(ElementsAre(-2, 1), 2U), Pair(ElementsAre(-1, -1, 1), 1U)));
    EXPECT_THAT(factor({0, 0, 3}), ElementsAre(Pair(ElementsAre(0, 1), 2U)));
    EXPECT_THAT(factor({5}), IsEmpty());
}

TEST(Factor, MultipliesBackUpToTheContent) {
    for_all_polynomials(3, [](const Polynomial& polynomial) {
        Polynomial product{1};
        for (const auto& [part, multiplicity] : factor(polynomial))
            for (std::size_t i = 0; i < multiplicity; ++i) product = multiply(product, part);
        ASSERT_EQ(product.size(), polynomial.size());
        const Integer content = polynomial.back() / product.back();
        for (std::size_t i = 0; i < product.size(); ++i) ASSERT_EQ(content * product[i], polynomial[i]);
    });
}

TEST(Factor, RefusesZero) {
    EXPECT_THROW((void)factor({}), std::invalid_argument);
    EXPECT_THROW((void)factor({0, 0}), std::invalid_argument);
}

TEST(CharacteristicPolynomial, IsTheDeterminantOfXMinusM) {
    EXPECT_THAT(characteristic_polynomial(Square{{1, 1}, {1, 0}}), ElementsAre(-1, -1, 1));
    EXPECT_THAT(characteristic_polynomial(Square{{2, 5}, {0, 3}}), ElementsAre(6, -5, 1));
    EXPECT_THAT(characteristic_polynomial(Square{}), ElementsAre(1));
}

TEST(CharacteristicPolynomial, RefusesAMatrixThatIsNotSquare) {
    EXPECT_THROW((void)characteristic_polynomial(Square{{1, 2}}), std::invalid_argument);
}

TEST(Roots, HoldASignChangeInEachRealBox) {
    std::size_t count = 0;
    for_all_polynomials(4, [&](const Polynomial& polynomial) {
        if (!squarefree(polynomial)) return;
        const std::vector<RootBox> boxes = roots(polynomial, 64);
        ASSERT_EQ(boxes.size(), 4U);
        const Rational margin(1, 1'000'000'000'000);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const RootBox& box = boxes[i];
            ASSERT_LE(box.lower, box.upper);
            ASSERT_LE(box.upper - box.lower, margin);
            ASSERT_LE(box.modulus_lower, box.modulus_upper);
            if (!box.real) continue;
            if (i > 0) {
                ASSERT_TRUE(boxes[i - 1].real);
                ASSERT_LT(boxes[i - 1].upper, box.lower);
            }
            ASSERT_LE(sgn(evaluate(polynomial, box.lower - margin)) * sgn(evaluate(polynomial, box.upper + margin)), 0);
            ++count;
        }
    });
    EXPECT_GT(count, 1000U);
}

TEST(Roots, MultiplyToTheConstantCoefficient) {
    for_all_polynomials(3, [](const Polynomial& polynomial) {
        if (!squarefree(polynomial)) return;
        Rational lower(1);
        Rational upper(1);
        for (const RootBox& box : roots(polynomial, 64)) {
            lower *= box.modulus_lower;
            upper *= box.modulus_upper;
        }
        const Rational product = fraction(abs(polynomial.front()), polynomial.back());
        ASSERT_LE(lower, product);
        ASSERT_GE(upper, product);
    });
}

TEST(Roots, AreExactInDegreeOneAndNoneOfAConstant) {
    const std::vector<RootBox> boxes = roots({3, 2}, 64);
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_EQ(boxes[0].lower, Rational(-3, 2));
    EXPECT_EQ(boxes[0].upper, Rational(-3, 2));
    EXPECT_EQ(boxes[0].modulus_lower, Rational(3, 2));
    EXPECT_THAT(roots({7}, 64), IsEmpty());
}

TEST(Roots, NarrowWithTheBits) {
    for (int bits = 64; bits <= 1024; bits *= 2) {
        const RootBox root = roots({-2, 0, 1}, bits).back();
        EXPECT_LT(root.lower * root.lower, 2);
        EXPECT_GT(root.upper * root.upper, 2);
        EXPECT_LT((root.upper - root.lower) << static_cast<mp_bitcnt_t>(bits - 2), 1);
    }
}

TEST(Roots, RefuseZeroAndDoubleRoots) {
    EXPECT_THROW((void)roots({}, 64), std::invalid_argument);
    EXPECT_THROW((void)roots({1, 2, 1}, 64), std::invalid_argument);
}
