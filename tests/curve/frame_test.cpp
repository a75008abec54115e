// SPDX-License-Identifier: MIT

#include "internode/curve/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace internode {
namespace {

using Vector = std::vector<double>;

Vector tangent(const Vector& first) {
    Vector unit(first.size());
    unit_tangent(first, unit);
    return unit;
}

TEST(Tangent, HasLengthOneAtAnyScale) {
    for (const double scale : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
        const Vector unit = tangent({3 * scale, -4 * scale});
        EXPECT_DOUBLE_EQ(unit[0], 0.6);
        EXPECT_DOUBLE_EQ(unit[1], -0.8);
    }
    EXPECT_EQ(tangent({-2}), Vector{-1});
}

TEST(Tangent, IsNoneWhereTheCurveStops) {
    for (const double x : tangent({0, 0, 0})) EXPECT_TRUE(std::isnan(x));
    EXPECT_TRUE(std::isnan(curvature(Vector{0, 0}, Vector{1, 0})));
    EXPECT_TRUE(std::isnan(curvature(Vector{0}, Vector{0})));
}

TEST(Curvature, OfALineIsZeroWithoutASign) {
    for (const double x : {-2.0, -0.0, 0.0, 3.0})
        for (const double y : {-1.0, -0.0, 0.0, 5.0})
            for (const double bend : {-4.0, -0.5, -0.0, 0.0, 1.0, 4.0}) {
                if (x == 0 && y == 0) continue;
                for (const double zero : {-0.0, 0.0}) {
                    const double plane = curvature(Vector{x, y}, Vector{bend * x, bend * y});
                    const double along = curvature(Vector{x + y, zero}, Vector{bend, -zero});
                    const double space = curvature(Vector{x, y, zero}, Vector{bend * x, bend * y, zero});
                    for (const double found : {plane, along, space}) {
                        EXPECT_EQ(found, 0);
                        EXPECT_FALSE(std::signbit(found)) << x << ' ' << y << ' ' << bend;
                    }
                }
            }
    EXPECT_FALSE(std::signbit(curvature(Vector{-1e300, 0}, Vector{0, 1e-300}))) << "less than every double";
}

TEST(Curvature, OfACircleIsOneOverItsRadiusToTheLeft) {
    for (const double radius : {0.5, 1.0, 8.0}) {
        for (int i = 0; i < 16; ++i) {
            const double c = std::cos(i);
            const double s = std::sin(i);
            EXPECT_NEAR(curvature(Vector{-radius * s, radius * c}, Vector{-radius * c, -radius * s}), 1 / radius,
                        1e-14 / radius);
            EXPECT_NEAR(curvature(Vector{radius * s, -radius * c}, Vector{-radius * c, -radius * s}), -1 / radius,
                        1e-14 / radius)
                << "the other way round";
        }
    }
}

TEST(Curvature, OfAHelixIsKnown) {
    // (r cos t, r sin t, b t): r / (r² + b²).
    for (int i = 0; i < 8; ++i) {
        const Vector first{-2 * std::sin(i), 2 * std::cos(i), 3};
        const Vector second{-2 * std::cos(i), -2 * std::sin(i), 0};
        EXPECT_NEAR(curvature(first, second), 2.0 / 13, 1e-15);
    }
}

TEST(Curvature, OfAPlaneCurveInSpaceIsItsSize) {
    const Vector first{2, 1};
    const Vector second{-1, -3};
    const double plane = curvature(first, second);
    EXPECT_LT(plane, 0);
    EXPECT_NEAR(curvature(Vector{2, 0, 1, 0, 0}, Vector{-1, 0, -3, 0, 0}), -plane, 1e-15);
}

TEST(Curvature, DoesNotDependOnTheParameter) {
    // t = u(s): c' u', c'' u'² + c' u''.
    const Vector first{1, 2, -1};
    const Vector second{0.5, -1, 3};
    const double u1 = 0.25;
    const double u2 = 7;
    Vector first_s;
    Vector second_s;
    for (std::size_t i = 0; i < 3; ++i) {
        first_s.push_back(first[i] * u1);
        second_s.push_back(second[i] * u1 * u1 + first[i] * u2);
    }
    EXPECT_NEAR(curvature(first_s, second_s), curvature(first, second), 1e-13);
}

TEST(Curvature, NeitherOverflowsNorVanishesOnTheWay) {
    for (const double scale : {1e-150, 1e-100, 1e100, 1e150})
        EXPECT_NEAR(curvature(Vector{scale, 0}, Vector{0, scale * scale}), 1, 1e-15);
    EXPECT_TRUE(std::isinf(curvature(Vector{1e-200, 0}, Vector{0, 1e200})));
}

TEST(Curvature, OfALineIsZero) {
    EXPECT_EQ(curvature(Vector{1, 2}, Vector{0, 0}), 0);
    EXPECT_EQ(curvature(Vector{1, 2, 4}, Vector{2, 4, 8}), 0);
    EXPECT_EQ(curvature(Vector{5}, Vector{3}), 0) << "one dimension has no room to turn";
}

} // namespace
} // namespace internode
