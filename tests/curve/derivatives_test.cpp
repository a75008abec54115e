// SPDX-License-Identifier: MIT

#include "internode/curve/limit.h"
#include "tests/curve/frames.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/random_curve.h"
#include "tests/reference/de_boor.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace internode {
namespace {

using reference::ExactCurve;
using tests::all_shapes;
using tests::curve_of;
using tests::fibonacci;
using tests::frames_of;
using tests::Random;
using tests::random_curve;
using tests::Shape;
using tests::system_of;
using tests::word_of;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The distance from |x| to the next larger double.
double ulp(double x) {
    return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
}

double largest_coordinate(const ExactCurve& curve) {
    double largest = 0;
    for (const std::vector<Number>& point : curve.points)
        for (const Number& x : point) largest = std::max(largest, std::abs(x.to_double()));
    return largest;
}

/// The derivatives of a curve in exact numbers, at the knots of the refined one.
class ExactDerivatives {
public:
    ExactDerivatives(const Curve& given, const Curve& fine)
        : fine_(reference::exact_curve(fine))
        , curves_{reference::exact_curve(given)} {
        for (int order = 1; order <= std::min(2, given.degree()); ++order)
            curves_.push_back(reference::derivative(curves_.back()));
    }

    /// 8 units in the last place of the largest difference of the given points.
    [[nodiscard]] double tolerance(std::size_t order) const {
        return order < curves_.size() ? 8 * ulp(largest_coordinate(curves_[order])) : 0;
    }
    [[nodiscard]] std::vector<Number> at(std::size_t order, const Number& x, bool from_left) const {
        if (order >= curves_.size()) return std::vector<Number>(curves_[0].points[0].size());
        const std::size_t j = piece(x, from_left);
        return reference::de_boor_piece(curves_[order], j - order, x);
    }
    /// visit(knot, from_left) in the order of LimitFrames: breaks twice, and the end of what is open.
    template<typename Visit>
    void for_each_knot(bool open, Visit visit) const {
        const std::size_t d = fine_.degree;
        std::size_t last = 0;
        std::size_t first = 0;
        for (std::size_t j = d; j < fine_.points.size(); ++j) {
            if (fine_.knots[j] == fine_.knots[j + 1]) continue;
            if (last != 0 && j - last == d + 1) visit(fine_.knots[j], true);
            visit(fine_.knots[j], false);
            if (first == 0) first = j;
            last = j;
        }
        const bool seam_breaks = !open && first + fine_.points.size() - d - last == d + 1;
        if (open || seam_breaks) visit(fine_.knots[last + 1], true);
    }

private:
    [[nodiscard]] std::size_t piece(const Number& x, bool from_left) const {
        const ExactCurve& given = curves_[0];
        for (std::size_t j = given.degree; j < given.points.size(); ++j) {
            if (given.knots[j] == given.knots[j + 1]) continue;
            if (from_left ? given.knots[j] < x && x <= given.knots[j + 1]
                          : given.knots[j] <= x && x < given.knots[j + 1])
                return j;
        }
        throw std::logic_error("no piece of the curve is there");
    }

    ExactCurve fine_;
    std::vector<ExactCurve> curves_;
};

/// Compares every derivative with the exact one; how many there were.
std::size_t expect_exact_derivatives(const Curve& curve, int steps) {
    Refinement refinement(curve);
    refinement.advance(steps);
    const LimitFrames frames = limit_frames(curve, refinement);
    const ExactDerivatives exact(curve, refinement.curve());
    const std::size_t dimension = curve.dimension();
    std::size_t row = 0;
    exact.for_each_knot(curve.ends() == Ends::Open, [&](const Number& x, bool from_left) {
        for (const std::size_t order : {1U, 2U}) {
            const std::vector<double>& values = order == 1 ? frames.first : frames.second;
            ASSERT_LT(row * dimension, values.size());
            const std::vector<Number> expected = exact.at(order, x, from_left);
            for (std::size_t c = 0; c < dimension; ++c) {
                const double value = values[row * dimension + c];
                EXPECT_LE(std::abs((expected[c] - Number(Rational(value))).to_double()), exact.tolerance(order))
                    << "order " << order << ", row " << row << ", " << value << " for " << expected[c].to_double();
            }
        }
        ++row;
    });
    EXPECT_EQ(row * dimension, frames.first.size());
    return row;
}

Curve far_away(const Curve& curve) {
    std::vector<double> points;
    for (const double x : curve.points()) points.push_back(5e6 + x);
    return make_curve(curve.knots(), curve.dimension(), points).curve.value();
}

TEST(Derivatives, AreWithinEightUnitsOfExactOnesForAllShapes) {
    Random random(21);
    std::size_t compared = 0;
    for (int degree = 1; degree <= 5; ++degree)
        for (const Shape shape : all_shapes) {
            SCOPED_TRACE(degree);
            const Curve curve = far_away(random_curve(random, fibonacci(), degree, shape, 3, 2));
            compared += expect_exact_derivatives(curve, static_cast<int>(random.below(4)));
        }
    EXPECT_GT(compared, 150U);
}

TEST(Derivatives, AreWithinEightUnitsOfExactOnesForRandomGrammars) {
    Random random(22);
    std::size_t compared = 0;
    for (int i = 0; i < 30; ++i) {
        SCOPED_TRACE(i);
        const IntervalSystem system = tests::random_system(random);
        const Curve curve =
            random_curve(random, system, static_cast<int>(1 + random.below(4)), all_shapes[random.below(6)], 3, 1);
        compared += expect_exact_derivatives(far_away(curve), static_cast<int>(random.below(3)));
    }
    EXPECT_GT(compared, 100U);
}

/// Projected metres: differences far smaller than the coordinates.
Curve straight_line() {
    const std::vector<double> x{1310003.1, 1310002.6, 1310001.9, 1310000.8, 1310000.2, 1309999.9};
    CurveData data{3, Ends::Open, {}, 2, {}};
    for (const double each : x) data.points.insert(data.points.end(), {each, 6123456.7});
    const IntervalSystem system = system_of("A->AA");
    data.word = word_of(system, "000AAA000");
    return curve_of(system, data);
}

TEST(Derivatives, FarFromTheOriginKeepTheirDigitsAtEveryDepth) {
    for (const int steps : {1, 4, 8, 12, 14}) {
        const LimitFrames frames = frames_of(straight_line(), steps);
        // x″(1.5) from the differences of the points; 1 when taken of refined points after 16 steps.
        const std::size_t middle = frames.limit.parameters.size() / 2;
        ASSERT_EQ(frames.limit.parameters[middle], 1.5);
        EXPECT_NEAR(frames.second[2 * middle], 0.075, 1e-8) << "the points have 2e-10 between them";
        for (std::size_t i = 0; i < frames.curvatures.size(); ++i) {
            EXPECT_EQ(frames.first[2 * i + 1], 0);
            EXPECT_EQ(frames.second[2 * i + 1], 0);
            EXPECT_EQ(frames.curvatures[i], 0);
        }
    }
    (void)expect_exact_derivatives(straight_line(), 5);
}

TEST(Derivatives, OfASlopingLineBendByRoundingAlone) {
    // y = 2x - 1 in numbers that doubles hold exactly.
    CurveData data{3, Ends::Open, {}, 2, {}};
    for (const double x : {3.125, 2.625, 1.875, 0.75, 0.25, -0.0625})
        data.points.insert(data.points.end(), {1310000 + x, 6123456 + 2 * x});
    const IntervalSystem system = system_of("A->AA");
    data.word = word_of(system, "000AAA000");
    for (const int steps : {0, 6, 12}) {
        const LimitFrames frames = frames_of(curve_of(system, data), steps);
        for (std::size_t i = 0; i < frames.curvatures.size(); ++i) {
            const double speed = std::hypot(frames.first[2 * i], frames.first[2 * i + 1]);
            const double bend = std::hypot(frames.second[2 * i], frames.second[2 * i + 1]);
            EXPECT_LE(std::abs(frames.curvatures[i]), 4 * epsilon * bend / (speed * speed));
        }
    }
}

/// How often a row of numbers changes its sign, zeros left out.
std::size_t sign_changes(const std::vector<int>& signs) {
    std::size_t changes = 0;
    int last = 0;
    for (const int sign : signs) {
        if (sign != 0 && last != 0 && sign != last) ++changes;
        if (sign != 0) last = sign;
    }
    return changes;
}

TEST(Derivatives, OfARoadHaveNoFalseInflections) {
    // A bend to the left, and one to the left and then to the right, in projected metres along a slope.
    const IntervalSystem system = system_of("A->AA");
    const std::vector<double> left{0, 0.4, 1.6, 3.6, 6.4, 10};
    const std::vector<double> left_right{0, 0.4, 1.6, 3.6, 5.2, 6};
    for (const std::vector<double>& sideways : {left, left_right}) {
        CurveData data{3, Ends::Open, word_of(system, "000AAA000"), 2, {}};
        for (std::size_t i = 0; i < 6; ++i) {
            const auto along = 40 * static_cast<double>(i);
            data.points.insert(data.points.end(), {1310000.1 + along, 6123456.7 + 0.3 * along + sideways[i]});
        }
        const Curve road = curve_of(system, data);
        Refinement refinement(road);
        refinement.advance(9);
        const LimitFrames frames = limit_frames(road, refinement);
        const ExactDerivatives exact(road, refinement.curve());
        std::vector<int> expected;
        exact.for_each_knot(true, [&](const Number& x, bool from_left) {
            const std::vector<Number> first = exact.at(1, x, from_left);
            const std::vector<Number> second = exact.at(2, x, from_left);
            expected.push_back((first[0] * second[1] - first[1] * second[0]).sign());
        });
        std::vector<int> signs;
        for (const double curvature : frames.curvatures) signs.push_back(curvature > 0 ? 1 : curvature < 0 ? -1 : 0);
        EXPECT_EQ(sign_changes(signs), sign_changes(expected));
        EXPECT_EQ(sign_changes(signs), sideways == left ? 0U : 1U);
    }
}

TEST(Derivatives, KnowKnotsApartThatDifferInTheLastDigit) {
    const IntervalSystem system = system_of("A->AA\nB->BB\nC->CC\nD->DD\n"
                                            "length A = .33333333333333326\nlength B = .00000000000000004\n"
                                            "length C = .00000000000000001\nlength D = .66666666666666669");
    const CurveData data{3, Ends::Open, word_of(system, "000ABCD000"), 1, {0, 1, 3, 4, 5, 6, 7}};
    const Curve curve = curve_of(system, data);
    const LimitFrames frames = frames_of(curve, 0);
    EXPECT_EQ(expect_exact_derivatives(curve, 0), 5U);
    EXPECT_EQ(expect_exact_derivatives(curve, 3), 33U);
    // Between the knots in the middle the curve runs at the pace of the points around them.
    for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(frames.first[i], 2.9);
}

TEST(Derivatives, ScaleWithPointsAndLengths) {
    Random random(23);
    const Curve curve = random_curve(random, fibonacci(), 3, Shape::Clamped, 4, 2);
    const LimitFrames frames = frames_of(curve, 2);
    for (const double scale : {0x1p-900, 0x1p1000}) {
        std::vector<double> points;
        for (const double x : curve.points()) points.push_back(x * scale);
        const LimitFrames scaled = frames_of(make_curve(curve.knots(), 2, points).curve.value(), 2);
        for (std::size_t i = 0; i < frames.first.size(); ++i) {
            EXPECT_EQ(scaled.first[i], frames.first[i] * scale);
            EXPECT_EQ(scaled.second[i], frames.second[i] * scale);
        }
    }
    const IntervalSystem tiny = system_of("A->AA\nlength A = 1e-140");
    (void)expect_exact_derivatives(curve_of(tiny, {3, Ends::Open, word_of(tiny, "000AA000"), 1, {3, 1, 4, 1, 5}}), 2);
}

TEST(Derivatives, AreThoseOfTheRefinedCurveToo) {
    // A refined curve has lengths a / ρ^s and keeps its parameter: as given points they have the same derivatives.
    Random random(24);
    const Curve curve = random_curve(random, fibonacci(), 3, Shape::Closed, 4, 2);
    Refinement refinement(curve);
    refinement.advance(2);
    const LimitFrames expected = limit_frames(curve, refinement);
    const LimitFrames frames = limit_frames(refinement.curve(), refinement);
    for (std::size_t i = 0; i < expected.first.size(); ++i) {
        EXPECT_NEAR(frames.first[i], expected.first[i], 1e-13);
        EXPECT_NEAR(frames.second[i], expected.second[i], 1e-12);
    }
}

} // namespace
} // namespace internode
