// SPDX-License-Identifier: MIT

#include "internode/surface/refinement.h"

#include "internode/surface/grid_plan.h"
#include "tests/fixtures/random_grid.h"
#include "tests/fixtures/small_grammars.h"
#include "tests/fixtures/stride.h"
#include "tests/fixtures/words.h"
#include "tests/reference/separable_refinement.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace internode {
namespace {

using namespace tests::letters;
using reference::separably_refined;
using tests::all_shapes;
using tests::fibonacci;
using tests::Random;
using tests::random_grid;
using tests::random_knots;
using tests::Shape;

const std::size_t pair_stride = tests::stride(17);
const std::size_t mix_stride = tests::stride();

/// Every entry within 1e-13 of the expected one: fused steps round differently in the last bits.
void expect_near(const std::vector<double>& actual, const std::vector<double>& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) ASSERT_NEAR(actual[i], expected[i], 1e-13) << "coordinate " << i;
}

std::vector<IntervalSystem> small_systems() {
    std::vector<IntervalSystem> systems;
    for (const IntervalGrammar& grammar : tests::small_grammars(2, 3))
        if (const Verdict verdict = validate(grammar); verdict.system) systems.push_back(*verdict.system);
    return systems;
}

TEST(GridRefinement, IsSeparableForPairsOfAllSmallGrammars) {
    const std::vector<IntervalSystem> systems = small_systems();
    ASSERT_GT(systems.size(), 50u);
    Random random(1);
    std::size_t pairs = 0;
    for (std::size_t pair = 0; pair < systems.size() * systems.size(); pair += pair_stride, ++pairs) {
        const IntervalSystem& first = systems[pair / systems.size()];
        const IntervalSystem& second = systems[pair % systems.size()];
        const int degree_u = 1 + static_cast<int>(pairs % 4);
        const int degree_v = 1 + static_cast<int>(pairs / 4 % 4);
        const Shape shape_u = all_shapes[pairs / 16 % 6];
        const Shape shape_v = all_shapes[random.below(6)];
        const Grid grid = random_grid(random, random_knots(random, first, degree_u, shape_u, 1 + random.below(4)),
                                      random_knots(random, second, degree_v, shape_v, 1 + random.below(4)),
                                      1 + random.below(3), false);
        expect_near(refine(grid, 2, 1).points(), separably_refined(grid, 2, 1));
    }
    EXPECT_GT(pairs, tests::in_full() ? 100u : 2u);
}

TEST(GridRefinement, IsSeparableForAllMixesOfEndsAndDegrees) {
    Random random(2);
    std::size_t mixes = 0;
    tests::Compared compared;
    for (int degree = 1; degree <= 4; ++degree)
        for (const Shape u : all_shapes)
            for (const Shape v : all_shapes) {
                if (mixes++ % mix_stride != 0) continue;
                const Grid grid = random_grid(random, random_knots(random, fibonacci(), degree, u, 3),
                                              random_knots(random, fibonacci(), 5 - degree, v, 2), 3, false);
                const Grid fine = refine(grid, 1, 3);
                expect_near(fine.points(), separably_refined(grid, 1, 3));
                EXPECT_EQ(fine.u().word(), refined_knots(grid.u(), 1).word());
                EXPECT_EQ(fine.v().word(), refined_knots(grid.v(), 3).word());
                EXPECT_EQ(fine.size(), fine.u().size() * fine.v().size());
                EXPECT_EQ(fine.u().step(), 1);
                EXPECT_EQ(fine.v().step(), 3);
                ++compared;
            }
}

TEST(GridRefinement, StepsOneByOneAreStepsAtOnce) {
    Random random(3);
    const Grid grid = random_grid(random, random_knots(random, fibonacci(), 3, Shape::ClampedWithZeros, 3),
                                  random_knots(random, fibonacci(), 2, Shape::Closed, 3), 3, true);
    expect_near(refine(refine(refine(grid, 2, 0), 0, 3), 1, 1).points(), refine(grid, 3, 4).points());
    EXPECT_EQ(refine(grid, 0, 0).points(), grid.points());
}

TEST(GridRefinement, HasTheSameBytesForAnyNumberOfThreads) {
    Random random(7);
    const Grid grid = random_grid(random, random_knots(random, fibonacci(), 3, Shape::Closed, 5),
                                  random_knots(random, fibonacci(), 2, Shape::Clamped, 4), 3, false);
    const std::vector<double> alone = refine(grid, 5, 6).points();
    for (const int threads : {2, 3, 7})
        for (const std::size_t grain : {1u, 100u, 65536u}) {
            const Grid fine = refine(grid, 5, 6, {.threads = threads, .isa = Isa::Best, .grain = grain});
            EXPECT_EQ(fine.points(), alone) << threads << " threads, grain " << grain;
        }
}

TEST(GridRefinement, KeepsWeightsPositiveAndTheRationalFlag) {
    Random random(4);
    for (const Shape shape : all_shapes) {
        const Grid grid = random_grid(random, random_knots(random, fibonacci(), 2, shape, 3),
                                      random_knots(random, fibonacci(), 3, Shape::Clamped, 2), 4, true);
        const Grid fine = refine(grid, 2, 2);
        EXPECT_TRUE(fine.rational());
        for (std::size_t i = 3; i < fine.points().size(); i += 4) EXPECT_GT(fine.points()[i], 0);
    }
}

TEST(GridRefinement, IsTheRefinementOfItsTranspose) {
    Random random(5);
    const Grid grid = random_grid(random, random_knots(random, fibonacci(), 3, Shape::Open, 2),
                                  random_knots(random, fibonacci(), 2, Shape::Closed, 4), 2, false);
    const auto transposed = [](const Grid& original) {
        std::vector<double> points;
        for (std::size_t j = 0; j < original.v().size(); ++j)
            for (std::size_t i = 0; i < original.u().size(); ++i)
                for (std::size_t c = 0; c < 2; ++c)
                    points.push_back(original.points()[(i * original.v().size() + j) * 2 + c]);
        return tests::grid_of({original.v(), original.u(), 2, false, points});
    };
    expect_near(refine(transposed(grid), 1, 2).points(), transposed(refine(grid, 2, 1)).points());
}

TEST(GridRefinement, PredictsItsSize) {
    Random random(6);
    for (const Shape u : all_shapes)
        for (const Shape v : {Shape::Closed, Shape::Clamped}) {
            const Grid grid = random_grid(random, random_knots(random, fibonacci(), 2, u, 2),
                                          random_knots(random, fibonacci(), 3, v, 1), 1, false);
            for (int step = 0; step < 5; ++step) {
                const Grid fine = refine(grid, step, 4 - step);
                const GridSize size = refined_size(grid, static_cast<std::uint64_t>(step),
                                                   static_cast<std::uint64_t>(4 - step), 1'000'000);
                EXPECT_FALSE(size.exceeded);
                EXPECT_EQ(size.rows, fine.u().size());
                EXPECT_EQ(size.columns, fine.v().size());
                EXPECT_EQ(size.points, fine.size());
            }
        }
}

TEST(GridRefinement, RefusesToCountForEver) {
    const Knots knots = make_knots(fibonacci(), {2, Ends::Circular, {a, b}}).knots.value();
    const Grid grid = tests::grid_of({knots, knots, 1, false, {1, 2, 3, 4}});
    EXPECT_TRUE(refined_size(grid, 1'000'000'000, 0, 100'000'000).exceeded);
    EXPECT_TRUE(refined_size(grid, 0, 1'000'000'000, 100'000'000).exceeded);
    // 2 by 2 points, then 3 by 3: each direction alone is within 8.
    EXPECT_FALSE(refined_size(grid, 1, 1, 9).exceeded);
    EXPECT_TRUE(refined_size(grid, 1, 1, 8).exceeded);
    const std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
    const GridSize saturated = refined_size(grid, 88, 88, all);
    EXPECT_EQ(saturated.points, all);
    EXPECT_EQ(saturated.bytes, all);
}

TEST(GridRefinement, RefusesNegativeSteps) {
    const Knots knots = make_knots(fibonacci(), {2, Ends::Circular, {a}}).knots.value();
    const Grid grid = tests::grid_of({knots, knots, 1, false, {1}});
    EXPECT_THROW((void)refine(grid, -1, 0), std::invalid_argument);
    EXPECT_THROW((void)refine(grid, 0, -1), std::invalid_argument);
}

TEST(GridPlan, GivesTheSameBytesForAnyThreadsAndSet) {
    Random random(11);
    const Grid grid = random_grid(random, random_knots(random, fibonacci(), 3, Shape::Closed, 5),
                                  random_knots(random, fibonacci(), 2, Shape::Clamped, 4), 3, false);
    const GridPlan plan(grid.u(), grid.v(), 5, 6);
    EXPECT_EQ(plan.input_rows() * plan.input_columns(), grid.size());
    std::vector<double> expected(plan.output_rows() * plan.output_columns() * 3);
    plan.apply(grid.points(), 3, expected);
    for (const ApplyOptions& options : {ApplyOptions{2}, ApplyOptions{0, Isa::Plain, 100}}) {
        std::vector<double> out(expected.size());
        plan.apply(grid.points(), 3, out, options);
        EXPECT_EQ(out, expected);
    }
    EXPECT_THROW(plan.apply(grid.points(), 2, expected), std::invalid_argument);
}

TEST(GridPlan, HoldsWhatTheLastBlockReads) {
    Random random(12);
    const Knots u = random_knots(random, fibonacci(), 3, Shape::Closed, 5);
    const Knots v = random_knots(random, fibonacci(), 2, Shape::Clamped, 4);
    PlanOptions options;
    options.points_per_row = 1;
    std::size_t uneven = 0;
    for (int steps = 1; steps <= 12; ++steps) {
        const RefinementPlan along_u = refinement_plan(u, steps, options);
        const std::vector<int> blocks = along_u.blocks();
        const std::uint64_t rows = along_u.sizes().at(static_cast<std::size_t>(steps - blocks.back()));
        const GridPlan plan(u, v, steps, 2);
        EXPECT_EQ(plan.work_bytes(3), rows * (plan.input_columns() + plan.output_columns()) * 3 * sizeof(double));
        uneven += blocks.front() != blocks.back() ? 1U : 0U;
    }
    EXPECT_GT(uneven, 0U);
}

} // namespace
} // namespace internode
