// SPDX-License-Identifier: MIT

#include "internode/algebra/symbolic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace internode {
namespace {

const std::array<std::string, 3> names{"t", "n", "s"};

Symbolic number(const char* text) {
    return Symbolic(*parse_rational(text));
}
Symbolic t() {
    return Symbolic::variable(0);
}
Symbolic n() {
    return Symbolic::variable(1);
}
Symbolic plus(const Symbolic& a, const Symbolic& b) {
    return add(a, b).value();
}
Symbolic times(const Symbolic& a, const Symbolic& b) {
    return multiply(a, b).value();
}
std::string text(const Symbolic& value) {
    return to_string(value, names);
}

TEST(Symbolic, PrintsAsPeopleWrite) {
    EXPECT_EQ(text(Symbolic()), "0");
    EXPECT_EQ(text(number("5/4")), "5/4");
    EXPECT_EQ(text(number("-5/4")), "-5/4");
    EXPECT_EQ(text(plus(number("1"), times(number("-2"), t()))), "1 - 2 t");
    EXPECT_EQ(text(times(number("1/2"), times(t(), t()))), "1/2 t^2");
    EXPECT_EQ(text(times(plus(t(), n()), plus(t(), n()))), "t^2 + 2 t n + n^2");
    EXPECT_EQ(text(-t()), "-t");
    EXPECT_EQ(text(divide(number("1"), times(number("2"), n())).value()), "1/(2 n)");
    EXPECT_EQ(text(divide(plus(n(), number("-1")), times(number("2"), n())).value()), "(-1 + n)/(2 n)");
    EXPECT_EQ(text(divide(number("1"), n()).value()), "1/n");
}

TEST(Symbolic, WhatDividesExactlyIsCancelled) {
    const Symbolic square = times(plus(t(), n()), plus(t(), n()));
    EXPECT_EQ(text(divide(square, plus(t(), n())).value()), "t + n");
    EXPECT_EQ(text(divide(plus(t(), n()), square).value()), "1/(t + n)");
    EXPECT_TRUE(divide(square, square).value().is_one());
}

TEST(Symbolic, WeightsOfACorneringRuleSumToOne) {
    EXPECT_TRUE(plus(plus(number("1"), -t()), t()).is_one());
    // 1/n + (n-1)/n and 1/(1+t) + t/(1+t)
    const Symbolic inverse = divide(number("1"), n()).value();
    EXPECT_TRUE(plus(inverse, times(plus(n(), number("-1")), inverse)).is_one());
    const Symbolic below = plus(number("1"), t());
    EXPECT_TRUE(plus(divide(number("1"), below).value(), divide(t(), below).value()).is_one());
    EXPECT_FALSE(plus(number("1"), t()).is_one());
}

TEST(Symbolic, IdentityNeedsNoCommonDivisor) {
    // (t² - n²)(t + 2)/((t + n)(t + 3)) against (t - n)(t + 2)/(t + 3), and against something else
    const Symbolic two = plus(t(), number("2"));
    const Symbolic three = plus(t(), number("3"));
    const Symbolic squares = plus(times(t(), t()), -times(n(), n()));
    const Symbolic left = divide(times(squares, two), times(plus(t(), n()), three)).value();
    const Symbolic right = divide(times(plus(t(), -n()), two), three).value();
    EXPECT_EQ(identical(left, right), true);
    EXPECT_EQ(identical(left, plus(right, number("1/1000000"))), false);
    EXPECT_TRUE(plus(plus(left, -right), number("1")).is_one());
}

TEST(Symbolic, RingLawsOnAllSmallPolynomials) {
    std::vector<Symbolic> all;
    for (int a = -1; a <= 1; ++a)
        for (int b = -1; b <= 1; ++b)
            for (int c = -1; c <= 1; ++c)
                all.push_back(plus(plus(Symbolic(Rational(a)), times(Symbolic(Rational(b)), t())),
                                   times(Symbolic(Rational(c)), n())));
    const std::array<double, 3> at{1.25, -3.5, 0};
    for (const Symbolic& a : all)
        for (const Symbolic& b : all) {
            EXPECT_EQ(plus(a, b).evaluate(at), a.evaluate(at) + b.evaluate(at));
            EXPECT_EQ(times(a, b).evaluate(at), a.evaluate(at) * b.evaluate(at));
            EXPECT_EQ(identical(plus(a, b), plus(b, a)), true);
            EXPECT_EQ(identical(times(a, b), times(b, a)), true);
            EXPECT_TRUE(plus(plus(a, b), plus(-a, -b)).is_zero());
            if (b.is_zero()) continue;
            EXPECT_EQ(identical(times(divide(a, b).value(), b), a), true);
            EXPECT_EQ(identical(plus(divide(a, b).value(), divide(n(), t()).value()),
                                divide(plus(times(a, t()), times(b, n())), times(b, t())).value()),
                      true);
        }
}

TEST(Symbolic, ConstantsAndVariables) {
    EXPECT_EQ(number("3/4").constant(), Rational(3, 4));
    EXPECT_EQ(Symbolic().constant(), Rational(0));
    EXPECT_FALSE(t().constant());
    EXPECT_EQ(divide(number("1"), plus(t(), n())).value().variables(), (std::vector<SymbolicVariable>{0, 1}));
    EXPECT_TRUE(number("2").variables().empty());
}

TEST(Symbolic, RefusesAQuotientByZero) {
    EXPECT_THROW((void)divide(t(), Symbolic()), std::domain_error);
    EXPECT_THROW((void)divide(t(), plus(t(), -t())), std::domain_error);
}

TEST(Symbolic, BeyondTheLimitsThereIsNoResult) {
    std::optional<Symbolic> power = plus(number("1"), t());
    int squarings = 0;
    while (power) {
        power = multiply(*power, *power);
        ++squarings;
    }
    EXPECT_EQ(squarings, 8) << "degree 128 is within the limit of 200, degree 256 is not";
    std::optional<Symbolic> constant = number("3");
    for (squarings = 0; constant; ++squarings) constant = multiply(*constant, *constant);
    EXPECT_EQ(squarings, 12) << "3^2048 has 3,247 bits, 3^4096 has more than 4,096";
    std::optional<Symbolic> dense = number("1");
    Symbolic sum = number("1");
    for (SymbolicVariable variable = 0; variable < 40; ++variable) sum = plus(sum, Symbolic::variable(variable));
    while (dense) dense = multiply(*dense, sum);
    SUCCEED() << "a dense power of many variables ends";
}

TEST(Symbolic, BothSidesOfAQuotientStayWithinTheLimits) {
    Symbolic power = t();
    while (2 * power.numerator().begin()->first.at(0).second <= symbolic_limits.degree) power = times(power, power);
    const Symbolic inverse = divide(number("1"), power).value();
    EXPECT_TRUE(divide(power, power).value().is_one());
    EXPECT_TRUE(times(power, inverse).is_one());
    EXPECT_FALSE(divide(power, inverse)) << "above";
    EXPECT_FALSE(divide(inverse, power)) << "below";
    EXPECT_FALSE(multiply(power, power)) << "above";
    EXPECT_FALSE(multiply(inverse, inverse)) << "below";
}

} // namespace
} // namespace internode
