// SPDX-License-Identifier: MIT

#include "internode/curve/convergence.h"

#include "internode/curve/distance.h"
#include "internode/curve/refinement.h"
#include "internode/grammar/bundled.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/spline/blossom.h"
#include "tests/fixtures/random_curve.h"
#include "tests/reference/de_boor.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <optional>
#include <string>

namespace internode {
namespace {

using tests::curve_of;
using tests::fibonacci;
using tests::Random;
using tests::random_curve;
using tests::Shape;
using tests::system_with;

ConvergenceOptions after(int steps, std::optional<double> tolerance = std::nullopt) {
    ConvergenceOptions options;
    options.steps = steps;
    options.tolerance = tolerance;
    return options;
}

/// A closed polygon like a leaf, 12 points, over the letters of the system in turn.
Curve leaf(const IntervalSystem& system, int degree) {
    const std::vector<double> points{0, 0, 1.5, 0.6,  3, 1.6,  4.5, 2,  6, 1.7,  7.5, 0.8,
                                     9, 0, 7.5, -0.8, 6, -1.7, 4.5, -2, 3, -1.6, 1.5, -0.6};
    Word letters;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) letters.push_back(to_symbol(i));
    return curve_of(system, {degree, Ends::Circular, repeated(letters, 12), 2, points});
}

/// The control polygon of x² over a word: v_k is the mean of the products of two of its d knots.
Curve parabola(const IntervalSystem& system, int degree, const Word& word) {
    const auto d = static_cast<std::size_t>(degree);
    const std::vector<Number> t = knots(system, word);
    CurveData data{degree, Ends::Open, word, 1, {}};
    for (std::size_t k = 0; k + d < word.size(); ++k) {
        Number sum;
        for (std::size_t i = 1; i <= d; ++i)
            for (std::size_t j = i + 1; j <= d; ++j) sum += (t[k + i] - t[d]) * (t[k + j] - t[d]);
        data.points.push_back((sum * Number(2) / Number(degree * (degree - 1))).to_double());
    }
    return curve_of(system, data);
}

TEST(Convergence, TheRatioTendsToTheInverseSquareOfTheSystems) {
    for (const auto& rules : std::vector<std::vector<std::string>>{{"BA", "A"}, {"AAB", "A"}, {"AA"}})
        for (const int degree : {2, 3, 4}) {
            const Convergence result = measure_convergence(leaf(system_with(rules), degree), after(8));
            const double expected = result.expected_ratio.to_double();
            // The words near the largest second derivative vary from step to step: a mean over four of them.
            double product = 1;
            for (std::size_t step = 5; step <= 8; ++step) product *= result.steps[step].ratio.value();
            EXPECT_NEAR(std::pow(product, 0.25), expected, 0.04 * expected) << rules[0] << " degree " << degree;
        }
}

TEST(Convergence, AnImprimitiveSystemHasItsGeometricMeanOverAPeriod) {
    // Slow growth: A -> CC, B -> A, C -> B, ratio 2^(1/3), period 3.
    const IntervalSystem system = system_with({"CC", "A", "B"});
    ASSERT_EQ(system.period(), 3u);
    const Convergence result = measure_convergence(leaf(system, 3), after(15));
    const double expected = result.expected_ratio.to_double();
    EXPECT_NEAR(expected, std::pow(2, -2.0 / 3), 1e-15);
    for (std::size_t step = 0; step < 3; ++step) EXPECT_FALSE(result.steps[step].ratio.has_value());
    EXPECT_NEAR(*result.steps.back().ratio, expected, 0.02 * expected);
}

TEST(Convergence, ReportsWhatEachStepMeasures) {
    const Curve curve = leaf(fibonacci(), 3);
    const Convergence result = measure_convergence(curve, after(4));
    EXPECT_EQ(result.degree, 3);
    EXPECT_EQ(result.constant.value, largest_polygon_constant(curve.system(), 3).value);
    ASSERT_EQ(result.steps.size(), 5u);
    for (int step = 0; step <= 4; ++step) {
        const Curve fine = refine(curve, step);
        const ConvergenceStep& found = result.steps[static_cast<std::size_t>(step)];
        EXPECT_EQ(found.step, step);
        EXPECT_EQ(found.points, fine.size());
        EXPECT_EQ(found.error, polygon_distance(fine).error);
        EXPECT_EQ(found.envelope, polygon_distance(fine).envelope);
        EXPECT_LE(found.error, found.envelope);
    }
}

/// envelope / error from step 3 on, at its worst, for a leaf over the letters of a system.
double loosest_envelope(const IntervalSystem& system, int degree) {
    const Convergence result = measure_convergence(leaf(system, degree), after(6));
    double loosest = 1;
    for (std::size_t step = 3; step < result.steps.size(); ++step)
        loosest = std::max(loosest, result.steps[step].envelope / result.steps[step].error);
    return loosest;
}

TEST(Convergence, TheEnvelopeIsCloseFromTheThirdStepOn) {
    for (const BundledGrammar& bundled : bundled_grammars(GrammarKind::Intervals)) {
        const Verdict verdict = validate(*parse_grammar(bundled.text, bundled.name).grammar);
        if (!verdict.system) continue;
        for (int degree = 2; degree <= 4; ++degree) {
            const double loosest = loosest_envelope(*verdict.system, degree);
            std::string key(bundled.name);
            std::ranges::replace(key, '-', '_');
            RecordProperty(key + "_" + std::to_string(degree), std::to_string(loosest));
            EXPECT_LE(loosest, 1.5) << bundled.name << " degree " << degree;
        }
    }
}

TEST(Convergence, ThePolygonOfAParabolaIsOffByItsConstantAtEveryAbscissa) {
    // s(ξ_k) - v_k = c_k s'', exactly.
    Random random(1);
    for (int degree = 2; degree <= 6; ++degree)
        for (const Shape shape : {Shape::Open, Shape::OpenWithZeros}) {
            const auto d = static_cast<std::size_t>(degree);
            const Curve curve =
                parabola(fibonacci(), degree, random_curve(random, fibonacci(), degree, shape, 6, 1).word());
            const reference::DeBoorCurve slow = reference::de_boor_curve(curve);
            for (std::size_t k = 0; k < curve.size(); ++k) {
                reference::Real abscissa = 0;
                for (std::size_t i = 1; i <= d; ++i) abscissa += slow.knots[k + i];
                abscissa /= degree;
                if (abscissa < slow.begin() || abscissa > slow.end()) continue;
                const Number constant = polygon_constant(curve.system(), WordView(curve.word()).subspan(k + 1, d - 1));
                const auto off = static_cast<double>(reference::de_boor(slow, abscissa)[0]) - curve.points()[k];
                EXPECT_NEAR(off, 2 * constant.to_double(), 1e-11);
            }
        }
}

TEST(Convergence, TheErrorOfAParabolaReachesTheConstantExactly) {
    for (int degree = 2; degree <= 6; ++degree) {
        const Word letters{Symbol{0}, Symbol{1}, Symbol{0}, Symbol{0}, Symbol{1}};
        const Curve curve = parabola(fibonacci(), degree, repeated(letters, 20 + static_cast<std::size_t>(degree)));
        const Convergence result = measure_convergence(curve, after(3));
        const double scale = pow(curve.system().ratio(), 6).to_double();
        EXPECT_NEAR(result.steps.back().error * scale, 2 * result.constant.value.to_double(), 1e-9) << degree;
    }
}

TEST(Convergence, BisectionGoesOnToAboutAsManyPoints) {
    const Convergence result = measure_convergence(leaf(fibonacci(), 3), after(8));
    const std::uint64_t target = result.steps.back().points;
    ASSERT_GE(result.bisection.size(), 2u);
    EXPECT_EQ(result.bisection.front().points, 12u);
    EXPECT_EQ(result.bisection.front().error, result.steps.front().error);
    EXPECT_GE(result.bisection.back().points, target);
    EXPECT_LT(result.bisection.back().points, 2 * target);
    EXPECT_NEAR(result.bisection.back().error / result.bisection[result.bisection.size() - 2].error, 0.25, 0.01);
}

TEST(Convergence, ADepthForAToleranceIsMeasured) {
    const Curve curve = leaf(fibonacci(), 3);
    const Convergence result = measure_convergence(curve, after(2, 1e-4));
    ASSERT_TRUE(result.depth.has_value() && result.depth->steps.has_value());
    EXPECT_TRUE(result.depth->measured);
    const int steps = *result.depth->steps;
    EXPECT_GT(steps, 2);
    EXPECT_LE(polygon_distance(refine(curve, steps)).envelope, 1e-4);
    EXPECT_GT(polygon_distance(refine(curve, steps - 1)).envelope, 1e-4);
}

TEST(Convergence, ADepthBeyondTheSearchIsExtrapolated) {
    ConvergenceOptions options = after(5, 1e-5);
    const Convergence measured = measure_convergence(leaf(fibonacci(), 3), options);
    options.search_points = 500;
    const Convergence extrapolated = measure_convergence(leaf(fibonacci(), 3), options);
    ASSERT_TRUE(extrapolated.depth && extrapolated.depth->steps && measured.depth && measured.depth->steps);
    EXPECT_FALSE(extrapolated.depth->measured);
    EXPECT_NEAR(*extrapolated.depth->steps, *measured.depth->steps, 1);
}

TEST(Convergence, AToleranceMetAtOnceNeedsNoSteps) {
    const Convergence result = measure_convergence(leaf(fibonacci(), 3), after(1, 100));
    EXPECT_EQ(result.depth->steps, 0);
    EXPECT_TRUE(result.depth->measured);
    const Convergence exact = measure_convergence(leaf(fibonacci(), 1), after(1, 1e-300));
    EXPECT_EQ(exact.depth->steps, 0);
    EXPECT_FALSE(exact.steps[1].ratio.has_value());
}

TEST(Convergence, AnErrorHasItsPriceUnderBisection) {
    Convergence convergence;
    EXPECT_FALSE(bisection_points(convergence));
    convergence.steps = {{0, 10, 1, 0, {}, 0}};
    convergence.bisection = {{10, 8}, {20, 2}, {40, 0.5}};
    EXPECT_FALSE(bisection_points(convergence)); // no error, no price
    convergence.steps.back().error = 2;
    EXPECT_EQ(bisection_points(convergence), 20);
    convergence.steps.back().error = 0.5;
    EXPECT_EQ(bisection_points(convergence), 40);
    convergence.steps.back().error = 0.125; // beyond the last: a quarter of the error for twice the points
    EXPECT_EQ(bisection_points(convergence), 80);
    convergence.steps.back().error = 9;
    EXPECT_FALSE(bisection_points(convergence)); // bisection starts below that error
}

TEST(Convergence, RefusesWhatItCannotDo) {
    const Curve curve = leaf(fibonacci(), 3);
    EXPECT_THROW((void)measure_convergence(curve, after(-1)), std::invalid_argument);
    EXPECT_THROW((void)measure_convergence(curve, after(1, 0.0)), std::invalid_argument);
    EXPECT_THROW((void)measure_convergence(curve, after(1, INFINITY)), std::invalid_argument);
    ConvergenceOptions options = after(50);
    options.max_points = 1000;
    EXPECT_THROW((void)measure_convergence(curve, options), std::length_error);
}

} // namespace
} // namespace internode
