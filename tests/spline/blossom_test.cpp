// SPDX-License-Identifier: MIT

#include "internode/spline/blossom.h"

#include "tests/fixtures/interval_systems.h"
#include "tests/reference/marsden.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace internode {
namespace {

using reference::polar_power;
using testing::ElementsAre;
using tests::system_of;
using tests::word_of;

std::vector<Number> integers(const std::vector<long>& values) {
    return {values.begin(), values.end()};
}

/// Random local knots: 2d small integers, ascending, repeated often, with a middle interval that is not empty.
std::vector<Number> random_piece(std::mt19937& random, std::size_t d) {
    std::uniform_int_distribution<long> gap(0, 2);
    std::vector<Number> knots{Number(0)};
    for (std::size_t i = 1; i < 2 * d; ++i) knots.push_back(knots.back() + Number(gap(random) + (i == d ? 1 : 0)));
    return knots;
}

TEST(Knots, AreSumsOfLengths) {
    const IntervalSystem fibonacci = system_of("L->SL, S->L");
    const Number phi = fibonacci.ratio();
    EXPECT_THAT(knots(fibonacci, word_of(fibonacci, "L0SL")),
                ElementsAre(Number(0), phi, phi, phi + Number(1), Number(2) * phi + Number(1)));
    EXPECT_THAT(knots(fibonacci, Word{}), ElementsAre(Number(0)));
}

TEST(Blossom, OfALineIsLinear) {
    EXPECT_THAT(blossom_weights(integers({2, 6}), integers({3})), ElementsAre(Rational(3, 4), Rational(1, 4)));
}

TEST(Blossom, AtItsOwnKnotsIsAControlPoint) {
    std::mt19937 random(1);
    for (std::size_t d = 1; d <= 6; ++d) {
        for (int sample = 0; sample < 20; ++sample) {
            const std::vector<Number> local = random_piece(random, d);
            for (std::size_t i = 0; i <= d; ++i) {
                std::vector<Number> unit(d + 1);
                unit[i] = Number(1);
                EXPECT_EQ(blossom_weights(local, std::span(local).subspan(i, d)), unit);
            }
        }
    }
}

TEST(Blossom, IsSymmetricAndAffineInEachArgument) {
    std::mt19937 random(2);
    std::uniform_int_distribution<long> anywhere(-5, 9);
    for (std::size_t d = 2; d <= 5; ++d) {
        for (int sample = 0; sample < 20; ++sample) {
            const PolynomialPiece piece(random_piece(random, d));
            std::vector<Number> arguments;
            for (std::size_t i = 0; i < d; ++i) arguments.emplace_back(anywhere(random));
            const std::vector<Number> weights = piece.weights(arguments);
            std::vector<Number> shuffled = arguments;
            std::shuffle(shuffled.begin(), shuffled.end(), random);
            EXPECT_EQ(piece.weights(shuffled), weights);
            std::vector<Number> less = arguments;
            std::vector<Number> more = arguments;
            less[0] -= Number(3);
            more[0] += Number(3);
            const std::vector<Number> low = piece.weights(less);
            const std::vector<Number> high = piece.weights(more);
            for (std::size_t i = 0; i <= d; ++i) EXPECT_EQ(low[i] + high[i], weights[i] + weights[i]);
        }
    }
}

TEST(Blossom, ReproducesPolynomialsUpToTheDegree) {
    std::mt19937 random(3);
    std::uniform_int_distribution<long> anywhere(-5, 9);
    for (std::size_t d = 1; d <= 6; ++d) {
        for (int sample = 0; sample < 20; ++sample) {
            const std::vector<Number> local = random_piece(random, d);
            std::vector<Number> arguments;
            for (std::size_t i = 0; i < d; ++i) arguments.emplace_back(anywhere(random));
            const std::vector<Number> weights = blossom_weights(local, arguments);
            for (std::size_t m = 0; m <= d; ++m) {
                Number sum;
                for (std::size_t i = 0; i <= d; ++i)
                    sum += weights[i] * polar_power<Number>(std::span(local).subspan(i, d), m);
                EXPECT_EQ(sum, polar_power<Number>(arguments, m));
            }
        }
    }
}

TEST(Blossom, RefusesWhatIsNotAPiece) {
    EXPECT_THROW(PolynomialPiece({}), std::invalid_argument);
    EXPECT_THROW(PolynomialPiece(integers({0, 1, 2})), std::invalid_argument);
    EXPECT_THROW(PolynomialPiece(integers({0, 1, 1, 2})), std::invalid_argument);
    EXPECT_THROW(PolynomialPiece(integers({0, 2, 3, 1})), std::invalid_argument);
    EXPECT_THROW((void)blossom_weights(integers({0, 1}), integers({0, 1})), std::invalid_argument);
    EXPECT_THROW((void)blossom_weights(integers({0, 1}), {}), std::invalid_argument);
}

} // namespace
} // namespace internode
