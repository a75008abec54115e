// SPDX-License-Identifier: MIT

#include "internode/curve/deviation.h"

#include "tests/fixtures/random_curve.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;

std::vector<double> random_lengths(tests::Random& random, std::size_t degree) {
    std::vector<double> lengths(2 * degree - 1);
    for (double& length : lengths) length = random.below(4) == 0 ? 0 : random.coordinate() + 1.1;
    lengths[degree - 1] = random.coordinate() + 1.1;
    return lengths;
}

/// ξ_{j-d} … ξ_j in the parameter of the pieces.
std::vector<double> abscissae(const std::vector<double>& lengths) {
    const std::size_t degree = (lengths.size() + 1) / 2;
    std::vector<double> result;
    for (std::size_t q = 0; q <= degree; ++q) {
        double sum = 0;
        for (std::size_t knot = q; knot < q + degree; ++knot) {
            for (std::size_t i = degree - 1; i < knot; ++i) sum += lengths[i];
            for (std::size_t i = knot; i < degree - 1; ++i) sum -= lengths[i];
        }
        result.push_back(sum / static_cast<double>(degree));
    }
    return result;
}

TEST(Deviation, UniformQuadraticsDeviateByAnEighthOfTheSecondDifference) {
    const std::vector<DeviationPiece> pieces = deviation_pieces(std::vector<double>{1, 1, 1});
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_THAT(pieces[0].coefficients, ElementsAre(DoubleEq(0), DoubleEq(0), DoubleEq(0.125)));
    EXPECT_THAT(pieces[1].coefficients, ElementsAre(DoubleEq(0.125), DoubleEq(0), DoubleEq(0)));
}

TEST(Deviation, PiecesFillTheIntervalWithoutAbscissaeInside) {
    tests::Random random(1);
    for (std::size_t degree = 2; degree <= 12; ++degree)
        for (int time = 0; time < 20; ++time) {
            const std::vector<double> lengths = random_lengths(random, degree);
            double end = 0;
            for (const DeviationPiece& piece : deviation_pieces(lengths)) {
                EXPECT_EQ(piece.begin, end);
                EXPECT_LT(piece.begin, piece.end);
                end = piece.end;
                for (const double abscissa : abscissae(lengths))
                    EXPECT_FALSE(abscissa > piece.begin + 1e-12 && abscissa < piece.end - 1e-12);
            }
            EXPECT_EQ(end, lengths[degree - 1]);
        }
}

TEST(Deviation, IsNeverNegativeAtTheEndsOfItsPieces) {
    tests::Random random(2);
    for (std::size_t degree = 2; degree <= 12; ++degree)
        for (int time = 0; time < 20; ++time)
            for (const DeviationPiece& piece : deviation_pieces(random_lengths(random, degree)))
                for (std::size_t i = 0; i + 1 < degree; ++i) {
                    EXPECT_GE(piece.coefficients[i], -1e-14);
                    EXPECT_GE(piece.coefficients[degree * (degree - 1) + i], -1e-14);
                }
}

TEST(Deviation, ContinuesFromPieceToPiece) {
    tests::Random random(3);
    for (std::size_t degree = 2; degree <= 8; ++degree) {
        const std::vector<DeviationPiece> pieces = deviation_pieces(random_lengths(random, degree));
        for (std::size_t p = 1; p < pieces.size(); ++p)
            for (std::size_t i = 0; i + 1 < degree; ++i)
                EXPECT_NEAR(pieces[p - 1].coefficients[degree * (degree - 1) + i], pieces[p].coefficients[i], 1e-13);
    }
}

} // namespace
} // namespace internode
