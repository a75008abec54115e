// SPDX-License-Identifier: MIT

#include "internode/curve/homogeneous.h"

#include "internode/curve/knot_vector.h"
#include "internode/curve/limit.h"
#include "tests/fixtures/random_curve.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <stdexcept>

namespace internode {
namespace {

using ::testing::ElementsAre;

TEST(Homogeneous, MultipliesAndDividesByTheWeight) {
    const std::vector<double> points{1, 2, 3, 4};
    const std::vector<double> weights{2, 0.5};
    const std::vector<double> rows = homogeneous(points, 2, weights);
    EXPECT_THAT(rows, ElementsAre(2, 4, 2, 1.5, 2, 0.5));
    EXPECT_THAT(projected(rows, 3), ElementsAre(1, 2, 2, 3, 4, 0.5));
    EXPECT_THAT(projected_points(rows, 3), ElementsAre(1, 2, 3, 4));
}

TEST(Homogeneous, FindsTheFirstBadWeight) {
    const std::vector<double> none{1, 1e-100, 1e100};
    EXPECT_FALSE(first_bad_weight(none));
    for (const double bad : {0.0, -1.0, 1e-101, 1e101, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
        const std::vector<double> weights{1, bad, bad};
        EXPECT_EQ(first_bad_weight(weights), 1U) << bad;
    }
}

TEST(Homogeneous, RefusesWhatDoesNotFit) {
    const std::vector<double> three{1, 2, 3};
    const std::vector<double> weights{1, 0};
    const std::vector<double> points{1, 2};
    EXPECT_THROW((void)homogeneous(three, 2, weights), std::invalid_argument);
    EXPECT_THROW((void)homogeneous({}, 0, {}), std::invalid_argument);
    EXPECT_THROW((void)homogeneous(points, 1, weights), std::invalid_argument);
    EXPECT_THROW((void)projected(three, 2), std::invalid_argument);
    EXPECT_THROW((void)projected(three, 1), std::invalid_argument);
    EXPECT_THROW((void)projected(weights, 2), std::invalid_argument);
}

/// The unit circle of four quadratic arcs: points on it and corners of the square around it, in turn.
std::vector<double> circle_rows(std::size_t count) {
    constexpr int x[] = {1, 1, 0, -1, -1, -1, 0, 1};
    constexpr int y[] = {0, 1, 1, 1, 0, -1, -1, -1};
    std::vector<double> points;
    std::vector<double> weights;
    for (std::size_t k = 0; k < count; ++k) {
        points.push_back(x[k % 8]);
        points.push_back(y[k % 8]);
        weights.push_back(k % 2 == 0 ? 1 : std::sqrt(0.5));
    }
    return homogeneous(points, 2, weights);
}

double worst_radius(const std::vector<double>& rows) {
    double worst = 0;
    const std::vector<double> points = projected(rows, 3);
    for (std::size_t i = 0; i < points.size(); i += 3)
        worst = std::max(worst, std::abs(std::hypot(points[i], points[i + 1]) - 1));
    return worst;
}

void expect_circle(const KnotVector& knots) {
    for (const auto& rules : {"AA", "AAA"}) {
        const FittedKnots fitted = fit_knots(tests::system_with({rules}), knots);
        ASSERT_TRUE(fitted.fitted) << fitted.problems.front();
        const Curve curve =
            tests::curve_of(fitted.fitted->system, {2, knots.ends, fitted.fitted->word, 3, circle_rows(knots.points)});
        Refinement refinement(curve);
        const int steps = rules[2] == '\0' ? 10 : 6;
        for (int step = 0; step < steps; ++step) refinement.step();
        const LimitPoints limit = limit_points(refinement);
        EXPECT_GE(limit.parameters.size(), 2916U);
        EXPECT_LE(worst_radius(limit.points), 1e-13);
        // A chord's corner lies above the circle by half the square of its angle, all corners alike to second order.
        EXPECT_LE(worst_radius(refinement.curve().points()), 1e-6);
    }
}

TEST(Homogeneous, ACircleOfNinePointsStaysOneThroughTenSteps) {
    KnotVector knots{.degree = 2, .ends = Ends::Open, .points = 9, .knots = {}};
    for (const int knot : {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}) knots.knots.emplace_back(knot);
    expect_circle(knots);
}

TEST(Homogeneous, AClosedCircleOfEightPointsStaysOneThroughTenSteps) {
    KnotVector knots{.degree = 2, .ends = Ends::Circular, .points = 8, .knots = {}};
    for (const int knot : {0, 1, 1, 2, 2, 3, 3, 4, 4}) knots.knots.emplace_back(knot);
    expect_circle(knots);
}

} // namespace
} // namespace internode
