// SPDX-License-Identifier: MIT

#include "internode/curve/distance.h"

#include "internode/curve/refinement.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/stride.h"
#include "tests/fixtures/words.h"
#include "tests/reference/de_boor.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

namespace internode {
namespace {

using namespace tests::letters;
using reference::DeBoorCurve;
using reference::Real;
using tests::all_shapes;
using tests::curve_of;
using tests::fibonacci;
using tests::Random;
using tests::random_curve;
using tests::random_system;
using tests::Shape;
using tests::system_with;

std::vector<Real> abscissae(const DeBoorCurve& curve) {
    std::vector<Real> result;
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
        Real sum = 0;
        for (std::size_t i = 1; i <= curve.degree; ++i) sum += curve.knots[k + i];
        result.push_back(sum / static_cast<Real>(curve.degree));
    }
    return result;
}

/// ‖s(x) - ℓ(x)‖ for x in interval j and between the abscissae of points i and i + 1.
Real distance_at(const DeBoorCurve& curve, const std::vector<Real>& xi, std::size_t j, std::size_t i, Real x) {
    const std::vector<Real> point = reference::de_boor_piece(curve, j, x);
    const Real part = (x - xi[i]) / (xi[i + 1] - xi[i]);
    Real sum = 0;
    for (std::size_t c = 0; c < point.size(); ++c) {
        const Real off = point[c] - (1 - part) * curve.points[i][c] - part * curve.points[i + 1][c];
        sum += off * off;
    }
    return std::sqrt(sum);
}

/// The largest distance at `samples` + 1 places of every piece between knots and abscissae.
Real sampled_distance(const DeBoorCurve& curve, int samples) {
    const std::vector<Real> xi = abscissae(curve);
    Real worst = 0;
    for (std::size_t j = curve.degree; j < curve.points.size(); ++j)
        for (std::size_t i = j - curve.degree; i < j; ++i) {
            const Real begin = std::max(curve.knots[j], xi[i]);
            const Real end = std::min(curve.knots[j + 1], xi[i + 1]);
            if (end - begin < 1e-15L) continue;
            for (int k = 0; k <= samples; ++k)
                worst = std::max(worst, distance_at(curve, xi, j, i, begin + (end - begin) * k / samples));
        }
    return worst;
}

TEST(PolygonDistance, IsZeroForDegree1) {
    Random random(1);
    const PolygonDistance distance = polygon_distance(random_curve(random, fibonacci(), 1, Shape::Closed, 6, 2));
    EXPECT_EQ(distance.error, 0);
    EXPECT_EQ(distance.error_bound, 0);
    EXPECT_EQ(distance.envelope, 0);
}

TEST(PolygonDistance, IsTheSupremumOfDenseSamples) {
    Random random(2);
    for (int degree = 2; degree <= 6; ++degree)
        for (const Shape shape : all_shapes) {
            const Curve curve = random_curve(random, random_system(random), degree, shape, 3, 1 + random.below(3));
            const PolygonDistance distance = polygon_distance(curve);
            const auto sampled = static_cast<double>(sampled_distance(reference::de_boor_curve(curve), 40));
            EXPECT_LE(sampled, distance.error_bound * (1 + 1e-12) + 1e-15);
            EXPECT_GE(sampled, 0.98 * distance.error);
            EXPECT_LE(distance.error, distance.error_bound);
            EXPECT_LE(distance.error_bound, distance.error * (1 + 1e-6) + 1e-15);
        }
}

TEST(PolygonDistance, NeverLeavesTheEnvelope) {
    Random random(3);
    const int times = tests::times(1000, 20);
    double tightest = INFINITY;
    for (int time = 0; time < times; ++time) {
        const int degree = 2 + static_cast<int>(random.below(5));
        const Shape shape = all_shapes[random.below(std::size(all_shapes))];
        const IntervalSystem system = random_system(random);
        const Curve curve = random_curve(random, system, degree, shape, 1 + random.below(12), 1 + random.below(3));
        const Curve measured = time % 8 == 0 ? refine(curve, 1) : curve;
        const PolygonDistance distance = polygon_distance(measured);
        ASSERT_LE(distance.error_bound, distance.envelope);
        const auto sampled = static_cast<double>(sampled_distance(reference::de_boor_curve(measured), 4));
        ASSERT_LE(sampled, distance.envelope * (1 + 1e-12) + 1e-15);
        if (distance.error > 0) tightest = std::min(tightest, distance.envelope / distance.error);
    }
    EXPECT_LT(tightest, 1 + 1e-6) << "where all slope jumps are parallel the envelope is the error";
}

/// The curve over the same knots whose polygon is convex, with slope jumps as large as those of `curve`.
Curve convex_curve(const Curve& curve) {
    const DeBoorCurve slow = reference::de_boor_curve(curve);
    const std::vector<Real> xi = abscissae(slow);
    const auto slope = [&](std::size_t i, std::size_t c) {
        return (slow.points[i + 1][c] - slow.points[i][c]) / (xi[i + 1] - xi[i]);
    };
    CurveData data{curve.degree(), Ends::Open, curve.word(), 1, {0}};
    Real value = 0;
    Real rise = 0;
    for (std::size_t i = 0; i + 1 < xi.size(); ++i) {
        Real jump = 0;
        for (std::size_t c = 0; i > 0 && c < curve.dimension(); ++c)
            jump += (slope(i, c) - slope(i - 1, c)) * (slope(i, c) - slope(i - 1, c));
        rise += std::sqrt(jump);
        value += rise * (xi[i + 1] - xi[i]);
        data.points.push_back(static_cast<double>(value));
    }
    return curve_of(curve.system(), data);
}

TEST(PolygonDistance, TheEnvelopeIsTheDistanceOfTheConvexCurveWithTheSameJumps) {
    Random random(9);
    for (int degree = 2; degree <= 6; ++degree)
        for (const Shape shape : {Shape::Open, Shape::Clamped}) {
            const Curve curve = random_curve(random, fibonacci(), degree, shape, 5, 3);
            const double envelope = polygon_distance(curve).envelope;
            const DeBoorCurve convex = reference::de_boor_curve(convex_curve(curve));
            const auto sampled = static_cast<double>(sampled_distance(convex, 40));
            EXPECT_LE(sampled, envelope * (1 + 1e-9)) << "degree " << degree;
            EXPECT_GE(sampled, 0.98 * envelope) << "degree " << degree;
        }
}

TEST(PolygonDistance, OfAUniformParabolaIsSharp) {
    // Control points k² have the second difference 2: the distance is (d + 1) / 24 times that.
    const IntervalSystem uniform = system_with({"AA"});
    for (int degree = 2; degree <= 12; ++degree) {
        const auto points = static_cast<std::size_t>(3 * degree);
        CurveData data{degree, Ends::Open, Word(points + static_cast<std::size_t>(degree), a), 1, {}};
        for (std::size_t k = 0; k < points; ++k) data.points.push_back(static_cast<double>(k * k));
        const PolygonDistance distance = polygon_distance(curve_of(uniform, data));
        EXPECT_NEAR(distance.error, (degree + 1) / 12.0, 1e-12);
        EXPECT_NEAR(distance.envelope, (degree + 1) / 12.0, 1e-8);
    }
}

TEST(PolygonDistance, OfABezierCurveStaysWithinTheKnownBound) {
    // ⌊d/2⌋⌈d/2⌉ / (2d) max ‖Δ²b‖, attained by the polygon with one corner in the middle or by a parabola.
    const IntervalSystem uniform = system_with({"AA"});
    Random random(4);
    for (int degree = 2; degree <= 8; ++degree) {
        const auto d = static_cast<std::size_t>(degree);
        CurveData data{degree, Ends::Open, clamped(Word{a}, degree), 1, {}};
        for (std::size_t k = 0; k <= d; ++k) data.points.push_back(random.coordinate());
        double second = 0;
        for (std::size_t k = 1; k < d; ++k)
            second = std::max(second, std::abs(data.points[k - 1] - 2 * data.points[k] + data.points[k + 1]));
        const double factor = (degree / 2) * ((degree + 1) / 2) / (2.0 * degree);
        EXPECT_LE(polygon_distance(curve_of(uniform, data)).error, factor * second * (1 + 1e-12));
    }
}

TEST(PolygonDistance, VanishesForStraightPolygons) {
    for (int degree = 2; degree <= 6; ++degree) {
        CurveData data{degree, Ends::Circular, Word(5, b), 2, std::vector<double>(10, 0.75)};
        const PolygonDistance constant = polygon_distance(curve_of(fibonacci(), data));
        EXPECT_EQ(constant.error, 0);
        EXPECT_EQ(constant.envelope, 0);
    }
}

TEST(PolygonDistance, MeasuresBothSidesOfABreakApart) {
    const Word left{b, a};
    const Word right{a, a, b};
    const std::vector<double> left_points{0, 3, 1, 2};
    const std::vector<double> right_points{50, 53, 58, 51, 52};
    Word word = left;
    word.insert(word.end(), 2, o);
    word.insert(word.end(), right.begin(), right.end());
    std::vector<double> points = left_points;
    points.insert(points.end(), right_points.begin(), right_points.end());
    const auto distance = [](const Word& domain, const std::vector<double>& values) {
        return polygon_distance(curve_of(fibonacci(), {2, Ends::Open, clamped(domain, 2), 1, values}));
    };
    const PolygonDistance both = distance(word, points);
    EXPECT_NEAR(both.error, std::max(distance(left, left_points).error, distance(right, right_points).error), 1e-13);
    EXPECT_NEAR(both.envelope, std::max(distance(left, left_points).envelope, distance(right, right_points).envelope),
                1e-8);
}

TEST(PolygonDistance, FindsTheErrorBelowALargerEnvelope) {
    // Slope jumps of a zigzag cancel in the error, not in the envelope; those of a parabola in neither. The zigzag
    // swells and fades: where it ended at once, its last jump would stand alone.
    const int degree = 12;
    std::vector<double> jumps(80);
    for (std::size_t i = 0; i < 40; ++i) {
        const auto from_end = static_cast<double>(std::min(i, 39 - i));
        jumps[i] = (i % 2 == 0 ? 4 : -4) * std::min(1.0, from_end / 12);
    }
    std::fill(jumps.begin() + 60, jumps.begin() + 70, 2.25);
    CurveData data{degree, Ends::Open, Word(jumps.size() + degree, a), 1, {0, 0}};
    for (std::size_t i = 1; i + 1 < jumps.size(); ++i)
        data.points.push_back(jumps[i] + 2 * data.points[i] - data.points[i - 1]);
    const PolygonDistance distance = polygon_distance(curve_of(system_with({"AA"}), data));
    EXPECT_NEAR(distance.error, 2.25 * (degree + 1) / 24, 1e-9);
    EXPECT_NEAR(distance.envelope, 4.0 * (degree + 1) / 24, 1e-8);
}

TEST(PolygonDistance, ScalesWithPowersOfTwoBitForBit) {
    Random random(5);
    const Curve curve = random_curve(random, fibonacci(), 3, Shape::Closed, 9, 2);
    const PolygonDistance distance = polygon_distance(curve);
    for (const double scale : {0x1p-900, 0x1p3, 0x1p1000}) {
        std::vector<double> points = curve.points();
        for (double& point : points) point *= scale;
        const PolygonDistance scaled =
            polygon_distance(curve_of(curve.system(), {3, Ends::Circular, curve.word(), 2, points}));
        EXPECT_EQ(scaled.error, distance.error * scale);
        EXPECT_EQ(scaled.envelope, distance.envelope * scale);
    }
}

TEST(PolygonDistance, IsFiniteForTheLargestCoordinates) {
    constexpr double most = std::numeric_limits<double>::max();
    const PolygonDistance distance =
        polygon_distance(curve_of(fibonacci(), {2, Ends::Circular, {a, b, a, b}, 1, {most, -most, most, -most}}));
    EXPECT_TRUE(std::isfinite(distance.error));
    EXPECT_GT(distance.error, 0.1 * most);
}

TEST(PolygonDistance, HoldsForTheHighestDegree) {
    Random random(6);
    for (const Shape shape : all_shapes) {
        const Curve curve = random_curve(random, fibonacci(), 12, shape, 5, 2);
        const PolygonDistance distance = polygon_distance(curve);
        EXPECT_GT(distance.error, 0);
        EXPECT_LE(distance.error, distance.error_bound);
        EXPECT_LE(distance.error_bound, distance.error * (1 + 1e-6));
        EXPECT_LE(distance.error_bound, distance.envelope);
    }
}

} // namespace
} // namespace internode
