// SPDX-License-Identifier: MIT

#include "internode/report/picture/svg.h"

#include "tests/report/systems.h"

#include <cmath>
#include <numbers>

namespace internode {
namespace {

TEST(Svg, WritesFixedDecimalsWithoutNoise) {
    EXPECT_EQ(fixed(1.0), "1");
    EXPECT_EQ(fixed(-0.001), "0");
    EXPECT_EQ(fixed(0.125, 3), "0.125");
    EXPECT_EQ(fixed(100), "100");
    EXPECT_EQ(fixed(-12.3456), "-12.35");
    EXPECT_EQ(fixed(1e300, 0).size(), 301U);
}

TEST(Svg, PointsOfTheCircleStartAtTheTopAndTurnClockwise) {
    for (std::size_t count = 1; count <= 70; ++count) {
        const std::vector<Point2> points = points_on_circle(count);
        ASSERT_EQ(points.size(), count);
        for (std::size_t k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
            EXPECT_NEAR(points[k].x, std::sin(angle), 1e-14);
            EXPECT_NEAR(points[k].y, -std::cos(angle), 1e-14);
        }
    }
}

TEST(Svg, AFileCarriesVersionAndCommandAsText) {
    const std::string text = svg_open({.width = 10,
                                       .height = 20,
                                       .title = testing_report::hostile,
                                       .description = testing_report::hostile,
                                       .generator = {"0.1.0", "internode " + testing_report::hostile}},
                                      SvgPlace::File);
    EXPECT_NE(text.find("<metadata>internode 0.1.0: internode"), std::string::npos);
    testing_report::expect_inert(text);
}

} // namespace
} // namespace internode
