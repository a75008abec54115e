// SPDX-License-Identifier: MIT

#include "internode/curve/limit.h"

#include "internode/curve/parameter.h"
#include "tests/curve/frames.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/words.h"
#include "tests/reference/de_boor.h"

#include <bit>
#include <gmock/gmock.h>

namespace internode {
namespace {

using namespace tests::letters;
using reference::DeBoorCurve;
using ::testing::ElementsAre;
using tests::all_shapes;
using tests::fibonacci;
using tests::Random;
using tests::random_curve;
using tests::refined;
using tests::Shape;

Refinement of(CurveData data) {
    return Refinement(tests::curve_of(fibonacci(), std::move(data)));
}

void expect_point(const std::vector<double>& points, std::size_t row, const std::vector<reference::Real>& expected) {
    for (std::size_t c = 0; c < expected.size(); ++c)
        EXPECT_NEAR(points[row * expected.size() + c], static_cast<double>(expected[c]), 1e-13) << "row " << row;
}

TEST(LimitPoints, LieOnTheCurveAtTheKnots) {
    Random random(1);
    for (int degree = 1; degree <= 6; ++degree)
        for (const Shape shape : all_shapes) {
            const Refinement refinement = refined(random_curve(random, fibonacci(), degree, shape, 4, 2), 2);
            const LimitPoints limit = limit_points(refinement);
            const DeBoorCurve curve = reference::de_boor_curve(refinement.curve());
            // Walk through the non-empty intervals of the reference; each begins at a row and ends at another.
            std::size_t row = 0;
            std::size_t last = 0;
            for (std::size_t j = curve.degree; j < curve.points.size(); ++j) {
                if (curve.knots[j] == curve.knots[j + 1]) continue;
                const bool breaks = last != 0 && j - last == curve.degree + 1;
                if (breaks)
                    expect_point(limit.points, row++, reference::de_boor_piece(curve, last, curve.knots[last + 1]));
                ASSERT_LT(row, limit.parameters.size());
                if (last != 0) {
                    EXPECT_EQ(limit.break_before[row], breaks);
                }
                EXPECT_NEAR(limit.parameters[row], static_cast<double>(curve.knots[j]), 1e-13);
                expect_point(limit.points, row++, reference::de_boor_piece(curve, j, curve.knots[j]));
                last = j;
            }
            if (row < limit.parameters.size())
                expect_point(limit.points, row++, reference::de_boor_piece(curve, last, curve.knots[last + 1]));
            EXPECT_EQ(row, limit.parameters.size());
        }
}

TEST(LimitPoints, AppearOnceAtAMultipleKnot) {
    const LimitPoints limit = limit_points(of({2, Ends::Open, {a, a, b, o, b, a, a}, 1, {0, 1, 4, 2, 7}}));
    EXPECT_THAT(limit.parameters, ElementsAre(0, 1, 2));
    EXPECT_THAT(limit.break_before, ElementsAre(false, false, false));
    EXPECT_EQ(limit.points[1], 4);
}

TEST(LimitPoints, AppearTwiceAtABreak) {
    const LimitPoints limit = limit_points(of({2, Ends::Open, clamped(Word{b, o, o, b}, 2), 1, {0, 1, 2, 5, 6, 7}}));
    EXPECT_THAT(limit.parameters, ElementsAre(0, 1, 1, 2));
    EXPECT_THAT(limit.points, ElementsAre(0, 2, 5, 7));
    EXPECT_THAT(limit.break_before, ElementsAre(false, false, true, false));
}

TEST(LimitPoints, OfAClosedCurveThatBreaksAtItsSeamEndAtThePeriod) {
    for (const Word& word : {Word{o, o, b, b}, Word{b, b, o, o}, Word{o, b, b, o}}) {
        const LimitPoints limit = limit_points(of({2, Ends::Circular, word, 1, {0, 1, 2, 3}}));
        EXPECT_THAT(limit.parameters, ElementsAre(0, 1, 2));
        EXPECT_THAT(limit.break_before, ElementsAre(true, false, false));
    }
}

TEST(LimitPoints, OfAClosedCurveDoNotRepeatTheFirst) {
    const LimitPoints limit = limit_points(of({3, Ends::Circular, {b, b, b}, 1, {0, 1, 2}}));
    EXPECT_THAT(limit.parameters, ElementsAre(0, 1, 2));
}

TEST(LimitPoints, OfAClampedCurveStartAndEndWithItsPolygonBitForBit) {
    Random random(2);
    const Refinement refinement = refined(random_curve(random, fibonacci(), 3, Shape::Clamped, 5, 1), 3);
    const LimitPoints limit = limit_points(refinement);
    EXPECT_EQ(limit.points.front(), refinement.curve().points().front());
    EXPECT_EQ(limit.points.back(), refinement.curve().points().back());
}

TEST(LimitPoints, OfDegree1AreThePolygon) {
    const LimitPoints limit = limit_points(of({1, Ends::Circular, {a, b, a}, 1, {3, 1, 2}}));
    // Point k stands at knot k + 1.
    EXPECT_THAT(limit.points, ElementsAre(2, 3, 1));
}

TEST(LimitPoints, DoNotMoveUnderRefinement) {
    Random random(3);
    for (const Shape shape : {Shape::Open, Shape::Closed, Shape::ClampedWithZeros}) {
        const Curve curve = random_curve(random, fibonacci(), 4, shape, 5, 1);
        const LimitPoints coarse = limit_points(Refinement(curve));
        const LimitPoints fine = limit_points(refined(curve, 2));
        for (std::size_t i = 0, row = 0; i < coarse.parameters.size(); ++i) {
            while (row < fine.parameters.size() && fine.parameters[row] < coarse.parameters[i] - 1e-12) ++row;
            ASSERT_LT(row, fine.parameters.size());
            EXPECT_NEAR(fine.parameters[row], coarse.parameters[i], 1e-12);
            EXPECT_NEAR(fine.points[row], coarse.points[i], 1e-13);
            if (i + 1 < coarse.parameters.size() && coarse.break_before[i + 1]) ++row;
        }
    }
}

std::vector<reference::Real> bezier_point(const BezierSegments& segments, std::size_t segment, std::size_t degree,
                                          std::size_t dimension, reference::Real t) {
    std::vector<reference::Real> values;
    for (std::size_t b_row = 0; b_row <= degree; ++b_row)
        for (std::size_t c = 0; c < dimension; ++c)
            values.push_back(segments.points[(segment * (degree + 1) + b_row) * dimension + c]);
    for (std::size_t level = degree; level > 0; --level)
        for (std::size_t i = 0; i < level * dimension; ++i) values[i] = (1 - t) * values[i] + t * values[i + dimension];
    values.resize(dimension);
    return values;
}

TEST(BezierSegments, AreTheCurveOverEachInterval) {
    Random random(4);
    for (int degree = 1; degree <= 6; ++degree)
        for (const Shape shape : all_shapes) {
            const Refinement refinement = refined(random_curve(random, fibonacci(), degree, shape, 4, 2), 1);
            const BezierSegments segments = bezier_segments(refinement);
            const DeBoorCurve curve = reference::de_boor_curve(refinement.curve());
            std::size_t segment = 0;
            for (std::size_t j = curve.degree; j < curve.points.size(); ++j) {
                const reference::Real length = curve.knots[j + 1] - curve.knots[j];
                if (length == 0) continue;
                ASSERT_LT(segment, segments.symbols.size());
                for (const reference::Real t : {0.0L, 0.3L, 1.0L}) {
                    const auto expected = reference::de_boor_piece(curve, j, curve.knots[j] + t * length);
                    const auto found = bezier_point(segments, segment, curve.degree, 2, t);
                    for (std::size_t c = 0; c < 2; ++c)
                        EXPECT_NEAR(static_cast<double>(found[c]), static_cast<double>(expected[c]), 1e-13);
                }
                ++segment;
            }
            EXPECT_EQ(segment, segments.symbols.size());
        }
}

TEST(BezierSegments, JoinWhereTheCurveDoesNotBreak) {
    Random random(5);
    for (int degree = 1; degree <= 6; ++degree) {
        const Refinement refinement = refined(random_curve(random, fibonacci(), degree, Shape::Closed, 3, 1), 2);
        const BezierSegments segments = bezier_segments(refinement);
        const std::size_t width = static_cast<std::size_t>(degree) + 1;
        const std::size_t count = segments.symbols.size();
        ASSERT_EQ(segments.points.size(), count * width);
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_NEAR(segments.points[i * width + width - 1], segments.points[(i + 1) % count * width], 1e-14);
    }
}

TEST(BezierSegments, CarryTheirSymbols) {
    const BezierSegments segments =
        bezier_segments(of({2, Ends::Open, clamped(Word{b, o, a, o, o, b}, 2), 1, {0, 1, 2, 3, 4, 5, 6, 7}}));
    EXPECT_THAT(segments.symbols, ElementsAre(b, a, b));
}

} // namespace
} // namespace internode
