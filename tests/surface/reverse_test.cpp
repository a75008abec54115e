// SPDX-License-Identifier: MIT

#include "internode/surface/reverse.h"

#include "internode/surface/refinement.h"
#include "tests/fixtures/random_grid.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

namespace internode {
namespace {

using tests::fibonacci;
using tests::Random;
using tests::random_grid;
using tests::random_knots;
using tests::Shape;

constexpr Shape whole_shapes[] = {Shape::Closed, Shape::Clamped};

/// A random fine grid over the hierarchy.
std::vector<double> random_points(Random& random, const GridHierarchy& hierarchy, std::size_t dimension) {
    const std::size_t size =
        refined_knots(hierarchy.u, hierarchy.levels_u).size() * refined_knots(hierarchy.v, hierarchy.levels_v).size();
    std::vector<double> points(size * dimension);
    for (double& coordinate : points) coordinate = random.coordinate();
    return points;
}

GridHierarchy random_hierarchy(Random& random, Shape u, Shape v, int degree) {
    return {random_knots(random, fibonacci(), degree, u, 4), random_knots(random, fibonacci(), 5 - degree, v, 5), 3, 2};
}

TEST(GridReverse, RecomposesAnyFineGrid) {
    Random random(1);
    for (const Shape u : whole_shapes)
        for (const Shape v : whole_shapes)
            for (int degree = 1; degree <= 4; ++degree)
                for (const ReverseMethod method : {ReverseMethod::LeastSquares, ReverseMethod::Local}) {
                    const GridHierarchy hierarchy = random_hierarchy(random, u, v, degree);
                    const std::vector<double> fine = random_points(random, hierarchy, 3);
                    const ReverseOptions options{method, 5};
                    const std::vector<double> coefficients = decomposed(hierarchy, 3, fine, options);
                    ASSERT_EQ(coefficients.size(), fine.size());
                    const std::vector<double> again = recomposed(hierarchy, 3, coefficients, options);
                    ASSERT_EQ(again.size(), fine.size());
                    for (std::size_t i = 0; i < fine.size(); ++i) ASSERT_NEAR(again[i], fine[i], 1e-12);
                }
}

TEST(GridReverse, OfARefinedGridIsTheGridWithoutDetails) {
    Random random(2);
    for (const Shape u : whole_shapes)
        for (const Shape v : whole_shapes) {
            const GridHierarchy hierarchy = random_hierarchy(random, u, v, 3);
            const Grid coarse = random_grid(random, hierarchy.u, hierarchy.v, 2, false);
            const Grid fine = refine(coarse, hierarchy.levels_u, hierarchy.levels_v);
            const std::vector<double> coefficients = decomposed(hierarchy, 2, fine.points());
            for (std::size_t i = 0; i < fine.u().size(); ++i)
                for (std::size_t j = 0; j < 2 * fine.v().size(); ++j) {
                    const bool kept = i < coarse.u().size() && j < 2 * coarse.v().size();
                    const double expected = kept ? coarse.points()[i * 2 * coarse.v().size() + j] : 0;
                    ASSERT_NEAR(coefficients[i * 2 * fine.v().size() + j], expected, 1e-12);
                }
        }
}

TEST(GridReverse, WithoutDetailsIsTheRefinementOfTheCoarseGrid) {
    Random random(3);
    const GridHierarchy hierarchy = random_hierarchy(random, Shape::Clamped, Shape::Closed, 2);
    std::vector<double> coefficients = decomposed(hierarchy, 1, random_points(random, hierarchy, 1));
    const std::size_t columns = refined_knots(hierarchy.v, hierarchy.levels_v).size();
    std::vector<double> coarse;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        if (k / columns < hierarchy.u.size() && k % columns < hierarchy.v.size())
            coarse.push_back(coefficients[k]);
        else
            coefficients[k] = 0;
    }
    const Grid fine = refine(tests::grid_of({hierarchy.u, hierarchy.v, 1, false, coarse}), 3, 2);
    const std::vector<double> approximation = recomposed(hierarchy, 1, coefficients);
    for (std::size_t k = 0; k < coefficients.size(); ++k) EXPECT_NEAR(approximation[k], fine.points()[k], 1e-12);
}

TEST(GridReverse, RefusesOtherSizes) {
    Random random(4);
    GridHierarchy hierarchy = random_hierarchy(random, Shape::Closed, Shape::Closed, 2);
    std::vector<double> points = random_points(random, hierarchy, 1);
    EXPECT_THROW((void)decomposed(hierarchy, 0, points), std::invalid_argument);
    EXPECT_THROW((void)decomposed(hierarchy, 2, points), std::invalid_argument);
    hierarchy.levels_v = -1;
    EXPECT_THAT([&] { (void)recomposed(hierarchy, 1, points); },
                testing::ThrowsMessage<std::invalid_argument>("a negative number of levels"));
    hierarchy.levels_v = 2;
    points.pop_back();
    EXPECT_THROW((void)recomposed(hierarchy, 1, points), std::invalid_argument);
    std::vector<double> one_more = random_points(random, hierarchy, 2);
    one_more.push_back(0);
    EXPECT_THROW((void)recomposed(hierarchy, 2, one_more), std::invalid_argument);
}

} // namespace
} // namespace internode
