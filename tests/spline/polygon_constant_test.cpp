// SPDX-License-Identifier: MIT

#include "internode/spline/polygon_constant.h"

#include "internode/spline/blossom.h"
#include "internode/word/factors.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/reference/marsden.h"

#include <gmock/gmock.h>

#include <string>

namespace internode {
namespace {

using reference::polar_power;
using tests::system_of;
using tests::word_of;

TEST(PolygonConstant, OfFibonacciIsExact) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const Number phi = fibonacci.ratio();
    const auto in_phi = [&](const Rational& slope, const Rational& constant) { return slope * phi + Number(constant); };
    const std::vector<Number> expected{
        in_phi(Rational(1, 8), Rational(1, 8)),       in_phi(Rational(1, 6), Rational(1, 6)),
        in_phi(Rational(17, 96), Rational(7, 48)),    in_phi(Rational(11, 50), Rational(4, 25)),
        in_phi(Rational(4, 15), Rational(23, 120)),   in_phi(Rational(43, 147), Rational(59, 294)),
        in_phi(Rational(297, 896), Rational(99, 448))};
    for (int d = 2; d <= 8; ++d)
        EXPECT_EQ(largest_polygon_constant(fibonacci, d).value, expected[static_cast<std::size_t>(d) - 2])
            << "degree " << d;
    EXPECT_EQ(polygon_constant(fibonacci, word_of(fibonacci, "SLL")), expected[2]);
    EXPECT_EQ(polygon_constant(fibonacci, word_of(fibonacci, "LSLL")), expected[3]);
}

TEST(PolygonConstant, OfAUniformSystemGrowsWithTheDegree) {
    const IntervalSystem uniform = system_of("A->AA");
    for (int d = 2; d <= 12; ++d) {
        const PolygonConstant constant = largest_polygon_constant(uniform, d);
        EXPECT_EQ(constant.value, Number(d + 1) / Number(24));
        EXPECT_EQ(constant.word.size(), static_cast<std::size_t>(d) - 1);
    }
}

TEST(PolygonConstant, OfDegreeOneIsZero) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    EXPECT_EQ(largest_polygon_constant(fibonacci, 1).value, Number(0));
    EXPECT_TRUE(largest_polygon_constant(fibonacci, 1).word.empty());
    EXPECT_EQ(polygon_constant(fibonacci, Word{}), Number(0));
}

TEST(PolygonConstant, IsTheDistanceOfAParabola) {
    // s = t²: s(ξ) - v = c s'' with s'' = 2 and v the blossom of t² at the inner knots.
    for (const auto& [name, text] : tests::sample_systems()) {
        const IntervalSystem system = system_of(text);
        for (std::size_t d = 2; d <= 5; ++d) {
            for (const Word& inner : persistent_words(system.rules(), d - 1, 100'000)) {
                const std::vector<Number> inner_knots = knots(system, inner);
                const Number greville = polar_power<Number>(inner_knots, 1);
                EXPECT_EQ(greville * greville - polar_power<Number>(inner_knots, 2),
                          Number(2) * polygon_constant(system, inner))
                    << name;
            }
        }
    }
}

TEST(PolygonConstant, IsTheLargestOverThePersistentWords) {
    for (const char* const text : {"A->AAB, B->A", "A->B, B->BBA", "A->B, B->C, C->AB"}) {
        const IntervalSystem system = system_of(text);
        const PolygonConstant largest = largest_polygon_constant(system, 5);
        EXPECT_EQ(polygon_constant(system, largest.word), largest.value);
        for (const Word& inner : persistent_words(system.rules(), 4, 1000))
            EXPECT_LE(polygon_constant(system, inner), largest.value) << text;
    }
}

TEST(PolygonConstant, DoesNotDependOnTheAxiom) {
    // A curve may start from another word than the axiom; "L" alone has no inner word of degree 4.
    const PolygonConstant expected = largest_polygon_constant(system_of("L->SL, S->L"), 4);
    for (const char* text : {"L->SL, S->L, axiom L", "L->SL, S->L, axiom (S)", "L->SL, S->L, axiom 0 L S 0"}) {
        const PolygonConstant constant = largest_polygon_constant(system_of(text), 4);
        EXPECT_EQ(constant.value, expected.value) << text;
        EXPECT_EQ(constant.word, expected.word) << text;
    }
}

TEST(PolygonConstant, LeavesOutWhatTheAxiomCannotProduce) {
    const IntervalSystem system = system_of("A->AA, B->BB, length B = 100, axiom A");
    EXPECT_EQ(largest_polygon_constant(system, 3).value, Number(1) / Number(6));
}

TEST(PolygonConstant, RefusesMoreWordsThanItsLimit) {
    std::string text;
    for (int i = 0; i <= 1000; ++i) {
        const std::string name = std::string("A").append(std::to_string(i));
        text.append(name).append(" -> ").append(name).append("^2\n");
    }
    EXPECT_THROW((void)largest_polygon_constant(system_of(text), 3), TooManyWords);
}

TEST(PolygonConstant, RefusesDegreeZero) {
    EXPECT_THROW((void)largest_polygon_constant(system_of("A->AA"), 0), std::invalid_argument);
}

} // namespace
} // namespace internode
