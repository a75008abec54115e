// SPDX-License-Identifier: MIT

#include "internode/expression/known_number.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace internode {
namespace {

KnownNumber exactly(const Rational& value) {
    return {value, 0};
}

KnownNumber of_two(Operation operation, const Rational& a, const Rational& b) {
    const std::array<KnownNumber, 2> arguments{exactly(a), exactly(b)};
    return apply_operation(operation, arguments);
}

KnownNumber of_one(Operation operation, const Rational& a) {
    const std::array<KnownNumber, 1> arguments{exactly(a)};
    return apply_operation(operation, arguments);
}

TEST(KnownNumber, RationalOperationsStayExact) {
    EXPECT_EQ(of_two(Operation::Add, {1, 3}, {1, 6}).exact, Rational(1, 2));
    EXPECT_EQ(of_two(Operation::Subtract, {1, 3}, {1, 6}).exact, Rational(1, 6));
    EXPECT_EQ(of_two(Operation::Multiply, {2, 3}, {3, 4}).exact, Rational(1, 2));
    EXPECT_EQ(of_two(Operation::Divide, {2, 3}, {4, 3}).exact, Rational(1, 2));
    EXPECT_EQ(of_two(Operation::Minimum, {1, 3}, {1, 2}).exact, Rational(1, 3));
    EXPECT_EQ(of_two(Operation::Maximum, {1, 3}, {1, 2}).exact, Rational(1, 2));
    EXPECT_EQ(of_one(Operation::Negate, {1, 3}).exact, Rational(-1, 3));
    EXPECT_EQ(of_one(Operation::Absolute, {-1, 3}).exact, Rational(1, 3));
    EXPECT_EQ(of_one(Operation::Floor, {-1, 3}).exact, Rational(-1));
    EXPECT_EQ(of_one(Operation::Floor, {7, 3}).exact, Rational(2));
}

TEST(KnownNumber, TruthsAreOneAndZero) {
    EXPECT_EQ(of_two(Operation::Less, {1, 3}, {1, 2}).exact, Rational(1));
    EXPECT_EQ(of_two(Operation::Equal, {1, 3}, {1, 2}).exact, Rational(0));
    EXPECT_EQ(of_two(Operation::And, 1, 0).exact, Rational(0));
    EXPECT_EQ(of_two(Operation::Or, 1, 0).exact, Rational(1));
    EXPECT_EQ(of_one(Operation::Not, 0).exact, Rational(1));
}

TEST(KnownNumber, TheRootOfASquareIsExactAndAnyOtherIsTheNearestDouble) {
    EXPECT_EQ(of_one(Operation::SquareRoot, {9, 4}).exact, Rational(3, 2));
    EXPECT_EQ(of_one(Operation::SquareRoot, 0).exact, Rational(0));
    const KnownNumber root = of_one(Operation::SquareRoot, 2);
    EXPECT_FALSE(root.exact);
    EXPECT_EQ(root.value, std::sqrt(2.0));
    EXPECT_TRUE(std::isnan(nearest(of_one(Operation::SquareRoot, -1))));
}

TEST(KnownNumber, ADivisionByZeroIsThatOfDoubles) {
    EXPECT_EQ(nearest(of_two(Operation::Divide, 1, 0)), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(nearest(of_two(Operation::Divide, 0, 0))));
}

TEST(KnownNumber, DoesNotGrowWithoutBound) {
    KnownNumber value = exactly({1, 3});
    for (int i = 0; i < 30; ++i) {
        const std::array<KnownNumber, 2> both{value, value};
        value = apply_operation(Operation::Multiply, both);
    }
    EXPECT_FALSE(value.exact);
    EXPECT_EQ(value.value, 0);
}

TEST(KnownNumber, MinimumAndMaximumPassNaNOnFromBothSides) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Operation operation : {Operation::Minimum, Operation::Maximum}) {
        EXPECT_TRUE(std::isnan(apply_operation(operation, nan, 1)));
        EXPECT_TRUE(std::isnan(apply_operation(operation, 1, nan)));
    }
}

} // namespace
} // namespace internode
