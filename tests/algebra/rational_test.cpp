// SPDX-License-Identifier: MIT

#include "internode/algebra/fraction.h"
#include "internode/algebra/rational.h"
#include "tests/fixtures/numbers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

using namespace internode;

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

Rational power_of_two(int exponent) {
    Rational value(1);
    return exponent < 0 ? Rational(value >> static_cast<mp_bitcnt_t>(-exponent))
                        : Rational(value << static_cast<mp_bitcnt_t>(exponent));
}

/// No double is nearer; of two that are equally near it is the even one. This is the definition.
void expect_nearest(const Rational& value) {
    const double nearest = to_double(value);
    ASSERT_TRUE(std::isfinite(nearest)) << value;
    const Rational error = abs(Rational(value - to_rational(nearest)));
    for (const double neighbour :
         {std::nextafter(nearest, -tests::infinity), std::nextafter(nearest, tests::infinity)}) {
        if (!std::isfinite(neighbour)) continue;
        const Rational other = abs(Rational(value - to_rational(neighbour)));
        ASSERT_LE(error, other) << value;
        if (error == other) {
            ASSERT_EQ(std::bit_cast<std::uint64_t>(nearest) & 1U, 0U) << value;
        }
    }
}

/// The lower neighbour, the double, points around the tie above it.
void expect_nearest_around(double value) {
    const Rational here = to_rational(value);
    const double next = std::nextafter(value, tests::infinity);
    const Rational gap = std::isfinite(next) ? Rational(to_rational(next) - here) : power_of_two(971);
    const Rational tie = here + gap / 2;
    for (const Rational& point : {here, Rational(here + gap / 3), Rational(tie - gap / 1000000), tie,
                                  Rational(tie + gap / 1000000), Rational(here + 2 * gap / 3)}) {
        if (point >= to_rational(largest) + power_of_two(970)) continue; // beyond: infinity, tested by itself
        expect_nearest(point);
        expect_nearest(-point);
    }
}

double random_double(std::mt19937_64& random) {
    for (;;) {
        const double value = std::bit_cast<double>(random());
        if (std::isfinite(value)) return std::abs(value);
    }
}

} // namespace

TEST(ParseRational, ReadsIntegersFractionsAndDecimalsExactly) {
    EXPECT_EQ(parse_rational("3"), Rational(3));
    EXPECT_EQ(parse_rational("-3/2"), Rational(-3, 2));
    EXPECT_EQ(parse_rational("6/4"), Rational(3, 2));
    EXPECT_EQ(parse_rational("0.25"), Rational(1, 4));
    EXPECT_EQ(parse_rational(".5"), Rational(1, 2));
    EXPECT_EQ(parse_rational("-.5"), Rational(-1, 2));
    EXPECT_EQ(parse_rational("1.5e-3"), Rational(3, 2000));
    EXPECT_EQ(parse_rational("1.5E+3"), Rational(1500));
    EXPECT_EQ(parse_rational("2e3"), Rational(2000));
    EXPECT_EQ(parse_rational("007"), Rational(7));
    EXPECT_EQ(parse_rational("-0"), Rational(0));
    EXPECT_EQ(parse_rational("0.1"), Rational(1, 10));
}

TEST(ParseRational, TakesTheWholeTextOrNothing) {
    for (const char* text : {"",    "-",    ".",     "-.",    "1.",    "+1",   "--1", " 1",  "1 ",    "1/",
                             "/2",  "1/-2", "1/2/3", "1/2.5", "1.5/2", "0x10", "1e",  "1e+", "e5",    "1e5.0",
                             "1,5", "nan",  "inf",   "1e5e5", "1..2",  "1-2",  "½",   "1e-", "1/2e3", "1'000"})
        EXPECT_EQ(parse_rational(text), std::nullopt) << text;
    using namespace std::string_view_literals;
    EXPECT_EQ(parse_rational("1\0"sv), std::nullopt);
}

TEST(ParseRational, RefusesAZeroDenominator) {
    EXPECT_EQ(parse_rational("1/0"), std::nullopt);
    EXPECT_EQ(parse_rational("0/00"), std::nullopt);
}

TEST(ParseRational, RefusesMoreDigitsThanTheLimit) {
    EXPECT_TRUE(parse_rational(std::string(max_digits, '7')));
    EXPECT_FALSE(parse_rational(std::string(max_digits + 1, '7')));
    EXPECT_TRUE(parse_rational("0." + std::string(max_digits - 1, '7')));
    EXPECT_FALSE(parse_rational("0." + std::string(max_digits, '7')));
    EXPECT_TRUE(parse_rational("1/" + std::string(max_digits - 1, '7')));
    EXPECT_FALSE(parse_rational("1/" + std::string(max_digits, '7')));
}

TEST(ParseRational, RefusesExponentsBeyondTheLimit) {
    EXPECT_TRUE(parse_rational("1e400"));
    EXPECT_TRUE(parse_rational("1e-400"));
    EXPECT_FALSE(parse_rational("1e401"));
    EXPECT_FALSE(parse_rational("1e-401"));
    EXPECT_FALSE(parse_rational("1e99999999999999999999"));
    EXPECT_TRUE(parse_rational("1e000000000000000000001"));
}

TEST(RationalText, IsReadBack) {
    for (const char* text : {"3/2", "-7", "0", "123456789012345678901234567890/23"}) {
        const auto value = parse_rational(text);
        ASSERT_TRUE(value) << text;
        EXPECT_EQ(to_string(*value), text);
    }
}

TEST(RationalToDouble, IsExactForDoubles) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const double value = random_double(random);
        ASSERT_EQ(to_double(to_rational(value)), value);
        ASSERT_EQ(to_double(to_rational(-value)), -value);
    }
}

TEST(RationalToDouble, IsTheNearestDoubleTiesToEven) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 3000; ++i) expect_nearest_around(random_double(random));
    for (const double value : {1.0, std::nextafter(1.0, 0.0), std::nextafter(2.0, 0.0), 0.1, 1e300, largest})
        expect_nearest_around(value);
}

TEST(RationalToDouble, RoundsSubnormalsOnce) {
    constexpr double normal = std::numeric_limits<double>::min();
    for (double value = least; value < 40 * least; value += least) expect_nearest_around(value);
    for (const double value :
         {normal, std::nextafter(normal, 0.0), std::nextafter(normal, 1.0), normal / 2, 2 * normal})
        expect_nearest_around(value);
    EXPECT_EQ(to_double(power_of_two(-1074)), least);
    EXPECT_EQ(to_double(power_of_two(-1075)), 0);
    EXPECT_EQ(to_double(power_of_two(-1075) + power_of_two(-1200)), least);
    EXPECT_EQ(to_double(3 * power_of_two(-1075)), 2 * least);
    EXPECT_EQ(to_double(power_of_two(-5000)), 0);
}

TEST(RationalToDouble, HasNoNegativeZero) {
    EXPECT_FALSE(std::signbit(to_double(-power_of_two(-5000))));
    EXPECT_FALSE(std::signbit(to_double(Rational(0))));
}

TEST(RationalToDouble, OverflowsFromHalfAUnitAboveTheLargest) {
    const Rational edge = to_rational(largest) + power_of_two(970);
    EXPECT_EQ(to_double(edge), tests::infinity);
    EXPECT_EQ(to_double(-edge), -tests::infinity);
    EXPECT_EQ(to_double(edge - power_of_two(-100)), largest);
    EXPECT_EQ(to_double(power_of_two(1024)), tests::infinity);
    EXPECT_EQ(to_double(-power_of_two(100000)), -tests::infinity);
}

TEST(RationalToDouble, RoundsLikeTheCompilerDoes) {
    EXPECT_EQ(to_double(*parse_rational("0.1")), 0.1);
    EXPECT_EQ(to_double(*parse_rational("1e23")), 1e23);
    EXPECT_EQ(to_double(*parse_rational("2.2250738585072011e-308")), 2.2250738585072011e-308);
    EXPECT_EQ(to_double(*parse_rational("1.7976931348623157e308")), largest);
    for (int numerator = -200; numerator <= 200; ++numerator)
        for (int denominator = 1; denominator <= 200; ++denominator)
            ASSERT_EQ(to_double(fraction(numerator, denominator)), static_cast<double>(numerator) / denominator);
}

TEST(DoubleToRational, RefusesWhatIsNotFinite) {
    EXPECT_THROW((void)to_rational(tests::infinity), std::invalid_argument);
    EXPECT_THROW((void)to_rational(-tests::infinity), std::invalid_argument);
    EXPECT_THROW((void)to_rational(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
    EXPECT_EQ(to_rational(-0.0), Rational(0));
}
