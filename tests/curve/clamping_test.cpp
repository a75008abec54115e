// SPDX-License-Identifier: MIT

#include "internode/curve/clamping.h"

#include "tests/fixtures/random_curve.h"
#include "tests/reference/de_boor.h"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace internode {
namespace {

using reference::DeBoorCurve;
using reference::Real;
using tests::curve_of;
using tests::fibonacci;
using tests::Random;
using tests::random_curve;
using tests::random_system;
using tests::Shape;

/// The largest distance of two curves over one domain, at places inside every interval.
Real difference(const Curve& a, const Curve& b) {
    const DeBoorCurve first = reference::de_boor_curve(a);
    const DeBoorCurve second = reference::de_boor_curve(b);
    Real worst = 0;
    for (int i = 0; i < 100; ++i) {
        const Real part = (static_cast<Real>(i) + Real(0.5L)) / 100;
        const auto left = reference::de_boor(first, first.begin() + part * (first.end() - first.begin()));
        const auto right = reference::de_boor(second, second.begin() + part * (second.end() - second.begin()));
        for (std::size_t c = 0; c < left.size(); ++c) worst = std::max(worst, std::abs(left[c] - right[c]));
    }
    return worst;
}

TEST(Clamping, KeepsTheCurve) {
    Random random(21);
    for (int time = 0; time < 30; ++time)
        for (const Shape shape : {Shape::Open, Shape::OpenWithZeros, Shape::Clamped, Shape::ClampedWithZeros}) {
            const int degree = 1 + static_cast<int>(random.below(7));
            const Curve curve = random_curve(random, random_system(random), degree, shape, 1 + random.below(8), 2);
            const Knots knots = clamped(curve.knots());
            const auto checked = make_curve(knots, 2, clamped_points(curve.knots(), 2, curve.points()));
            ASSERT_TRUE(checked.curve.has_value());
            EXPECT_LE(difference(curve, *checked.curve), Real(1e-12L)) << "degree " << degree;
            const auto d = static_cast<std::size_t>(degree);
            for (std::size_t i = 0; i < d; ++i) {
                EXPECT_EQ(knots.word()[i], zero_interval);
                EXPECT_EQ(knots.word()[knots.word().size() - 1 - i], zero_interval);
            }
        }
}

TEST(Clamping, LeavesClampedCurvesAlone) {
    Random random(5);
    const Curve curve = random_curve(random, fibonacci(), 4, Shape::Clamped, 9, 3);
    EXPECT_EQ(clamped(curve.knots()).word(), curve.word());
    EXPECT_EQ(clamped_points(curve.knots(), 3, curve.points()), curve.points());
}

TEST(Clamping, RefusesClosedCurvesAndOtherSizes) {
    Random random(6);
    const Curve closed = random_curve(random, fibonacci(), 3, Shape::Closed, 9, 2);
    EXPECT_THROW((void)clamped(closed.knots()), std::invalid_argument);
    EXPECT_THROW((void)clamped_points(closed.knots(), 2, closed.points()), std::invalid_argument);
    const Curve open = random_curve(random, fibonacci(), 3, Shape::Open, 9, 2);
    EXPECT_THROW((void)clamped_points(open.knots(), 2, {1, 2}), std::invalid_argument);
    EXPECT_THROW((void)clamped_points(open.knots(), 0, open.points()), std::invalid_argument);
}

} // namespace
} // namespace internode
