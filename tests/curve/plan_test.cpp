// SPDX-License-Identifier: MIT
//
// stencil/plan.h against curve/refinement.h, its slow and obvious reference.

#include "internode/curve/refinement.h"
#include "internode/stencil/levels_plan.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/numbers.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/small_grammars.h"
#include "tests/fixtures/stride.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <numeric>
#include <oneapi/tbb/global_control.h>
#include <span>

namespace internode {
namespace {

using tests::all_shapes;
using tests::bundled_systems;
using tests::curve_of;
using tests::largest_difference;
using tests::Random;
using tests::random_curve;
using tests::small_grammars;
using tests::system_of;

/// Random points over a word that goes round, or with d zeros at each end.
Curve curve_over(const IntervalSystem& system, int degree, Ends ends, std::size_t letters, std::size_t dimension,
                 std::uint32_t seed) {
    Random random(seed);
    Word symbols;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i)
        if (system.occurs(to_symbol(i))) symbols.push_back(to_symbol(i));
    Word word;
    for (std::size_t i = 0; i < letters; ++i) word.push_back(symbols[random.below(symbols.size())]);
    std::size_t points = letters;
    if (ends == Ends::Open) {
        word = clamped(word, degree);
        points += static_cast<std::size_t>(degree);
    }
    CurveData data{degree, ends, word, dimension, {}};
    for (std::size_t i = 0; i < points * dimension; ++i) data.points.push_back(random.coordinate());
    return curve_of(system, std::move(data));
}

std::vector<double> step_by_step(const Curve& curve, int steps) {
    Refinement refinement(curve);
    for (int step = 0; step < steps; ++step) refinement.step();
    return refinement.curve().points();
}

std::vector<double> planned(const Curve& curve, int steps, const PlanOptions& plan_options = {},
                            const ApplyOptions& options = {}) {
    const RefinementPlan plan = refinement_plan(curve.knots(), steps, plan_options);
    std::vector<double> out(plan.output_size() * curve.dimension());
    plan.apply<double>(curve.points(), curve.dimension(), out, options);
    return out;
}

bool same_bytes(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Fuses as much as it can, however small the curve.
PlanOptions eager() {
    PlanOptions options;
    options.table_bytes = std::size_t{1} << 24;
    options.points_per_row = 0;
    options.most_fused_steps = 1000;
    return options;
}

PlanOptions single_steps() {
    PlanOptions options;
    options.most_fused_steps = 1;
    return options;
}

/// The grammars in shares, so that several run side by side.
constexpr std::size_t shares = 4;

class PlanOfSmallGrammars : public testing::TestWithParam<std::size_t> {};

TEST_P(PlanOfSmallGrammars, IsTheStepByStepRefinement) {
    const std::vector<IntervalGrammar> grammars = small_grammars(3, 3);
    const std::size_t step = tests::stride(shares);
    std::size_t valid = 0;
    for (std::size_t i = GetParam(); i < grammars.size(); i += step) {
        const Verdict verdict = validate(grammars[i]);
        if (!verdict.system) continue;
        const auto seed = static_cast<std::uint32_t>(GetParam() + valid++);
        const Ends ends = seed % 2 == 0 ? Ends::Circular : Ends::Open;
        const Curve curve = curve_over(*verdict.system, 1 + static_cast<int>(seed % 5), ends, 1 + seed % 6, 2, seed);
        const std::vector<double> expected = step_by_step(curve, 3);
        EXPECT_TRUE(same_bytes(planned(curve, 3, single_steps()), expected)) << "grammar " << i;
        EXPECT_LE(largest_difference(planned(curve, 3, eager()), expected), 1e-14) << "grammar " << i;
    }
    EXPECT_GT(valid, grammars.size() / step / 4);
}

INSTANTIATE_TEST_SUITE_P(All, PlanOfSmallGrammars, testing::Range(std::size_t{0}, shares));

TEST(Plan, IsTheStepByStepRefinementForRandomCurves) {
    Random random(3);
    for (int time = 0; time < 60; ++time)
        for (const auto& shape : all_shapes) {
            const int degree = 1 + static_cast<int>(random.below(6));
            const Curve curve =
                random_curve(random, tests::random_system(random), degree, shape, 6, 1 + random.below(5));
            const std::vector<double> expected = step_by_step(curve, 4);
            EXPECT_TRUE(same_bytes(planned(curve, 4, single_steps()), expected));
            EXPECT_LE(largest_difference(planned(curve, 4), expected), 1e-13);
            EXPECT_LE(largest_difference(planned(curve, 4, eager()), expected), 1e-13);
        }
}

TEST(Plan, FusesManyStepsOfBundledGrammars) {
    for (const auto& [name, system] : bundled_systems()) {
        const Curve curve = curve_over(system, 3, Ends::Circular, 7, 3, 5);
        int steps = 0;
        while (refined_size(curve, static_cast<std::uint64_t>(steps) + 1, 20'000).exceeded == false) ++steps;
        const RefinementPlan plan = refinement_plan(curve.knots(), steps, eager());
        EXPECT_EQ(plan.blocks(), std::vector<int>{steps}) << name;
        EXPECT_LE(largest_difference(planned(curve, steps, eager()), step_by_step(curve, steps)), 1e-13) << name;
    }
}

TEST(Plan, GivesTheSameBytesForAnyThreadsAndGrain) {
    // More threads than this machine may have cores.
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 16);
    const IntervalSystem system = system_of("L->SL, S->L");
    for (const Ends ends : {Ends::Circular, Ends::Open})
        for (const std::size_t dimension : {1, 2, 3, 5}) {
            const Curve curve = curve_over(system, 3, ends, 60, dimension, 7);
            for (const PlanOptions& plan : {PlanOptions{}, eager(), single_steps()}) {
                const std::vector<double> expected = planned(curve, 11, plan);
                for (const int threads : {1, 2, 3, 7, 16, 0})
                    for (const std::size_t grain : {1, 1000, 65536})
                        EXPECT_TRUE(same_bytes(planned(curve, 11, plan, {threads, Isa::Best, grain}), expected))
                            << threads << " threads, grain " << grain;
                EXPECT_TRUE(same_bytes(planned(curve, 11, plan, {1, Isa::Plain, 500}), expected));
            }
        }
}

TEST(Plan, GivesTheSameBytesForAnyStores) {
    const IntervalSystem system = system_of("L->SL, S->L");
    for (const std::size_t dimension : {1, 2, 3, 4, 7, 17, 128, 129})
        for (const int degree : {1, 3, 8}) {
            const Curve curve = curve_over(system, degree, Ends::Circular, 12, dimension, 7);
            for (const PlanOptions& plan : {PlanOptions{}, eager(), single_steps()}) {
                const std::vector<double> expected =
                    planned(curve, 6, plan, {.isa = Isa::Plain, .stores = Stores::Cached});
                for (const Isa isa : {Isa::Plain, Isa::Avx2})
                    for (const std::size_t grain : {1, 1000, 65536})
                        EXPECT_TRUE(
                            same_bytes(planned(curve, 6, plan,
                                               {.threads = 2, .isa = isa, .grain = grain, .stores = Stores::Streamed}),
                                       expected))
                            << dimension << " coordinates, degree " << degree << ", grain " << grain;
            }
        }
}

TEST(Plan, GivesTheSameFloatsAtAnyAddressForAnyStores) {
    const Curve curve = curve_over(system_of("L->SL, S->L"), 3, Ends::Circular, 30, 3, 9);
    const RefinementPlan plan = refinement_plan(curve.knots(), 7);
    const std::vector<float> points(curve.points().begin(), curve.points().end());
    std::vector<float> expected(plan.output_size() * 3);
    plan.apply<float>(points, 3, expected, {.stores = Stores::Cached});
    for (std::size_t shift = 0; shift < 16; ++shift) {
        std::vector<float> memory(expected.size() + 32, -1.0F);
        const std::span<float> out = std::span(memory).subspan(shift, expected.size());
        plan.apply<float>(points, 3, out, {.grain = 1000, .stores = Stores::Streamed});
        EXPECT_EQ(std::memcmp(out.data(), expected.data(), out.size_bytes()), 0) << shift;
        EXPECT_EQ(std::ranges::count(memory, -1.0F), 32) << shift;
    }
}

TEST(Plan, KeepsTheBytesOfLargeOutputsInAnySet) {
    // Larger than what is measured, and by two threads.
    const Curve curve = curve_over(system_of("A->AA"), 3, Ends::Circular, 9, 3, 8);
    const int steps = 18;
    const std::vector<double> measured = planned(curve, steps);
    EXPECT_TRUE(same_bytes(measured, planned(curve, steps, {}, {2, Isa::Plain, 12345})));
    EXPECT_TRUE(same_bytes(measured, planned(curve, steps, {}, {.stores = Stores::Cached})));
    EXPECT_TRUE(same_bytes(measured, planned(curve, steps, {}, {.stores = Stores::Streamed})));
}

TEST(Plan, RefinesFloatsToTheirPrecision) {
    const Curve curve = curve_over(system_of("L->SL, S->L"), 4, Ends::Circular, 30, 3, 9);
    const RefinementPlan plan = refinement_plan(curve.knots(), 8);
    const std::vector<float> points(curve.points().begin(), curve.points().end());
    std::vector<float> out(plan.output_size() * 3);
    plan.apply<float>(points, 3, out);
    const std::vector<double> expected = planned(curve, 8);
    for (std::size_t i = 0; i < out.size(); ++i) EXPECT_NEAR(out[i], expected[i], 1e-6);
    std::vector<float> plain(out.size());
    plan.apply<float>(points, 3, plain, {3, Isa::Plain, 100});
    EXPECT_EQ(std::memcmp(plain.data(), out.data(), out.size() * sizeof(float)), 0);
}

TEST(Plan, UsesStatesOfOneTwoAndFourBytes) {
    // n symbols that never meet again: 2d-1 windows and more for each.
    for (const std::size_t symbols : {3, 80, 300}) {
        std::string text;
        for (std::size_t i = 0; i < symbols; ++i)
            text += "A" + std::to_string(i) + " -> A" + std::to_string(i) + " A" + std::to_string(i) + "\n";
        const IntervalSystem system = system_of("intervals many\n" + text);
        Word word;
        for (std::size_t i = 0; i < symbols; ++i) word.push_back(to_symbol(i));
        CurveData data{3, Ends::Circular, word, 2, {}};
        for (std::size_t i = 0; i < 2 * symbols; ++i) data.points.push_back(std::sin(static_cast<double>(i)));
        const Curve curve = curve_of(system, std::move(data));
        EXPECT_TRUE(same_bytes(planned(curve, 3, single_steps()), step_by_step(curve, 3))) << symbols;
    }
}

TEST(Plan, SaysItsSizes) {
    const Curve curve = curve_over(system_of("L->SL, S->L"), 2, Ends::Circular, 30, 3, 9);
    const RefinementPlan plan = refinement_plan(curve.knots(), 12);
    EXPECT_EQ(plan.input_size(), 30U);
    EXPECT_EQ(plan.output_size(), refined_size(curve, 12, 1'000'000).points);
    const std::vector<int> blocks = plan.blocks();
    EXPECT_EQ(std::accumulate(blocks.begin(), blocks.end(), 0), 12);
    EXPECT_EQ(plan.sizes().size(), 13U);
}

TEST(Plan, NeedsLittleMemoryBesideTheOutput) {
    for (const auto& [name, system] : bundled_systems()) {
        const Curve curve = curve_over(system, 3, Ends::Circular, 40, 3, 5);
        int steps = 0;
        while (!refined_size(curve, static_cast<std::uint64_t>(steps) + 1, 3'000'000).exceeded) ++steps;
        const RefinementPlan plan = refinement_plan(curve.knots(), steps);
        EXPECT_LE(plan.work_bytes(3, sizeof(double)), plan.output_size() * 3 * sizeof(double) * 15 / 100) << name;
    }
}

TEST(Plan, AdvancesARefinementWithItsStates) {
    for (const Ends ends : {Ends::Circular, Ends::Open}) {
        const Curve curve = curve_over(system_of("A->AB, B->AC, C->A"), 3, ends, 9, 2, 3);
        Refinement slow(curve);
        for (int step = 0; step < 7; ++step) slow.step();
        Refinement fast(curve);
        fast.advance(3);
        fast.advance(0);
        fast.advance(4);
        EXPECT_EQ(fast.states(), slow.states());
        EXPECT_EQ(fast.curve().word(), slow.curve().word());
        EXPECT_EQ(fast.curve().step(), 7);
        EXPECT_LE(largest_difference(fast.curve().points(), slow.curve().points()), 1e-14);
        EXPECT_THROW(fast.advance(-1), std::invalid_argument);
    }
}

TEST(Plan, AppliesToManyPolygonsAtOnce) {
    const IntervalSystem system = system_of("L->SL, S->L");
    const Curve first = curve_over(system, 3, Ends::Circular, 20, 2, 1);
    std::vector<double> points;
    std::vector<double> expected;
    const RefinementPlan plan = refinement_plan(first.knots(), 6);
    for (const double scale : {1.0, -2.0, 0.5}) {
        std::vector<double> polygon = first.points();
        for (double& coordinate : polygon) coordinate *= scale;
        std::vector<double> fine(plan.output_size() * 2);
        plan.apply<double>(polygon, 2, fine);
        points.insert(points.end(), polygon.begin(), polygon.end());
        expected.insert(expected.end(), fine.begin(), fine.end());
    }
    for (const int threads : {1, 2, 0}) {
        std::vector<double> out(expected.size());
        plan.apply_each<double>(points, 3, 2, out, {threads});
        EXPECT_TRUE(same_bytes(out, expected));
    }
    std::vector<double> out(expected.size());
    EXPECT_THROW(plan.apply_each<double>(points, 2, 2, out), std::invalid_argument);
    EXPECT_THROW(plan.apply_each<double>(points, 0, 2, out), std::invalid_argument);
}

TEST(LevelsPlan, GivesEveryLevelOfTheStepByStepRefinement) {
    Random random(4);
    for (int time = 0; time < tests::times(20, 3); ++time)
        for (const auto& shape : all_shapes) {
            const int degree = 1 + static_cast<int>(random.below(6));
            const Curve curve = random_curve(random, tests::random_system(random), degree, shape, 6, 2);
            for (const PlanOptions& options : {PlanOptions{}, eager(), single_steps()}) {
                const LevelsPlan plan(curve.system(), degree, curve.word(), curve.ends(), 4, options);
                std::vector<double> out(plan.output_size() * 2);
                plan.apply<double>(curve.points(), 2, out, {time % 3});
                for (int level = 1; level <= 4; ++level) {
                    const std::vector<double> expected = step_by_step(curve, level);
                    const auto first = out.begin() + static_cast<std::ptrdiff_t>(plan.start(level) * 2);
                    const std::vector<double> points(first, first + static_cast<std::ptrdiff_t>(expected.size()));
                    EXPECT_LE(largest_difference(points, expected), 1e-13) << "level " << level;
                }
            }
        }
}

TEST(LevelsPlan, EndsWithTheBytesOfThePlan) {
    const Curve curve = curve_over(system_of("L->SL, S->L"), 3, Ends::Circular, 60, 3, 7);
    const LevelsPlan levels(curve.system(), 3, curve.word(), curve.ends(), 11);
    std::vector<double> out(levels.output_size() * 3);
    levels.apply<double>(curve.points(), 3, out);
    const std::vector<double> last(out.begin() + static_cast<std::ptrdiff_t>(levels.start(11) * 3), out.end());
    EXPECT_TRUE(same_bytes(last, planned(curve, 11)));
}

TEST(LevelsPlan, RefusesNoStepsAndWrongSizes) {
    const Curve curve = curve_over(system_of("L->SL, S->L"), 2, Ends::Circular, 5, 3, 9);
    EXPECT_THROW(LevelsPlan(curve.system(), 2, curve.word(), curve.ends(), 0), std::invalid_argument);
    const LevelsPlan plan(curve.system(), 2, curve.word(), curve.ends(), 2);
    EXPECT_THROW((void)plan.start(3), std::out_of_range);
    const std::vector<double> points(plan.input_size() * 3 + 3);
    std::vector<double> out(plan.output_size() * 3 + 3);
    for (std::size_t in = 0; in <= points.size(); ++in)
        for (std::size_t made = plan.output_size() * 3 - 3; made <= out.size(); ++made) {
            const auto apply = [&] { plan.apply<double>(std::span(points).first(in), 3, std::span(out).first(made)); };
            if (in == plan.input_size() * 3 && made == plan.output_size() * 3)
                EXPECT_NO_THROW(apply());
            else
                EXPECT_THROW(apply(), std::invalid_argument) << in << ' ' << made;
        }
    EXPECT_THROW(plan.apply<double>(points, 0, out), std::invalid_argument);
}

TEST(Plan, OfNoStepsCopies) {
    const Curve curve = curve_over(system_of("L->SL, S->L"), 2, Ends::Circular, 5, 3, 9);
    EXPECT_EQ(planned(curve, 0), curve.points());
    EXPECT_TRUE(refinement_plan(curve.knots(), 0).blocks().empty());
}

TEST(Plan, RefusesWrongSizes) {
    const Curve curve = curve_over(system_of("L->SL, S->L"), 2, Ends::Circular, 5, 3, 9);
    EXPECT_THROW((void)refinement_plan(curve.knots(), -1), std::invalid_argument);
    const RefinementPlan plan = refinement_plan(curve.knots(), 2);
    std::vector<double> out(plan.output_size() * 3);
    const std::vector<double> few(3);
    EXPECT_THROW(plan.apply<double>(few, 3, out), std::invalid_argument);
    EXPECT_THROW(plan.apply<double>(curve.points(), 0, out), std::invalid_argument);
    EXPECT_THROW(plan.apply<double>(curve.points(), 3, std::span(out).first(3)), std::invalid_argument);
    PlanOptions few_states;
    few_states.state_limit = 2;
    EXPECT_THROW((void)refinement_plan(curve.knots(), 2, few_states), TooManyStates);
    EXPECT_THROW((void)refinement_plan(curve.knots(), 1000), std::length_error);
}

} // namespace
} // namespace internode
