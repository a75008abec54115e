// SPDX-License-Identifier: MIT

#include "internode/surface/stops.h"

#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/words.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace internode {
namespace {

using namespace tests::letters;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using tests::fibonacci;

Stops stops_of(int degree, Ends ends, Word word) {
    return make_stops(make_knots(fibonacci(), {degree, ends, std::move(word)}).knots.value());
}

TEST(Stops, ARingOfOneStopIsJoinedToNothing) {
    for (const Word& word : {Word{a}, Word{a, o}, Word{o, a}}) {
        const Stops ring = stops_of(2, Ends::Circular, word);
        ASSERT_EQ(ring.stops.size(), 1U);
        EXPECT_THAT(ring.joins, IsEmpty());
    }
    EXPECT_THAT(stops_of(2, Ends::Circular, {a, b}).joins, ElementsAre(Join{0, 1}, Join{1, 0}));
    // Broken at its seam, it has two ends.
    EXPECT_THAT(stops_of(2, Ends::Circular, {a, o, o}).joins, ElementsAre(Join{0, 1}));
}

TEST(Stops, AJoinForEachIntervalOfTheDomain) {
    tests::Random random(5);
    for (const tests::Shape shape : tests::all_shapes)
        for (int degree = 1; degree <= 4; ++degree)
            for (std::size_t letters = 1; letters <= 5; ++letters) {
                const Knots knots = tests::random_curve(random, fibonacci(), degree, shape, letters, 1).knots();
                const Stops made = make_stops(knots);
                const bool one_of_a_ring = knots.ends() == Ends::Circular && made.stops.size() == 1;
                EXPECT_EQ(made.joins.size(), one_of_a_ring ? 0 : letters);
                for (const Join& join : made.joins) {
                    ASSERT_NE(join.from, join.to);
                    EXPECT_FALSE(made.stops[join.to].after_break);
                    const bool goes_on = made.stops[join.from].parameter < made.stops[join.to].parameter;
                    EXPECT_EQ(goes_on, join.to > 0);
                }
            }
}

TEST(Stops, WeightsAreThoseOfPointsOnTheCurve) {
    tests::Random random(6);
    for (const tests::Shape shape : tests::all_shapes)
        for (int degree = 1; degree <= 4; ++degree) {
            const Stops made = make_stops(tests::random_curve(random, fibonacci(), degree, shape, 4, 1).knots());
            for (const Stop& stop : made.stops) {
                double sum = 0;
                for (const double weight : made.position(stop)) sum += weight;
                EXPECT_NEAR(sum, 1, 1e-14) << "positions are affine combinations";
                EXPECT_EQ(made.width, static_cast<std::size_t>(degree) + 1);
            }
        }
}

} // namespace
} // namespace internode
