// SPDX-License-Identifier: MIT

#include "internode/expression/operation.h"

#include "internode/algebra/fraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace internode {
namespace {

constexpr Operation all_operations[] = {
    Operation::Negate,   Operation::Add,       Operation::Subtract, Operation::Multiply,     Operation::Divide,
    Operation::Minimum,  Operation::Maximum,   Operation::Floor,    Operation::Absolute,     Operation::SquareRoot,
    Operation::Less,     Operation::LessEqual, Operation::Greater,  Operation::GreaterEqual, Operation::Equal,
    Operation::NotEqual, Operation::And,       Operation::Or,       Operation::Not};

/// Multiples of 1/4 from -3 to 3: sums, products and quotients by powers of two are exact in doubles.
std::vector<Rational> quarters() {
    std::vector<Rational> values;
    for (int k = -12; k <= 12; ++k) values.push_back(fraction(k, 4));
    return values;
}

TEST(Operation, OfTwoEqualValuesTheFirstIsTheLeastAndTheLargest) {
    for (const Operation operation : {Operation::Minimum, Operation::Maximum}) {
        EXPECT_TRUE(std::signbit(apply_operation(operation, -0.0, 0.0)));
        EXPECT_FALSE(std::signbit(apply_operation(operation, 0.0, -0.0)));
    }
}

TEST(Operation, ExactValuesAndDoublesAgree) {
    std::size_t compared = 0;
    for (const Operation operation : all_operations)
        for (const Rational& a : quarters())
            for (const Rational& b : quarters()) {
                const std::optional<Rational> exact = apply_exactly(operation, a, b);
                if (!exact) continue;
                EXPECT_EQ(to_double(*exact), apply_operation(operation, to_double(a), to_double(b)))
                    << static_cast<int>(operation) << ' ' << a << ' ' << b;
                ++compared;
            }
    EXPECT_GT(compared, 10'000U);
}

TEST(Operation, HasNoExactValueForADivisionByZeroAndForOtherRoots) {
    EXPECT_EQ(apply_exactly(Operation::Divide, 1, 0), std::nullopt);
    for (const Rational& a : quarters()) {
        const std::optional<Rational> root = apply_exactly(Operation::SquareRoot, a, a);
        const double rounded = 2 * std::sqrt(std::abs(to_double(a)));
        EXPECT_EQ(root.has_value(), a >= 0 && rounded == std::floor(rounded)) << a;
        EXPECT_EQ(root ? Rational(*root * *root) : a, a);
    }
}

TEST(Operation, CountsTheBitsOfBothHalvesOfAFraction) {
    EXPECT_EQ(bit_size(Rational(5)), 3U + 1U);
    EXPECT_EQ(bit_size(Rational(-1, 1024)), 1U + 11U);
}

} // namespace
} // namespace internode
