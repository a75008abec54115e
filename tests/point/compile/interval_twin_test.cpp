// SPDX-License-Identifier: MIT

#include "internode/point/compile/interval_twin.h"

#include "internode/point/compile/compile.h"
#include "internode/point/compile/grammar_mask.h"
#include "internode/stencil/step_matrix.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/point_systems.h"

#include <gtest/gtest.h>

namespace internode {
namespace {

using tests::bundled_system;
using tests::point_system;

std::optional<IntervalTwin> twin(const PointSystem& system) {
    return interval_twin(compile(system, {many_points}).compiled.value());
}

TEST(IntervalTwin, HasTheAutomatonOfChaikinsAndTheCubicScheme) {
    for (const auto& [name, degree] : {std::pair("s0/18", 2), std::pair("s0/22", 3)}) {
        const std::optional<IntervalTwin> found = twin(bundled_system(name));
        ASSERT_TRUE(found) << name;
        EXPECT_EQ(found->degree, degree) << name;
        EXPECT_EQ(found->moved, 0U) << name;
    }
}

TEST(IntervalTwin, HasTheAutomatonOfLaneRiesenfeldUpToDegree7) {
    // S1 (10) gives a point its own place first. The interval grammar does so at even degrees; at odd ones, n even, it
    // begins with the middle of the interval, and one point is moved.
    for (int n = 0; n <= 6; ++n) {
        const std::optional<IntervalTwin> found = twin(bundled_system("lane-riesenfeld", {2, {{"n", n}}}));
        ASSERT_TRUE(found) << n;
        EXPECT_EQ(found->degree, n + 1);
        EXPECT_EQ(found->moved, n % 2 == 0 ? 1U : 0U) << n;
    }
}

TEST(IntervalTwin, OfOtherProductionsIsSomePointsAway) {
    // S0 section 5: d = 0 gives half of the points of d = 1, which is (18), to the neighbour; d = -1 and 3 whole cells.
    for (const auto& [name, moved] : {std::pair("s0/13", 1U), std::pair("s0/17", 0U), std::pair("s0/20", 0U)}) {
        const std::optional<IntervalTwin> found = twin(bundled_system(name));
        ASSERT_TRUE(found) << name;
        EXPECT_EQ(found->degree, 2);
        EXPECT_EQ(found->moved, moved) << name;
    }
    EXPECT_EQ(twin(bundled_system("s0/23"))->moved, 1U);
}

TEST(Masks, OfTheSameSchemeAreShiftedByAStatedNumberOfPoints) {
    // p'_k of the first is p'_{k + shift} of the second: a cyclic shift of the output.
    const auto first = [](const char* name) { return uniform_mask(bundled_system(name))->first; };
    const auto coefficients = [](const char* name) { return uniform_mask(bundled_system(name))->coefficients; };
    for (const auto& [name, shift] : {std::pair("s0/17", 1), std::pair("s0/18", -1), std::pair("s0/20", -5)}) {
        EXPECT_EQ(coefficients(name), coefficients("s0/13")) << name;
        EXPECT_EQ(first(name) - first("s0/13"), shift) << name;
    }
    EXPECT_EQ(coefficients("s0/23"), coefficients("s0/22"));
    EXPECT_EQ(first("s0/23") - first("s0/22"), 1);
    EXPECT_EQ(coefficients("s0/26"), coefficients("s0/25"));
}

TEST(IntervalTwin, IsNoneForOtherSchemes) {
    EXPECT_FALSE(twin(bundled_system("s0/25")));
    EXPECT_FALSE(twin(bundled_system("six-point")));
    EXPECT_FALSE(twin(point_system("points\nring\nP(u) < P(v) -> P(2/5 u + 3/5 v) P(3/5 u + 2/5 v)\n")));
}

TEST(IntervalTwin, KnowsArity3) {
    const std::optional<IntervalTwin> found =
        twin(point_system("points\nring\nP(v) > P(w) -> P(v) P(2/3 v + 1/3 w) P(1/3 v + 2/3 w)\n"));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->arity, 3U);
    EXPECT_EQ(found->degree, 1);
}

TEST(IntervalTwin, OpenChaikinIsTheClampedQuadratic) {
    // S0 (28)-(33), (34)-(36) and matrix (27) against `A -> A A` at degree 2 over 0^2 A^(n-2) 0^2.
    const IntervalSystem bisection = tests::system_of("A->AA");
    for (std::size_t n = 4; n <= 9; ++n) {
        Word word(n + 2, to_symbol(0));
        word[0] = word[1] = word[n] = word[n + 1] = zero_interval;
        const StepMatrix matrix = step_matrix(bisection, 2, word, Ends::Open);
        RationalMatrix expected{n, RationalMatrix{}.rows};
        expected.rows.resize(matrix.rows);
        const NumberField rationals;
        for (const StepMatrix::Entry& entry : matrix.entries)
            expected.rows[entry.row].push_back({entry.column, entry.weight.coefficients(rationals).front()});
        for (const char* name : {"s0/28-33", "s0/34-36"}) {
            const auto made = point_matrix(bundled_system(name), n);
            EXPECT_EQ(std::get<RationalMatrix>(made), expected) << name << ' ' << n;
        }
    }
}

} // namespace
} // namespace internode
