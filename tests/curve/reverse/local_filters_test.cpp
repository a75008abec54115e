// SPDX-License-Identifier: MIT
//
// Local filters and what they and the least squares are made of.

#include "internode/curve/reverse/local_filters.h"

#include "internode/curve/reverse/kept_points.h"
#include "internode/curve/reverse/normal_equations.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/numbers.h"
#include "tests/fixtures/random_curve.h"

#include <cmath>
#include <gmock/gmock.h>

namespace internode {
namespace {

using ::testing::ElementsAre;
using tests::all_shapes;
using tests::fibonacci;
using tests::largest_difference;
using tests::Random;
using tests::random_curve;
using tests::random_numbers;
using tests::random_system;
using tests::Shape;
using tests::system_of;
using tests::word_of;

TEST(LocalFilters, ReproduceEveryCoarsePolygonWithAnyWindow) {
    Random random(1);
    for (int degree = 1; degree <= 4; ++degree)
        for (const Shape shape : all_shapes) {
            const Curve curve = random_curve(random, random_system(random), degree, shape, 1 + random.below(9), 1);
            const Hierarchy hierarchy(curve.knots(), 1);
            const GatherMatrix matrix = hierarchy.matrix(0);
            const std::vector<double> fine = product(matrix, curve.points(), 1);
            for (std::size_t window = 1; window <= 6; ++window) {
                const LocalFilters filters(hierarchy, 0, matrix, window);
                EXPECT_LT(largest_difference(filters.apply(fine, 1), curve.points()), 1e-9)
                    << "degree " << degree << ", window " << window;
            }
        }
}

TEST(LocalFilters, AreSharedByEqualWindows) {
    const IntervalSystem system = fibonacci();
    Word word = word_of(system, "A");
    for (int step = 0; step < 14; ++step) word = system.rules()(word);
    const Hierarchy hierarchy(*make_knots(system, {3, Ends::Circular, word}).knots, 1);
    const LocalFilters filters(hierarchy, 0, hierarchy.matrix(0), 5);
    // A Sturmian word has m + 1 factors of length m; the states of m + d cells are set by m + 3 d - 2 letters. The
    // seam adds as many again.
    EXPECT_LE(filters.count(), 2 * (5 + 3 * 3 - 1U));
}

TEST(LocalFilters, StayWithinTheirWindow) {
    const IntervalSystem system = system_of("A->AA");
    const Hierarchy hierarchy(*make_knots(system, {2, Ends::Circular, Word(40)}).knots, 1);
    const LocalFilters filters(hierarchy, 0, hierarchy.matrix(0), 3);
    std::vector<double> impulse(80);
    impulse[40] = 1;
    const std::vector<double> coarse = filters.apply(impulse, 1);
    // 3 old intervals are met by 6 + 2 new points, so a new point reaches at most 4 old ones.
    EXPECT_LE(std::ranges::count_if(coarse, [](double number) { return number != 0; }), 4);
}

TEST(LocalFilters, RefuseNoWindowAndOtherSizes) {
    const Hierarchy hierarchy(*make_knots(fibonacci(), {2, Ends::Circular, Word(4)}).knots, 1);
    const GatherMatrix matrix = hierarchy.matrix(0);
    EXPECT_THROW(LocalFilters(hierarchy, 0, matrix, 0), std::invalid_argument);
    const LocalFilters filters(hierarchy, 0, matrix, 3);
    EXPECT_THROW((void)filters.apply(std::vector<double>(3), 1), std::invalid_argument);
    EXPECT_THROW((void)filters.apply(std::vector<double>(8), 0), std::invalid_argument);
}

TEST(GatherMatrix, MultipliesAndItsTransposeIsAdjoint) {
    Random random(2);
    for (const Shape shape : all_shapes) {
        const Curve curve = random_curve(random, random_system(random), 3, shape, 1 + random.below(5), 1);
        const Hierarchy hierarchy(curve.knots(), 1);
        const GatherMatrix matrix = hierarchy.matrix(0);
        const std::vector<double> coarse = random_numbers(random, matrix.columns);
        const std::vector<double> fine = random_numbers(random, matrix.rows.size());
        const std::vector<double> forwards = product(matrix, coarse, 1);
        const std::vector<double> backwards = transposed_product(matrix, fine, 1);
        double left = 0;
        double right = 0;
        for (std::size_t i = 0; i < fine.size(); ++i) left += fine[i] * forwards[i];
        for (std::size_t i = 0; i < coarse.size(); ++i) right += coarse[i] * backwards[i];
        EXPECT_NEAR(left, right, 1e-13);
    }
    EXPECT_THROW((void)product({}, std::vector<double>{1}, 1), std::invalid_argument);
    EXPECT_THROW((void)transposed_product({}, std::vector<double>{1}, 1), std::invalid_argument);
}

TEST(NormalEquations, KnowAMatrixWithoutFullRank) {
    const std::vector<double> half{0.5, 0.5};
    GatherMatrix matrix;
    matrix.ends = Ends::Circular;
    matrix.columns = 4;
    for (std::ptrdiff_t k = 0; k < 4; ++k) matrix.rows.push_back({k, half}); // alternating points give 0
    EXPECT_FALSE(NormalEquations(matrix).regular());
    matrix.rows.push_back({0, std::span(half).first(1)});
    EXPECT_TRUE(NormalEquations(matrix).regular());
}

TEST(KeptPoints, AreTheFinePointsWhereTheCoarseOnesWeighMost) {
    // Uniform cubic: edge points (1/2, 1/2) and vertex points (1/8, 3/4, 1/8); the vertex points are kept.
    const IntervalSystem system = system_of("A->AA");
    const Hierarchy closed(*make_knots(system, {3, Ends::Circular, Word(5)}).knots, 1);
    EXPECT_THAT(kept_points(closed.matrix(0)), ElementsAre(2, 4, 6, 8, 0));
    // Clamped: both ends are kept as well.
    const Hierarchy open(*make_knots(system, {3, Ends::Open, clamped(Word(4), 3)}).knots, 1);
    const std::vector<std::size_t> kept = kept_points(open.matrix(0));
    EXPECT_EQ(kept.front(), 0u);
    EXPECT_EQ(kept.back(), open.size(1) - 1);
}

TEST(KeptPoints, RefuseAMatrixThatForgetsAPoint) {
    const std::vector<double> one{1};
    GatherMatrix matrix;
    matrix.columns = 2;
    matrix.rows = {{0, one}, {0, one}};
    EXPECT_THROW((void)kept_points(matrix), std::invalid_argument);
    matrix.ends = Ends::Circular;
    EXPECT_THROW((void)kept_points(matrix), std::invalid_argument);
    matrix.rows = {{1, one}, {1, one}};
    EXPECT_THROW((void)kept_points(matrix), std::invalid_argument);
}

} // namespace
} // namespace internode
