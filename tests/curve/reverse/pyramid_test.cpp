// SPDX-License-Identifier: MIT
//
// Pyramids: analysis and synthesis are inverse, details can be left out at a measured price, and data that do not fit
// are refused.

#include "internode/curve/reverse/pyramid_errors.h"

#include "internode/curve/refinement.h"
#include "internode/curve/reverse/reverse_step.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/numbers.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/stride.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numeric>

namespace internode {
namespace {

using ::testing::HasSubstr;
using tests::curve_of;
using tests::fibonacci;
using tests::largest_difference;
using tests::Random;
using tests::random_curve;
using tests::random_numbers;
using tests::random_system;
using tests::Shape;
using tests::system_of;
using tests::word_of;

const int repetitions = tests::times(12);
const int long_pyramid = tests::in_full() ? 49 : 24;

std::size_t fine_size(const Curve& coarse, int levels) {
    return static_cast<std::size_t>(refined_size(coarse, static_cast<std::uint64_t>(levels), 1'000'000).points);
}

/// The knots of a closed or open word of one-letter symbols.
Knots knots_of(const IntervalSystem& system, int degree, Ends ends, const Word& word) {
    return *make_knots(system, {degree, ends, word}).knots;
}

TEST(Pyramid, TakesARefinedPolygonApartIntoWhatItWasMadeOf) {
    Random random(1);
    for (int time = 0; time < repetitions; ++time)
        for (int degree = 1; degree <= 5; ++degree)
            for (const Shape shape : {Shape::Closed, Shape::Clamped, Shape::ClosedWithZeros, Shape::ClampedWithZeros}) {
                const Curve coarse = random_curve(random, random_system(random), degree, shape, 1 + random.below(9), 2);
                const Curve fine = refine(coarse, 3);
                const Analysis analysis = analyse(coarse.knots(), 3, 2, fine.points());
                EXPECT_LT(largest_difference(analysis.pyramid.coarse.points(), coarse.points()), 1e-12);
                EXPECT_EQ(detail_count(thresholded(analysis.pyramid, 1e-12)), 0u);
            }
}

TEST(Pyramid, GivesTheFinePolygonBackFromCoarsePointsAndDetails) {
    Random random(2);
    for (int time = 0; time < repetitions; ++time)
        for (int degree = 1; degree <= 5; ++degree)
            for (const Shape shape : {Shape::Closed, Shape::Clamped, Shape::ClosedWithZeros, Shape::ClampedWithZeros})
                for (const ReverseMethod method : {ReverseMethod::LeastSquares, ReverseMethod::Local}) {
                    const Curve coarse =
                        random_curve(random, random_system(random), degree, shape, 1 + random.below(9), 2);
                    const std::vector<double> fine = random_numbers(random, 2 * fine_size(coarse, 3));
                    const Analysis analysis = analyse(coarse.knots(), 3, 2, fine, {method, 4});
                    EXPECT_EQ(analysis.pyramid.coarse.size() + detail_count(analysis.pyramid), fine.size() / 2);
                    const std::vector<std::vector<double>> polygons = synthesise(analysis.pyramid);
                    for (std::size_t level = 0; level < polygons.size(); ++level)
                        EXPECT_LT(largest_difference(polygons[level], analysis.polygons[level]), 1e-12);
                }
}

TEST(Pyramid, KeepsItsDigitsOverManyLevelsOfSlowGrowth) {
    const IntervalSystem system = system_of("A->DD, B->A, C->B, D->C");
    Random random(3);
    for (const Ends ends : {Ends::Circular, Ends::Open})
        for (int degree = 1; degree <= 5; ++degree) {
            Word word = word_of(system, "ABCDADCB");
            if (ends == Ends::Open) word = clamped(word, degree);
            const Knots knots = knots_of(system, degree, ends, word);
            const auto size = static_cast<std::size_t>(refined_size(knots, 2, long_pyramid, 1'000'000).points);
            const std::vector<double> fine = random_numbers(random, 2 * size);
            const Analysis analysis = analyse(knots, long_pyramid, 2, fine);
            EXPECT_LT(largest_difference(synthesise(analysis.pyramid).back(), fine), 1e-12);
            EXPECT_LT(*std::ranges::max_element(analysis.gains), 10);
        }
}

TEST(Pyramid, OfAClosedWordOfOneLetter) {
    Random random(4);
    for (const char* const rules : {"A->AA", "A->AAA"})
        for (int degree = 1; degree <= 12; ++degree) {
            const IntervalSystem system = system_of(rules);
            const Knots knots = knots_of(system, degree, Ends::Circular, Word{to_symbol(0)});
            const std::vector<double> fine = random_numbers(random, refined_size(knots, 1, 4, 1000).points);
            const Analysis analysis = analyse(knots, 4, 1, fine);
            EXPECT_LT(largest_difference(synthesise(analysis.pyramid).back(), fine), 1e-12);
            EXPECT_EQ(analysis.pyramid.coarse.size(), 1u);
        }
}

TEST(Pyramid, WhereNothingSplitsIsTheSamePolygonWithoutDetails) {
    const IntervalSystem system = system_of("A->DD, B->A, C->B, D->C");
    Random random(5);
    const Knots knots = knots_of(system, 3, Ends::Circular, word_of(system, "DDDDD"));
    const std::vector<double> fine = random_numbers(random, 10);
    const Analysis analysis = analyse(knots, 3, 2, fine);
    for (const PyramidLevel& level : analysis.pyramid.levels) EXPECT_EQ(level.inserted, 0u);
    EXPECT_EQ(analysis.pyramid.coarse.points(), fine);
    EXPECT_EQ(detail_count(analysis.pyramid), 0u);
}

TEST(Pyramid, ReportsTheNoiseGainOfUnclampedEnds) {
    const IntervalSystem system = fibonacci();
    Random random(6);
    const Word domain = word_of(system, "ABAABABA");
    const auto gain = [&](const Word& word, int degree) {
        const Knots knots = knots_of(system, degree, Ends::Open, word);
        const Analysis analysis =
            analyse(knots, 5, 1, random_numbers(random, refined_size(knots, 1, 5, 100000).points));
        return analysis.gains.front();
    };
    Word open = word_of(system, "ABABA");
    open.insert(open.end(), domain.begin(), domain.end());
    open.insert(open.end(), 5, to_symbol(0));
    EXPECT_LT(gain(clamped(domain, 5), 5), 10);
    EXPECT_GT(gain(open, 5), 1000);
}

TEST(Pyramid, NoiseGainDoesNotDependOnWhereTheOriginIs) {
    const Knots knots = knots_of(fibonacci(), 3, Ends::Circular, word_of(fibonacci(), "ABAAB"));
    Random random(7);
    std::vector<double> fine = random_numbers(random, 2 * refined_size(knots, 2, 3, 1000).points);
    const std::vector<double> gains = analyse(knots, 3, 2, fine).gains;
    for (double& number : fine) number += 1024;
    EXPECT_LT(largest_difference(analyse(knots, 3, 2, fine).gains, gains), 1e-9);
    EXPECT_EQ(gains.back(), 1);
    EXPECT_EQ(analyse(knots, 3, 2, std::vector<double>(fine.size(), 5.0)).gains.front(), 1);
}

TEST(Pyramid, LeastSquaresDetailsLeftOutCostAtMostTheirLength) {
    Random random(8);
    for (const int degree : {1, 2, 3, 5}) {
        const Curve coarse = random_curve(random, fibonacci(), degree, Shape::Closed, 8, 2);
        const std::vector<double> fine = random_numbers(random, 2 * fine_size(coarse, 1));
        const Pyramid whole = analyse(coarse.knots(), 1, 2, fine).pyramid;
        const Pyramid kept = with_longest(whole, 3);
        double left_out = 0;
        for (const double length : lengths_of(whole.levels[0].details, 2)) left_out += length * length;
        for (const double length : lengths_of(kept.levels[0].details, 2)) left_out -= length * length;
        const PolygonError error = polygon_error(synthesise(kept).back(), fine, 2);
        const double sum = error.root_mean_square * error.root_mean_square * static_cast<double>(fine.size() / 2);
        EXPECT_LE(sum, left_out * (1 + 1e-9) + 1e-24) << degree;
    }
}

TEST(Pyramid, ThresholdsKeepLongDetailsAndCountsTheLongest) {
    Random random(9);
    const Curve coarse = random_curve(random, fibonacci(), 3, Shape::Clamped, 8, 2);
    const std::vector<double> fine = random_numbers(random, 2 * fine_size(coarse, 3));
    const Pyramid whole = analyse(coarse.knots(), 3, 2, fine).pyramid;
    const Pyramid long_ones = thresholded(whole, 0.5);
    const std::size_t count = detail_count(long_ones);
    ASSERT_GT(count, 0u);
    ASSERT_LT(count, detail_count(whole));
    const Pyramid longest = with_longest(whole, count);
    for (std::size_t level = 0; level < whole.levels.size(); ++level) {
        EXPECT_EQ(longest.levels[level].details.points, long_ones.levels[level].details.points);
        for (const double length : lengths_of(long_ones.levels[level].details, 2)) EXPECT_GE(length, 0.5);
    }
    EXPECT_EQ(detail_count(thresholded(whole, 0)), detail_count(whole));
    EXPECT_EQ(detail_count(with_longest(whole, 1'000'000)), detail_count(whole));
    EXPECT_EQ(detail_count(with_longest(whole, 0)), 0u);
}

TEST(Pyramid, WithoutDetailsIsTheRefinedCoarsePolygon) {
    Random random(10);
    const Curve coarse = random_curve(random, fibonacci(), 3, Shape::Closed, 8, 2);
    const std::vector<double> fine = random_numbers(random, 2 * fine_size(coarse, 3));
    const Analysis analysis = analyse(coarse.knots(), 3, 2, fine);
    const std::vector<double> smooth = synthesise(with_longest(analysis.pyramid, 0)).back();
    EXPECT_LT(largest_difference(smooth, refine(analysis.pyramid.coarse, 3).points()), 1e-13);
    const std::vector<PolygonError> errors = approximation_errors(analysis);
    ASSERT_EQ(errors.size(), 4u);
    EXPECT_EQ(errors.front().largest, polygon_error(smooth, fine, 2).largest);
    EXPECT_EQ(errors.back().largest, 0);
}

TEST(Pyramid, MeasuresEachLevelAndWhatIsKept) {
    Random random(3);
    const Curve coarse = random_curve(random, fibonacci(), 3, Shape::Closed, 6, 2);
    const std::vector<double> fine = random_numbers(random, 2 * fine_size(coarse, 4));
    const Analysis analysis = analyse(coarse.knots(), 4, 2, fine);
    const std::vector<std::vector<double>> again = synthesise(analysis.pyramid);

    const PyramidErrors whole = pyramid_errors(analysis, analysis.pyramid);
    ASSERT_EQ(whole.round_trips.size(), 5u);
    for (std::size_t level = 0; level < 5; ++level)
        EXPECT_EQ(whole.round_trips[level].largest, polygon_error(again[level], analysis.polygons[level], 2).largest);
    EXPECT_EQ(whole.kept.largest, whole.round_trips.back().largest);
    EXPECT_LT(whole.kept.largest, 1e-13);
    ASSERT_EQ(whole.approximations.size(), 5u);

    const Pyramid kept = with_longest(analysis.pyramid, 5);
    const PyramidErrors some = pyramid_errors(analysis, kept);
    EXPECT_EQ(some.kept.largest, polygon_error(synthesise(kept).back(), fine, 2).largest);
    EXPECT_EQ(some.round_trips.back().largest, whole.round_trips.back().largest);
}

TEST(Pyramid, MeasuresThePolygonErrorPointByPoint) {
    const std::vector<double> a{0, 0, 1, 1};
    const std::vector<double> b{3, 4, 1, 1};
    EXPECT_EQ(polygon_error(a, b, 2).largest, 5);
    EXPECT_EQ(polygon_error(a, b, 2).root_mean_square, std::sqrt(12.5));
    EXPECT_THROW((void)polygon_error(a, {}, 2), std::invalid_argument);
}

TEST(Pyramid, PolygonsWithoutPointsHaveNoError) {
    const PolygonError error = polygon_error({}, {}, 2);
    EXPECT_EQ(error.largest, 0);
    EXPECT_EQ(error.root_mean_square, 0);
}

TEST(Pyramid, RefusesPolygonsThatDoNotFit) {
    const Knots knots = knots_of(fibonacci(), 2, Ends::Circular, word_of(fibonacci(), "AB"));
    EXPECT_THROW((void)analyse(knots, 1, 1, std::vector<double>{1, 2}), std::invalid_argument);
    EXPECT_THROW((void)analyse(knots, 1, 0, std::vector<double>{}), std::invalid_argument);
    EXPECT_THROW((void)analyse(knots, -1, 1, std::vector<double>{1, 2}), std::invalid_argument);
    EXPECT_THROW((void)analyse(knots, 1, 1, std::vector<double>{1, 2, 1e151}), std::invalid_argument);
    EXPECT_THROW((void)analyse(knots, 1, 1, std::vector<double>{1, 2, std::nan("")}), std::invalid_argument);
    EXPECT_THROW((void)analyse(knots, 1, 1, std::vector<double>{1, 2, 3}, {ReverseMethod::Local, 0}),
                 std::invalid_argument);
    const Hierarchy hierarchy(knots, 1);
    const ReverseStep step(hierarchy, 0);
    EXPECT_THROW((void)step.coarse(std::vector<double>{1}, 1), std::invalid_argument);
    EXPECT_THROW((void)step.details(std::vector<double>{1}, std::vector<double>{1, 2}, 1), std::invalid_argument);
    EXPECT_THROW((void)step.fine(std::vector<double>{1}, {{0}, {1}}, 1), std::invalid_argument);
    EXPECT_THROW((void)step.fine(std::vector<double>{1, 2}, {{0}, {}}, 1), std::invalid_argument);
    EXPECT_THROW((void)step.fine(std::vector<double>{1, 2}, {{3}, {1}}, 1), std::out_of_range);
}

TEST(Pyramid, RefusesLevelsThatDoNotFitTheWord) {
    const Curve coarse = curve_of(fibonacci(), {2, Ends::Circular, word_of(fibonacci(), "AB"), 1, {1, 2}});
    const auto problem = [&coarse](PyramidLevel level) {
        const CheckedPyramid checked = make_pyramid(coarse, {}, {std::move(level)});
        return checked.pyramid ? std::string("none") : checked.problems.front();
    };
    EXPECT_EQ(problem({3, 1, {{2}, {0.5}}}), "none");
    EXPECT_EQ(problem({3, 1, {}}), "none");
    EXPECT_THAT(problem({4, 1, {}}), HasSubstr("4 points where the word gives 3"));
    EXPECT_THAT(problem({2, 1, {}}), HasSubstr("2 points where the word gives more"));
    EXPECT_THAT(problem({3, 2, {}}), HasSubstr("2 inserted"));
    EXPECT_THAT(problem({3, 1, {{1, 2}, {1, 2}}}), HasSubstr("2 details for 1"));
    EXPECT_THAT(problem({3, 1, {{1}, {1, 2}}}), HasSubstr("2 coordinates"));
    EXPECT_THAT(problem({3, 1, {{3}, {1}}}), HasSubstr("point 3 of 3"));
    EXPECT_THAT(problem({3, 1, {{1}, {1e200}}}), HasSubstr("1e150"));
    const PyramidLevel first{3, 1, {}};
    const PyramidLevel second{5, 2, {{4, 1}, {1, 1}}};
    EXPECT_THAT(make_pyramid(coarse, {}, {first, second}).problems.front(), HasSubstr("out of order at point 1"));
    EXPECT_FALSE(make_pyramid(coarse, {ReverseMethod::Local, 0}, {first}).pyramid);
}

} // namespace
} // namespace internode
