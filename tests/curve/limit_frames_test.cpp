// SPDX-License-Identifier: MIT

#include "internode/curve/frame.h"
#include "internode/curve/limit.h"
#include "tests/curve/frames.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/words.h"
#include "tests/reference/de_boor.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace internode {
namespace {

using namespace tests::letters;
using reference::DeBoorCurve;
using tests::all_shapes;
using tests::fibonacci;
using tests::frames_of;
using tests::Random;
using tests::random_curve;
using tests::refined;
using tests::Shape;

/// Value and two derivatives of a curve at the ends of its pieces, by de Boor.
class Slow {
public:
    explicit Slow(const DeBoorCurve& curve)
        : curves_{curve, reference::derivative(curve)} {
        if (curve.degree > 1) curves_.push_back(reference::derivative(curves_[1]));
    }
    /// The derivative of that order of piece j at x; x stays within the piece.
    [[nodiscard]] std::vector<reference::Real> at(std::size_t order, std::size_t j, reference::Real x) const {
        if (order < curves_.size()) return reference::de_boor_piece(curves_[order], j - order, x);
        return std::vector<reference::Real>(curves_[0].points.front().size());
    }

private:
    std::vector<DeBoorCurve> curves_;
};

/// A row against the reference; the tolerance grows like the rows of the derivative.
void expect_row(const std::vector<double>& rows, std::size_t row, const std::vector<reference::Real>& expected,
                double scale) {
    for (std::size_t c = 0; c < expected.size(); ++c)
        EXPECT_NEAR(rows[row * expected.size() + c], static_cast<double>(expected[c]), 1e-14 * scale) << "row " << row;
}

void expect_frame(const LimitFrames& frames, std::size_t row, const Slow& slow, std::size_t j, reference::Real x,
                  double shortest) {
    expect_row(frames.limit.points, row, slow.at(0, j, x), 10);
    expect_row(frames.first, row, slow.at(1, j, x), 100 / shortest);
    expect_row(frames.second, row, slow.at(2, j, x), 1000 / (shortest * shortest));
}

/// Every row of the frames, walking through the non-empty intervals of the reference.
void expect_derivatives_of_de_boor(const Curve& given, int steps) {
    const Refinement refinement = refined(given, steps);
    const LimitFrames frames = limit_frames(given, refinement);
    const DeBoorCurve curve = reference::de_boor_curve(refinement.curve());
    const Slow slow(curve);
    reference::Real shortest = 1e9L;
    for (std::size_t j = 0; j + 1 < curve.knots.size(); ++j)
        if (curve.knots[j] < curve.knots[j + 1]) shortest = std::min(shortest, curve.knots[j + 1] - curve.knots[j]);
    const auto unit = static_cast<double>(shortest);
    std::size_t row = 0;
    std::size_t last = 0;
    const std::size_t rows = frames.limit.parameters.size();
    for (std::size_t j = curve.degree; j < curve.points.size(); ++j) {
        if (curve.knots[j] == curve.knots[j + 1]) continue;
        if (last != 0 && j - last == curve.degree + 1)
            expect_frame(frames, row++, slow, last, curve.knots[last + 1], unit);
        ASSERT_LT(row, rows);
        expect_frame(frames, row++, slow, j, curve.knots[j], unit);
        last = j;
    }
    if (row < rows) expect_frame(frames, row++, slow, last, curve.knots[last + 1], unit);
    EXPECT_EQ(row, rows);
    EXPECT_EQ(frames.first.size(), frames.limit.points.size());
    EXPECT_EQ(frames.second.size(), frames.limit.points.size());
    EXPECT_EQ(frames.curvatures.size(), rows);
}

TEST(LimitFrames, AreTheDerivativesOfDeBoor) {
    Random random(11);
    for (int degree = 1; degree <= 6; ++degree)
        for (const Shape shape : all_shapes)
            for (const std::size_t dimension : {1U, 2U, 3U})
                expect_derivatives_of_de_boor(random_curve(random, fibonacci(), degree, shape, 4, dimension), 2);
}

TEST(LimitFrames, AreTheDerivativesOfDeBoorForRandomGrammars) {
    Random random(12);
    for (int i = 0; i < 60; ++i) {
        const IntervalSystem system = tests::random_system(random);
        const auto degree = static_cast<int>(1 + random.below(6));
        const Shape shape = all_shapes[random.below(6)];
        SCOPED_TRACE(i);
        const Curve curve = random_curve(random, system, degree, shape, 3, 2);
        expect_derivatives_of_de_boor(curve, static_cast<int>(random.below(3)));
    }
}

TEST(LimitFrames, HaveThePointsOfLimitPoints) {
    Random random(13);
    for (const Shape shape : all_shapes) {
        const Curve curve = random_curve(random, fibonacci(), 3, shape, 4, 2);
        const Refinement refinement = refined(curve, 2);
        const LimitPoints points = limit_points(refinement);
        const LimitFrames frames = limit_frames(curve, refinement);
        EXPECT_EQ(frames.limit.parameters, points.parameters);
        EXPECT_EQ(frames.limit.points, points.points);
        EXPECT_EQ(frames.limit.break_before, points.break_before);
    }
}

TEST(LimitFrames, OfAParabolaAreKnownAtEveryStep) {
    // Degree 2 over knots t: the control points of (t, t²) are the blossoms (mean, product) of two knots.
    const Word word = clamped(Word{a, b, a, a, b}, 2);
    CurveData data{2, Ends::Open, word, 2, {}};
    std::vector<Number> knots(3);
    const IntervalSystem system = fibonacci();
    for (std::size_t i = 2; i < word.size(); ++i) knots.push_back(knots.back() + system.length(word[i]));
    for (std::size_t k = 0; k + 2 < word.size(); ++k) {
        data.points.push_back(((knots[k + 1] + knots[k + 2]) / 2).to_double());
        data.points.push_back((knots[k + 1] * knots[k + 2]).to_double());
    }
    const Curve parabola = tests::curve_of(system, data);
    for (int steps = 0; steps <= 5; ++steps) {
        const LimitFrames frames = frames_of(parabola, steps);
        for (std::size_t i = 0; i < frames.limit.parameters.size(); ++i) {
            const double t = frames.limit.parameters[i];
            const double speed = std::sqrt(1 + 4 * t * t);
            EXPECT_NEAR(frames.limit.points[2 * i], t, 1e-12);
            EXPECT_NEAR(frames.limit.points[2 * i + 1], t * t, 1e-12);
            EXPECT_NEAR(frames.first[2 * i], 1, 1e-12);
            EXPECT_NEAR(frames.first[2 * i + 1], 2 * t, 1e-11);
            EXPECT_NEAR(frames.second[2 * i], 0, 1e-10);
            EXPECT_NEAR(frames.second[2 * i + 1], 2, 1e-10);
            EXPECT_NEAR(frames.tangents[2 * i], 1 / speed, 1e-12);
            EXPECT_NEAR(frames.tangents[2 * i + 1], 2 * t / speed, 1e-12);
            EXPECT_NEAR(frames.curvatures[i], 2 / (speed * speed * speed), 1e-10);
        }
    }
}

TEST(LimitFrames, OfAFineRoundPolygonHaveTheCurvatureOfTheCircle) {
    // A cubic over n points of a regular polygon is round up to 1/n^2.
    constexpr std::size_t n = 400;
    constexpr double radius = 2;
    CurveData data{3, Ends::Circular, Word(n, b), 2, {}};
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * 3.14159265358979323846 * static_cast<double>(i) / n;
        data.points.push_back(radius * std::cos(angle));
        data.points.push_back(radius * std::sin(angle));
    }
    const IntervalSystem uniform = tests::system_with({"AA", "BB"});
    for (const double curvature : frames_of(tests::curve_of(uniform, data), 0).curvatures)
        EXPECT_NEAR(curvature, 1 / radius, 1e-4);
}

TEST(LimitFrames, OfDegree1HaveNoSecondDerivative) {
    const LimitFrames frames =
        frames_of(tests::curve_of(fibonacci(), {1, Ends::Circular, {a, b, a}, 2, {0, 0, 3, 4, 1, 7}}), 1);
    EXPECT_THAT(frames.second, testing::Each(0.0));
    EXPECT_THAT(frames.curvatures, testing::Each(0.0));
}

TEST(LimitFrames, DoNotChangeUnderRefinement) {
    Random random(14);
    for (const Shape shape : {Shape::Open, Shape::Closed, Shape::ClampedWithZeros}) {
        const Curve curve = random_curve(random, fibonacci(), 4, shape, 5, 2);
        const LimitFrames coarse = frames_of(curve, 0);
        const LimitFrames fine = frames_of(curve, 3);
        for (std::size_t i = 0, row = 0; i < coarse.limit.parameters.size(); ++i) {
            while (fine.limit.parameters[row] < coarse.limit.parameters[i] - 1e-12) ++row;
            ASSERT_LT(row, fine.limit.parameters.size());
            for (std::size_t c = 0; c < 2; ++c) {
                EXPECT_NEAR(fine.first[2 * row + c], coarse.first[2 * i + c], 1e-10);
                EXPECT_NEAR(fine.second[2 * row + c], coarse.second[2 * i + c], 1e-8);
            }
            EXPECT_NEAR(fine.curvatures[row], coarse.curvatures[i], 1e-8 * (1 + std::abs(coarse.curvatures[i])));
            if (i + 1 < coarse.limit.parameters.size() && coarse.limit.break_before[i + 1]) ++row;
        }
    }
}

TEST(LimitFrames, HaveNoTangentWhereTheCurveStops) {
    // The first two points of a clamped cubic coincide: its derivative is 0 there.
    const Word word = clamped(Word{b, a}, 3);
    const LimitFrames frames =
        frames_of(tests::curve_of(fibonacci(), {3, Ends::Open, word, 2, {1, 1, 1, 1, 2, 3, 4, 0, 5, 5}}), 0);
    EXPECT_EQ(frames.first[0], 0);
    EXPECT_TRUE(std::isnan(frames.tangents[0]));
    EXPECT_TRUE(std::isnan(frames.curvatures[0]));
    EXPECT_FALSE(std::isnan(frames.curvatures[1]));
}

TEST(LimitFrames, AreOneSidedAtABreakAndAtACorner) {
    // Degree 1: left and right of the break differ; at a corner the value from the right counts.
    const LimitFrames frames =
        frames_of(tests::curve_of(fibonacci(), {1, Ends::Open, {o, b, o, b, b, o}, 1, {0, 1, 5, 7, 6}}), 0);
    EXPECT_THAT(frames.first, testing::ElementsAre(1, 1, 2, -1, -1));
}

} // namespace
} // namespace internode
