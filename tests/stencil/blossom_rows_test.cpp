// SPDX-License-Identifier: MIT

#include "internode/stencil/blossom_rows.h"

#include "internode/spline/blossom.h"
#include "tests/fixtures/random_curve.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

namespace internode {
namespace {

/// Of ascending whole knots, the middle two apart.
std::vector<Number> whole_knots(std::size_t degree, tests::Random& random) {
    std::vector<Number> knots;
    long at = 0;
    for (std::size_t i = 0; i < 2 * degree; ++i) {
        knots.emplace_back(at);
        at += static_cast<long>(random.below(4)) + (i + 1 == degree ? 1 : 0);
    }
    return knots;
}

BlossomPiece piece_over(const std::vector<Number>& knots) {
    const std::size_t d = knots.size() / 2;
    BlossomPiece piece{d, {}};
    for (const Number& knot : knots) piece.knots.push_back(to_double_double(knot));
    return piece;
}

struct Made {
    std::vector<double> weights;
    double largest;
};

Made rows_of(const BlossomPiece& piece, PairArray pairs, Isa isa) {
    const std::size_t rows = pairs.hi.size() - piece.degree + 1;
    for (std::size_t i = 0; i < blossom_padding; ++i) pairs.push_back({});
    Made made{std::vector<double>(rows * (piece.degree + 1) + 1, -7), 0};
    made.largest = blossom_rows(piece, pairs, rows, made.weights.data(), isa);
    EXPECT_EQ(made.weights.back(), -7) << "written behind the last row";
    made.weights.pop_back();
    return made;
}

PairArray pairs_of(const std::vector<Number>& numbers) {
    PairArray pairs;
    for (const Number& number : numbers) pairs.push_back(to_double_double(number));
    return pairs;
}

TEST(BlossomRows, AreTheExactBlossomsRoundedInEverySet) {
    tests::Random random(5);
    for (std::size_t degree = 1; degree <= 12; ++degree)
        for (std::size_t rows = 1; rows <= 9; ++rows) {
            const std::vector<Number> knots = whole_knots(degree, random);
            const BlossomPiece piece = piece_over(knots);
            std::vector<Number> arguments; // within the middle interval, ascending
            const Number step = (knots[degree] - knots[degree - 1]) / Number(static_cast<long>(rows + degree));
            for (std::size_t i = 0; i < rows + degree - 1; ++i)
                arguments.push_back(knots[degree - 1] + step * Number(static_cast<long>(i + 1)));
            const Made plain = rows_of(piece, pairs_of(arguments), Isa::Plain);
            const Made best = rows_of(piece, pairs_of(arguments), Isa::Best);
            EXPECT_EQ(std::memcmp(plain.weights.data(), best.weights.data(), plain.weights.size() * sizeof(double)), 0);
            EXPECT_EQ(plain.largest, best.largest);
            EXPECT_GE(plain.largest, 1);
            for (std::size_t row = 0; row < rows; ++row) {
                const std::vector<Number> exact =
                    blossom_weights(knots, std::span<const Number>(arguments).subspan(row, degree));
                for (std::size_t i = 0; i <= degree; ++i)
                    EXPECT_EQ(plain.weights[row * (degree + 1) + i], exact[i].to_double())
                        << "degree " << degree << ", row " << row << " of " << rows;
            }
        }
}

TEST(BlossomRows, SayWhenARowHasNoNumbers) {
    const std::vector<Number> knots{Number(0), Number(1), Number(2), Number(3)};
    const BlossomPiece piece = piece_over(knots);
    for (std::size_t place = 0; place < 9; ++place) {
        PairArray arguments = pairs_of(std::vector<Number>(9, Number(1)));
        arguments.hi[place] = std::numeric_limits<double>::quiet_NaN(); // of one or two rows of eight
        for (const Isa isa : {Isa::Plain, Isa::Best}) EXPECT_TRUE(std::isnan(rows_of(piece, arguments, isa).largest));
    }
}

} // namespace
} // namespace internode
