// SPDX-License-Identifier: MIT

#include "internode/point/infer/reversal.h"

#include "internode/point/interpreter.h"
#include "internode/point/start_word.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::DoubleNear;
using testing::Pointwise;
using testing::SizeIs;

const UniformMask chaikin{2, -1, {Rational(1, 4), Rational(3, 4), Rational(3, 4), Rational(1, 4)}};
const UniformMask cubic_spline{2, -2, {Rational(1, 8), Rational(1, 2), Rational(3, 4), Rational(1, 2), Rational(1, 8)}};

/// Each point three times: the points of arity 3, constant between.
const UniformMask tripled{3, 0, {1, 1, 1}};

std::vector<double> random_points(std::size_t numbers) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> integer(-1000, 1000);
    std::vector<double> points;
    while (points.size() < numbers) points.push_back(integer(random) / 64.0);
    return points;
}

/// One step forward on a ring.
std::vector<double> refined(const UniformMask& mask, const std::vector<double>& points, std::size_t dimension) {
    const std::size_t rows = points.size() / dimension * mask.arity;
    std::vector<double> result(rows * dimension);
    for (std::size_t j = 0; j < points.size() / dimension; ++j)
        for (std::size_t k = 0; k < mask.coefficients.size(); ++k) {
            const auto wide = static_cast<std::ptrdiff_t>(rows);
            const auto row = mask.first + static_cast<std::ptrdiff_t>(k + mask.arity * j);
            for (std::size_t i = 0; i < dimension; ++i)
                result[static_cast<std::size_t>((row % wide + wide) % wide) * dimension + i] +=
                    to_double(mask.coefficients[k]) * points[j * dimension + i];
        }
    return result;
}

TEST(Reversal, GivesBackWhatTheSchemeMade) {
    for (const UniformMask& mask : {chaikin, cubic_spline, tripled}) {
        const std::vector<double> start = random_points(2 * 5);
        const std::vector<double> once = refined(mask, start, 2);
        const std::vector<double> twice = refined(mask, once, 2);
        const auto levels = reversed(mask, reverse_rule(mask).value(), twice, {2, 2, 0});
        ASSERT_THAT(levels, SizeIs(2));
        EXPECT_THAT(levels[0].points, Pointwise(DoubleNear(1e-12), once));
        EXPECT_THAT(levels[1].points, Pointwise(DoubleNear(1e-12), start));
        EXPECT_LT(levels[0].largest_error, 1e-12);
        EXPECT_LE(levels[1].rms_error, levels[1].largest_error);
    }
}

TEST(Reversal, OtherPhasesKeepAResidual) {
    const std::vector<double> fine = refined(chaikin, random_points(2 * 8), 2);
    const auto levels = reversed(chaikin, reverse_rule(chaikin).value(), fine, {2, 1, 1});
    EXPECT_GT(levels[0].largest_error, 1);
    EXPECT_GT(levels[0].rms_error, 0.1);
}

TEST(Reversal, ReportsTheDistanceOfOneMovedPoint) {
    // One point at a distance of 5, all others at 0.
    std::vector<double> fine(2 * 8, 0.0);
    fine[0] = 3;
    fine[1] = 4;
    const auto levels = reversed(chaikin, reverse_rule(chaikin).value(), fine, {2, 1, 0});
    EXPECT_DOUBLE_EQ(levels[0].points[0], 3 * 0.75);
    // In P A, row 0 has 3/4 3/4 - 1/4 1/4 = 1/2 of it, and row 1 has 3/4 3/4: that much is made where nothing was.
    EXPECT_NEAR(levels[0].largest_error, 5 * 9.0 / 16, 1e-15);
}

TEST(Reversal, IsWhatTheInterpreterDoesWithTheDerivedProduction) {
    for (const UniformMask& mask : {chaikin, cubic_spline, tripled}) {
        const ReverseRule rule = reverse_rule(mask, 1).value();
        const std::vector<double> fine = random_points(3 * 18);
        PointSettings settings;
        settings.dimension = 3;
        const PointSystem system = make_point_system(reverse_grammar("r", rule), settings).system.value();
        for (std::uint64_t phase = 0; phase < mask.arity; ++phase) {
            DeriveOptions options;
            options.phase = phase;
            const Derivation derived = derive_step(system, input_word(system, fine), 0, options);
            ASSERT_FALSE(derived.problem) << derived.problem->message;
            const auto levels = reversed(mask, rule, fine, {3, 1, phase});
            ASSERT_EQ(derived.word.size() * 3, levels[0].points.size());
            for (std::size_t i = 0; i < derived.word.size(); ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    EXPECT_NEAR(derived.word.values(i)[k], levels[0].points[3 * i + k], 1e-12)
                        << "phase " << phase << ", point " << i;
        }
    }
}

TEST(Reversal, NeedsPointsThatCanBeDivided) {
    const ReverseRule rule = reverse_rule(chaikin).value();
    const std::vector<double> points(2 * 12);
    EXPECT_NO_THROW((void)reversed(chaikin, rule, points, {2, 2, 0}));
    EXPECT_THROW((void)reversed(chaikin, rule, points, {2, 3, 0}), std::invalid_argument);
    EXPECT_THROW((void)reversed(chaikin, rule, points, {2, 1000, 0}), std::invalid_argument);
    EXPECT_THROW((void)reversed(chaikin, rule, points, {5, 1, 0}), std::invalid_argument);
    EXPECT_THROW((void)reversed(chaikin, rule, {}, {2, 1, 0}), std::invalid_argument);
    EXPECT_THROW((void)reversed(tripled, rule, points, {2, 1, 0}), std::invalid_argument);
    EXPECT_EQ(points_per_coarse_point(2, 4), 16U);
    EXPECT_EQ(points_per_coarse_point(1, 1'000'000'000), 1U);
    EXPECT_FALSE(points_per_coarse_point(3, 100));
}

} // namespace
} // namespace internode
