// SPDX-License-Identifier: MIT

#include "internode/algebra/fraction.h"
#include "internode/algebra/number.h"
#include "tests/fixtures/numbers.h"
#include "tests/reference/real_root.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

using namespace internode;
using testing::ElementsAre;

namespace {

struct Example {
    Polynomial polynomial;
    reference::Interval root;
};

/// Quadratic, cubic with one and with three real roots, and the degree of a slow growth of 32 symbols.
std::vector<Example> examples() {
    Polynomial slow(33);
    slow.front() = -2;
    slow.back() = 1;
    return {
        {{-1, -1, 1}, {1, 2}}, {{-2, 0, 1}, {1, 2}}, {{-1, -1, 0, 1}, {1, 2}}, {{1, -3, 0, 1}, {1, 2}}, {slow, {1, 2}}};
}

NumberField field_of(const Example& example) {
    return NumberField(example.polynomial, example.root.first, example.root.second);
}

NumberField golden() {
    return NumberField({-1, -1, 1}, 1, 2);
}

/// Q(ρ) with ρ = `root`: degree 1, the case that e-antic gets wrong.
NumberField linear(long root) {
    return NumberField({-root, 1}, root, root);
}

std::vector<Rational> random_coefficients(std::mt19937& random, std::size_t count, int size) {
    std::vector<Rational> result;
    for (std::size_t i = 0; i < count; ++i) {
        const int numerator = static_cast<int>(random() % static_cast<unsigned>(2 * size + 1)) - size;
        result.push_back(fraction(numerator, 1 + static_cast<int>(random() % 12)));
    }
    return result;
}

} // namespace

TEST(NumberField, OfRationalsIsGeneratedByOne) {
    const NumberField rationals;
    EXPECT_EQ(rationals.degree(), 1U);
    EXPECT_THAT(rationals.minimal_polynomial(), ElementsAre(-1, 1));
    EXPECT_EQ(rationals.generator(), Number(1));
    EXPECT_EQ(rationals, NumberField());
}

TEST(NumberField, GeneratorIsTheRootInTheInterval) {
    for (const Example& example : examples()) {
        const NumberField field = field_of(example);
        const Number root = field.generator();
        EXPECT_EQ(field.degree(), example.polynomial.size() - 1);
        EXPECT_EQ(field.minimal_polynomial(), example.polynomial);
        EXPECT_GT(root, Number(example.root.first));
        EXPECT_LT(root, Number(example.root.second));
        Number value;
        for (std::size_t i = example.polynomial.size(); i-- > 0;)
            value = value * root + Number(Rational(example.polynomial[i]));
        EXPECT_EQ(value, Number(0));
    }
}

TEST(NumberField, OfDegreeOneHasARationalGenerator) {
    for (const long root : {-3L, 0L, 1L, 2L, 7L}) {
        const NumberField field = linear(root);
        EXPECT_EQ(field.degree(), 1U);
        EXPECT_EQ(field.generator(), Number(root));
        EXPECT_EQ(field.generator() * field.generator() + 1, Number(root * root + 1));
        EXPECT_EQ((field.generator() + 1).to_string(field, "ρ"), Number(root + 1).to_string(NumberField(), "ρ"));
    }
}

TEST(NumberField, IsEqualByPolynomialAndRoot) {
    EXPECT_EQ(golden(), NumberField({-1, -1, 1}, Rational(3, 2), 100));
    EXPECT_FALSE(golden() == NumberField({-1, -1, 1}, -1, 0));
    EXPECT_FALSE(golden() == NumberField({-2, 0, 1}, 1, 2));
    EXPECT_EQ(linear(2), linear(2));
    EXPECT_FALSE(linear(2) == linear(3));
    EXPECT_EQ(golden().generator(), NumberField({-1, -1, 1}, 0, 5).generator());
}

TEST(NumberField, RefusesAnIntervalThatDoesNotIsolateOneRoot) {
    EXPECT_THROW(NumberField({-1, -1, 1}, -1, 2), std::invalid_argument);
    EXPECT_THROW(NumberField({-1, -1, 1}, 2, 3), std::invalid_argument);
    EXPECT_THROW(NumberField({1, 0, 1}, -2, 2), std::invalid_argument);
    EXPECT_THROW(NumberField({-2, 1}, 3, 4), std::invalid_argument);
}

TEST(NumberField, RefusesWhatIsNoMinimalPolynomial) {
    EXPECT_THROW(NumberField({-4, 0, 1}, 1, 3), std::invalid_argument);
    EXPECT_THROW(NumberField({1, -2, 1}, 0, 2), std::invalid_argument);
    EXPECT_THROW(NumberField({-1, 0, 2}, 0, 1), std::invalid_argument);
    EXPECT_THROW(NumberField({1}, 0, 1), std::invalid_argument);
    EXPECT_THROW(NumberField({}, 0, 1), std::invalid_argument);
}

TEST(NumberField, IsolatesRootsThatNearlyMeet) {
    // x^2 - 2a x + a^2 - 1 shifted: roots a ± sqrt(2)/10^20 after scaling: (N x - 1)^2 - 2 x^0, N = 10^20, made monic.
    const Integer big = Integer("100000000000000000000");
    const Polynomial close{big * big - 2, -2 * big, 1};
    const NumberField upper(close, Rational(big), Rational(big + 2));
    const NumberField lower(close, Rational(big - 2), Rational(big));
    EXPECT_EQ(upper.generator().to_double(), lower.generator().to_double());
    EXPECT_FALSE(upper == lower);
    EXPECT_EQ((upper.generator() - Number(Rational(big))).to_double(), std::sqrt(2.0));
}

TEST(Number, IsZeroByDefaultAndAfterAMove) {
    Number number = golden().generator();
    const Number taken = std::move(number);
    EXPECT_EQ(Number(), Number(0));
    EXPECT_EQ(number, Number(0)); // NOLINT(bugprone-use-after-move): that is the promise
    EXPECT_EQ(taken, golden().generator());
    number = taken;
    EXPECT_EQ(number, taken);
    const Number& alias = number;
    number = alias;
    EXPECT_EQ(number, taken);
}

TEST(Number, ObeysTheLawsOfAField) {
    std::mt19937 random(1);
    for (const Example& example : examples()) {
        const NumberField field = field_of(example);
        for (int i = 0; i < 20; ++i) {
            const Number a(field, random_coefficients(random, field.degree(), 9));
            const Number b(field, random_coefficients(random, field.degree(), 9));
            const Number c(field, random_coefficients(random, 1, 9));
            EXPECT_EQ((a + b) * c, a * c + b * c);
            EXPECT_EQ((a * b) * c, a * (b * c));
            EXPECT_EQ(a - b, -(b - a));
            EXPECT_EQ(a - a, Number(0));
            if (a.sign() != 0) {
                EXPECT_EQ(b / a * a, b);
            }
            EXPECT_EQ((a <=> b), (Number(0) <=> b - a));
            EXPECT_EQ((a <=> b) < 0, (a - b).sign() < 0);
        }
    }
}

TEST(Number, MayBeItsOwnOperand) {
    const Number root = golden().generator();
    Number x = root;
    const Number& same = x;
    x += same;
    EXPECT_EQ(x, 2 * root);
    x *= same;
    EXPECT_EQ(x, 4 * root + 4);
    x /= same;
    EXPECT_EQ(x, Number(1));
    x -= same;
    EXPECT_EQ(x, Number());
}

TEST(Number, RefusesDivisionByZero) {
    const Number root = golden().generator();
    EXPECT_THROW((void)(root / Number()), std::domain_error);
    EXPECT_THROW((void)(root / (root - root)), std::domain_error);
    EXPECT_THROW((void)(Number(1) / Number(0)), std::domain_error);
}

TEST(Number, RefusesToMixTwoFields) {
    const Number phi = golden().generator();
    const Number root = NumberField({-2, 0, 1}, 1, 2).generator();
    EXPECT_THROW((void)(phi + root), std::invalid_argument);
    EXPECT_THROW((void)(phi * root), std::invalid_argument);
    EXPECT_THROW((void)(phi < root), std::invalid_argument);
    EXPECT_THROW((void)(phi == root), std::invalid_argument);
}

TEST(Number, TakesARationalOfAnotherFieldWithoutAWord) {
    const Number phi = golden().generator();
    const Number root = NumberField({-2, 0, 1}, 1, 2).generator();
    testing::internal::CaptureStderr();
    EXPECT_EQ(phi + root * root, phi + 2);
    EXPECT_EQ(root * root * phi, 2 * phi);
    EXPECT_LT(phi, root * root);
    EXPECT_EQ(phi * phi - phi, root * root - 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Number, GivesItsCoefficientsBack) {
    std::mt19937 random(2);
    for (const Example& example : examples()) {
        const NumberField field = field_of(example);
        for (int i = 0; i < 20; ++i) {
            const std::vector<Rational> coefficients = random_coefficients(random, field.degree(), 50);
            EXPECT_EQ(Number(field, coefficients).coefficients(field), coefficients);
        }
        std::vector<Rational> expected(field.degree());
        expected.front() = Rational(7, 3);
        EXPECT_EQ(Number(Rational(7, 3)).coefficients(field), expected);
        EXPECT_EQ((field.generator() - field.generator() + Rational(7, 3)).coefficients(field), expected);
    }
    EXPECT_THAT(Number(5).coefficients(linear(2)), ElementsAre(5));
    EXPECT_EQ(Number(linear(2), {}), Number(0));
    EXPECT_EQ(Number(golden(), {3}), Number(3));
}

TEST(Number, RefusesCoefficientsOfAnotherField) {
    EXPECT_THROW((void)golden().generator().coefficients(NumberField()), std::invalid_argument);
    EXPECT_THROW((void)golden().generator().coefficients(NumberField({-2, 0, 1}, 1, 2)), std::invalid_argument);
    EXPECT_THROW(Number(golden(), {1, 2, 3}), std::invalid_argument);
    EXPECT_THROW(Number(linear(2), {1, 2}), std::invalid_argument);
}

TEST(Number, KnowsWhetherItIsRational) {
    const Number phi = golden().generator();
    EXPECT_FALSE(phi.is_rational());
    EXPECT_TRUE((phi * (phi - 1)).is_rational());
    EXPECT_TRUE(Number(Rational(1, 3)).is_rational());
    EXPECT_TRUE(linear(3).generator().is_rational());
}

TEST(Number, ToDoubleIsTheDoubleOfATightEnclosure) {
    std::mt19937 random(3);
    for (const Example& example : examples()) {
        const NumberField field = field_of(example);
        const reference::Interval root = reference::bisect(example.polynomial, example.root, 600);
        for (int i = 0; i < 200; ++i) {
            const std::vector<Rational> coefficients =
                random_coefficients(random, field.degree(), i < 100 ? 9 : 1000000);
            const Number number(field, coefficients);
            const auto [lower, upper] = reference::enclose(coefficients, root);
            ASSERT_EQ(to_double(lower), to_double(upper));
            EXPECT_EQ(number.to_double(), to_double(lower));
            const auto [below, above] = number.enclosure();
            EXPECT_LE(Number(to_rational(below)), number);
            EXPECT_GE(Number(to_rational(above)), number);
            EXPECT_EQ(above, number.is_rational() && below == number.to_double()
                                 ? above
                                 : std::nextafter(below, tests::infinity));
        }
    }
}

TEST(Number, ToDoubleSurvivesCancellation) {
    // φ^-n = (-1)^n (F_(n+1) - F_n φ): coefficients of hundreds of digits for a value near 0.
    const Number small = pow(golden().generator(), -1000);
    EXPECT_GT(small.sign(), 0);
    EXPECT_EQ(small.to_double(), (Number(1) / pow(golden().generator(), 1000)).to_double());
    EXPECT_NEAR(std::log(small.to_double()), -1000 * std::log(1.6180339887498949), 1e-9);
}

TEST(Number, ToDoubleRoundsTinyAndHugeValues) {
    const Number phi = golden().generator();
    EXPECT_EQ(pow(phi, 2000).to_double(), tests::infinity);
    EXPECT_EQ((-pow(phi, 2000)).to_double(), -tests::infinity);
    const Number tiny = pow(phi, -2000);
    EXPECT_EQ(tiny.to_double(), 0);
    EXPECT_FALSE(std::signbit((-tiny).to_double()));
    const Number least = Number(to_rational(std::numeric_limits<double>::denorm_min()));
    EXPECT_EQ((least * phi).to_double(), 2 * std::numeric_limits<double>::denorm_min());
    EXPECT_EQ((least / phi).to_double(), std::numeric_limits<double>::denorm_min());
}

TEST(Number, EnclosureIsTheTightestPairOfDoubles) {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    const Number phi = golden().generator();
    EXPECT_EQ(Number(Rational(1, 4)).enclosure(), std::pair(0.25, 0.25));
    EXPECT_EQ(Number().enclosure(), std::pair(0.0, 0.0));
    EXPECT_EQ(phi.enclosure(), std::pair(std::nextafter(1.6180339887498949, 0), 1.6180339887498949));
    EXPECT_EQ(Number(Rational(1, 3)).enclosure(), std::pair(1.0 / 3, std::nextafter(1.0 / 3, 1)));
    EXPECT_EQ(pow(phi, 2000).enclosure(), std::pair(largest, tests::infinity));
    EXPECT_EQ((-pow(phi, 2000)).enclosure(), std::pair(-tests::infinity, -largest));
    EXPECT_EQ(pow(phi, -2000).enclosure(), std::pair(0.0, least));
    EXPECT_EQ((-pow(phi, -2000)).enclosure(), std::pair(-least, 0.0));
}

TEST(Number, ReadsAsAFormula) {
    const NumberField field({-2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, 1, 2);
    const Number rho = field.generator();
    const NumberField gold = golden();
    const Number phi = gold.generator();
    EXPECT_EQ((2 * phi - 3).to_string(gold, "φ"), "2φ−3");
    EXPECT_EQ((Number(4) * phi / 15 + Number(Rational(23, 120))).to_string(gold, "φ"), "4/15φ+23/120");
    EXPECT_EQ((-phi).to_string(gold, "φ"), "−φ");
    EXPECT_EQ((1 - phi).to_string(gold, "φ"), "−φ+1");
    EXPECT_EQ(phi.to_string(gold, "φ"), "φ");
    EXPECT_EQ(Number(Rational(3, 2)).to_string(gold, "φ"), "3/2");
    EXPECT_EQ(Number(-1).to_string(gold, "φ"), "−1");
    EXPECT_EQ(Number().to_string(gold, "φ"), "0");
    EXPECT_EQ((pow(rho, 11) - 2 * pow(rho, 10) + pow(rho, 3) / 2 - pow(rho, 2)).to_string(field, "ρ"),
              "ρ¹¹−2ρ¹⁰+1/2ρ³−ρ²");
    EXPECT_THROW((void)phi.to_string(field, "ρ"), std::invalid_argument);
}

TEST(NumberPower, AddsExponents) {
    for (const Example& example : examples()) {
        const Number root = field_of(example).generator();
        for (int a = -5; a <= 5; ++a)
            for (int b = -5; b <= 5; ++b) EXPECT_EQ(pow(root, a) * pow(root, b), pow(root, a + b));
    }
    EXPECT_EQ(pow(Number(2), 100), Number(Rational(Integer(1) << 100)));
    EXPECT_EQ(pow(Number(0), 0), Number(1));
    EXPECT_EQ(pow(Number(1), std::numeric_limits<int>::min()), Number(1));
}

TEST(NumberPower, RefusesZeroToANegativePower) {
    EXPECT_THROW((void)pow(Number(0), -1), std::domain_error);
}
