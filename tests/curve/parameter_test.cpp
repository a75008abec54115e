// SPDX-License-Identifier: MIT

#include "internode/curve/parameter.h"

#include "internode/curve/refinement.h"
#include "internode/spline/blossom.h"
#include "tests/fixtures/random_curve.h"

#include <cmath>
#include <gmock/gmock.h>

namespace internode {
namespace {

using tests::fibonacci;
using tests::Random;
using tests::random_curve;
using tests::Shape;

/// The exact knots of a curve, 0 where its domain starts; d more letters than points in either case.
std::vector<Number> exact_knots(const Curve& curve) {
    const auto degree = static_cast<std::size_t>(curve.degree());
    const Word word = repeated(curve.word(), curve.size() + degree);
    std::vector<Number> exact = knots(curve.system(), word);
    const Number origin = curve.ends() == Ends::Open ? exact[degree] : Number(0);
    const Number scale = pow(curve.system().ratio(), -curve.step());
    for (Number& knot : exact) knot = (knot - origin) * scale;
    return exact;
}

/// Whether value is one of the two doubles next to the exact number.
testing::AssertionResult is_next_to(double value, const Number& exact) {
    const auto [lower, upper] = exact.enclosure();
    if (std::nextafter(lower, -INFINITY) <= value && value <= std::nextafter(upper, INFINITY))
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << value << " is not next to " << exact.to_double();
}

TEST(KnotPositions, AreExactToAUnitInTheLastPlace) {
    Random random(1);
    for (const Shape shape : tests::all_shapes) {
        const Curve curve = refine(random_curve(random, fibonacci(), 3, shape, 8, 1), 7);
        const std::vector<double> positions = knot_positions(curve);
        const std::vector<Number> exact = exact_knots(curve);
        ASSERT_EQ(positions.size(), curve.size() + (curve.ends() == Ends::Open ? 4 : 1));
        for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_TRUE(is_next_to(positions[i], exact[i])) << i;
    }
}

TEST(KnotPositions, TheDomainStartsAt0) {
    Random random(2);
    EXPECT_EQ(knot_positions(random_curve(random, fibonacci(), 4, Shape::Open, 5, 1))[4], 0);
    EXPECT_EQ(knot_positions(random_curve(random, fibonacci(), 4, Shape::Closed, 5, 1))[0], 0);
}

TEST(GrevilleAbscissae, AreTheMeansOfDegreeKnots) {
    Random random(3);
    for (int degree = 1; degree <= 6; ++degree)
        for (const Shape shape : tests::all_shapes) {
            const Curve curve = refine(random_curve(random, fibonacci(), degree, shape, 4, 1), 3);
            const std::vector<double> abscissae = greville_abscissae(curve);
            const std::vector<Number> exact = exact_knots(curve);
            ASSERT_EQ(abscissae.size(), curve.size());
            for (std::size_t k = 0; k < abscissae.size(); ++k) {
                Number mean;
                for (std::size_t i = 1; i <= static_cast<std::size_t>(degree); ++i) mean += exact[k + i];
                mean /= Number(degree);
                EXPECT_NEAR(abscissae[k], mean.to_double(), 4e-16 * (1 + std::abs(abscissae[k])));
            }
        }
}

TEST(GrevilleAbscissae, AscendOnAClosedCurve) {
    Random random(4);
    const Curve curve = random_curve(random, fibonacci(), 5, Shape::Closed, 3, 1);
    const std::vector<double> abscissae = greville_abscissae(curve);
    EXPECT_TRUE(std::ranges::is_sorted(abscissae));
    EXPECT_GT(abscissae.back(), knot_positions(curve).back());
}

TEST(GrevilleAbscissae, OfAClampedCurveStartAndEndWithTheDomain) {
    Random random(5);
    const Curve curve = refine(random_curve(random, fibonacci(), 4, Shape::Clamped, 6, 1), 2);
    EXPECT_EQ(greville_abscissae(curve).front(), 0);
    EXPECT_EQ(greville_abscissae(curve).back(), knot_positions(curve).back());
}

TEST(IntervalLength, IsDividedByTheRatioAtEveryStep) {
    const CheckedCurve checked = make_curve(fibonacci(), {2, Ends::Circular, {Symbol{0}, Symbol{1}}, 1, {0, 1}});
    ASSERT_TRUE(checked.curve.has_value());
    const Curve fine = refine(*checked.curve, 3);
    const Number& ratio = fine.system().ratio();
    EXPECT_EQ(interval_length(fine, Symbol{0}), pow(ratio, -2).to_double());
    EXPECT_EQ(interval_length(fine, Symbol{1}), pow(ratio, -3).to_double());
    EXPECT_EQ(interval_length(fine, zero_interval), 0);
    EXPECT_EQ(largest_interval(fine), interval_length(fine, Symbol{0}));
}

TEST(LargestInterval, LooksAtTheDomainOnly) {
    const Symbol a{0};
    const Symbol b{1};
    const CheckedCurve checked = make_curve(fibonacci(), {1, Ends::Open, {a, b, a}, 1, {0, 1}});
    ASSERT_TRUE(checked.curve.has_value());
    EXPECT_EQ(largest_interval(*checked.curve), 1);
}

} // namespace
} // namespace internode
