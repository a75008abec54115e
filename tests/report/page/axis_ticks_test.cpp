// SPDX-License-Identifier: MIT

#include "internode/report/page/axis_ticks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace internode {
namespace {

std::vector<std::string> labels(double least, double greatest, Scale scale) {
    std::vector<std::string> result;
    for (const Tick& tick : axis_ticks(least, greatest, scale)) result.push_back(tick.label);
    return result;
}

using Labels = std::vector<std::string>;

TEST(AxisTicks, AreRound) {
    EXPECT_EQ(labels(0, 1, Scale::Linear), (Labels{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
    EXPECT_EQ(labels(-0.3, 6.3, Scale::Linear), (Labels{"0", "1", "2", "3", "4", "5", "6"}));
}

TEST(AxisTicks, OfWholeNumbersAreWhole) {
    EXPECT_EQ(labels(-0.1, 2.1, Scale::Whole), (Labels{"0", "1", "2"}));
}

TEST(AxisTicks, OfLogarithmsArePowersOfTen) {
    EXPECT_EQ(labels(-6.5, 0.5, Scale::Logarithmic), (Labels{"10⁻⁶", "10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1"}));
    EXPECT_EQ(labels(0.9, 2.1, Scale::Logarithmic), (Labels{"10", "20", "50", "100"}));
    EXPECT_EQ(labels(5.9, 6.5, Scale::Logarithmic), (Labels{"10⁶", "2·10⁶"}));
}

TEST(AxisTicks, AreNeitherTooFewNorTooManyAtAnyScale) {
    for (int exponent = -300; exponent <= 300; exponent += 7) {
        const double extent = std::pow(10, exponent);
        const std::vector<Tick> ticks = axis_ticks(0.1 * extent, 1.3 * extent, Scale::Linear);
        EXPECT_GE(ticks.size(), 3U) << exponent;
        EXPECT_LE(ticks.size(), 13U) << exponent;
        for (const Tick& tick : ticks) EXPECT_TRUE(tick.place >= 0.1 * extent && tick.place <= 1.3 * extent);
    }
}

} // namespace
} // namespace internode
