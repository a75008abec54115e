// SPDX-License-Identifier: MIT

#include "internode/text/number.h"

#include "tests/fixtures/stride.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace internode {
namespace {

const int random_doubles = tests::times(1'000'000);

std::uint64_t bits(double value) {
    return std::bit_cast<std::uint64_t>(value);
}

TEST(Number, ReadsWhatItWroteBitForBit) {
    std::mt19937_64 random(1);
    for (int i = 0; i < random_doubles; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (!std::isfinite(value)) continue;
        const auto back = parse_double(to_string(value));
        ASSERT_TRUE(back) << to_string(value);
        ASSERT_EQ(bits(*back), bits(value)) << to_string(value);
    }
}

TEST(Number, KeepsTheSignOfZeroAndTheEndsOfTheRange) {
    using Limits = std::numeric_limits<double>;
    for (const double value : {0.0, -0.0, Limits::max(), Limits::lowest(), Limits::min(), Limits::denorm_min(),
                               -Limits::denorm_min(), std::nextafter(1.0, 2.0)})
        EXPECT_EQ(bits(parse_double(to_string(value)).value()), bits(value));
    EXPECT_EQ(to_string(-0.0), "-0");
}

TEST(Number, WritesTheShortestText) {
    EXPECT_EQ(to_string(0.1), "0.1");
    EXPECT_EQ(to_string(1.0), "1");
    EXPECT_EQ(to_string(0.2360679774997897), "0.2360679774997897");
    EXPECT_EQ(to_string(1e22), "1e+22");
}

TEST(Number, ReadsTheFormsThatFilesHave) {
    EXPECT_EQ(parse_double("3"), 3.0);
    EXPECT_EQ(parse_double("+1.5"), 1.5);
    EXPECT_EQ(parse_double(".5"), 0.5);
    EXPECT_EQ(parse_double("-5."), -5.0);
    EXPECT_EQ(parse_double("1E-3"), 0.001);
    EXPECT_EQ(parse_double("007"), 7.0);
}

TEST(Number, RefusesWhatIsNotAWholeFiniteNumber) {
    for (const char* text : {"",
                             "+",
                             "-",
                             ".",
                             "e5",
                             "1e",
                             "1e+",
                             "1,5",
                             "1 ",
                             " 1",
                             "0x10",
                             "nan",
                             "NaN",
                             "-nan(0)",
                             "inf",
                             "-Infinity",
                             "1e400",
                             "-1e309",
                             "1.7976931348623159e308",
                             "++1",
                             "+-1",
                             "--1",
                             "1.2.3",
                             "1_000",
                             "٣",
                             "1e999999999999999999999"})
        EXPECT_FALSE(parse_double(text)) << text;
    EXPECT_FALSE(parse_double(std::string_view("1\0", 2)));
}

TEST(Number, RoundsWhatIsTooSmallToAZeroOfItsSign) {
    for (const char* text : {"1e-400", "2e-324", "1e-999999999999999999999", "0.00000000001e-320", "12345e-340"})
        EXPECT_EQ(bits(parse_double(text).value()), bits(0.0)) << text;
    EXPECT_EQ(bits(parse_double("-1e-400").value()), bits(-0.0));
    EXPECT_EQ(bits(parse_double("-0").value()), bits(-0.0));
    EXPECT_EQ(parse_double("0e99999999999999999999"), 0.0);
    const std::string zeros(400, '0');
    EXPECT_EQ(parse_double("0." + zeros + "1e5"), 0.0) << "an exponent up does not reach a double";
    EXPECT_FALSE(parse_double("1" + zeros + "e-5")) << "nor one down";
    const std::string tiny = "0." + std::string(5000, '0') + "1";
    EXPECT_EQ(parse_double(tiny), 0.0);
    EXPECT_EQ(parse_double(tiny + "e5001"), 1.0);
    EXPECT_FALSE(parse_double("1" + std::string(5000, '0')));
}

TEST(Number, IsCorrectlyRoundedHalfwayBetweenDoubles) {
    EXPECT_EQ(parse_double("9007199254740993"), 9007199254740992.0);
    EXPECT_EQ(parse_double("9007199254740993.0000000000000000000000000000000000001"), 9007199254740994.0);
    EXPECT_EQ(parse_double("2.4703282292062327208e-324"), 0.0);
    EXPECT_EQ(parse_double("2.4703282292062328e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(Number, WillNotWriteWhatIsNotFinite) {
    using Limits = std::numeric_limits<double>;
    EXPECT_THROW((void)to_string(Limits::quiet_NaN()), std::invalid_argument);
    EXPECT_THROW((void)to_string(Limits::infinity()), std::invalid_argument);
    EXPECT_THROW((void)to_string(-Limits::infinity()), std::invalid_argument);
}

} // namespace
} // namespace internode
