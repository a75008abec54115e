// SPDX-License-Identifier: MIT

#include "internode/point/infer/inference.h"

#include "internode/algebra/fraction.h"
#include "internode/io/matrix/fraction_matrix.h"
#include "tests/reference/point_rows.h"

#include <random>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

using Stencils = std::vector<PointStencil>;

/// A ring of n points: new point m q + r is stencils[r] about old point q.
RationalMatrix ring_matrix(const Stencils& stencils, std::size_t n) {
    RationalMatrix matrix{n, {}};
    for (std::size_t point = 0; point < n; ++point)
        for (const PointStencil& stencil : stencils) {
            std::vector<Rational> row(n);
            for (const StencilTerm& term : stencil) {
                const auto size = static_cast<std::ptrdiff_t>(n);
                const std::ptrdiff_t column = (static_cast<std::ptrdiff_t>(point) + term.offset) % size;
                row[static_cast<std::size_t>((column + size) % size)] += term.weight;
            }
            RationalRow& sparse = matrix.rows.emplace_back();
            for (std::size_t column = 0; column < n; ++column)
                if (row[column] != 0) sparse.push_back({column, row[column]});
        }
    return matrix;
}

// The matrices of S0 as printed, by the stencils of their rows.
const Stencils chaikin_14{{{-1, fraction(1, 4)}, {0, fraction(3, 4)}}, {{0, fraction(3, 4)}, {1, fraction(1, 4)}}};
const Stencils cubic_21{{{-1, fraction(1, 2)}, {0, fraction(1, 2)}},
                        {{-1, fraction(1, 8)}, {0, fraction(3, 4)}, {1, fraction(1, 8)}}};
const Stencils four_point_24{
    {{-2, fraction(-1, 16)}, {-1, fraction(9, 16)}, {0, fraction(9, 16)}, {1, fraction(-1, 16)}}, {{0, 1}}};

RowPattern closed(const RationalMatrix& matrix) {
    InferredPattern inferred = infer_closed(matrix);
    EXPECT_TRUE(inferred.pattern) << (inferred.problem ? inferred.problem->message : "");
    return inferred.pattern ? *std::move(inferred.pattern) : RowPattern();
}

RationalMatrix matrix_of(const char* text) {
    return read_fraction_csv(text, "m").matrix.value();
}

TEST(ClosedInference, ReadsChaikinInEveryShiftOfThePaper) {
    const RowPattern pattern = closed(ring_matrix(chaikin_14, 6));
    EXPECT_EQ(pattern.stencils, chaikin_14);
    EXPECT_EQ(production_of(pattern, 0).production, (PointProduction{1, 1, 1, false, false, chaikin_14})) << "eq. 13";
    const Stencils eq_17{{{-1, fraction(3, 4)}, {0, fraction(1, 4)}}, {{-1, fraction(1, 4)}, {0, fraction(3, 4)}}};
    EXPECT_EQ(production_of(pattern, -1).production, (PointProduction{1, 1, 0, false, false, eq_17}));
    const Stencils eq_18{{{0, fraction(3, 4)}, {1, fraction(1, 4)}}, {{0, fraction(1, 4)}, {1, fraction(3, 4)}}};
    EXPECT_EQ(production_of(pattern, 1).production, (PointProduction{0, 1, 1, false, false, eq_18}));
    const Stencils eq_20{{{2, fraction(3, 4)}, {3, fraction(1, 4)}}, {{2, fraction(1, 4)}, {3, fraction(3, 4)}}};
    EXPECT_EQ(production_of(pattern, 5).production, (PointProduction{0, 1, 3, false, false, eq_20}))
        << "j = 2i + 5: the paper's d = 3 is two rows less";
    EXPECT_EQ(production_of(pattern, 3).production.right, 2U);
}

TEST(ClosedInference, RecommendsTheProductionsOfThePaper) {
    const RowPattern chaikin = closed(ring_matrix(chaikin_14, 6));
    EXPECT_EQ(sensible_shifts(chaikin).recommended, 0) << "eq. 13";
    EXPECT_THAT(sensible_shifts(chaikin).shifts, ElementsAre(-2, -1, 0, 1, 2));
    const RowPattern cubic = closed(ring_matrix(cubic_21, 7));
    EXPECT_EQ(sensible_shifts(cubic).recommended, 1);
    const Stencils eq_22{{{-1, fraction(1, 8)}, {0, fraction(3, 4)}, {1, fraction(1, 8)}},
                         {{0, fraction(1, 2)}, {1, fraction(1, 2)}}};
    EXPECT_EQ(production_of(cubic, 1).production, (PointProduction{1, 1, 1, false, false, eq_22}));
    EXPECT_EQ(production_of(cubic, 0).production, (PointProduction{1, 1, 1, false, false, cubic_21})) << "eq. 23";
    const RowPattern four_point = closed(ring_matrix(four_point_24, 8));
    EXPECT_EQ(sensible_shifts(four_point).recommended, 1);
    const Stencils eq_25{{{0, 1}},
                         {{-1, fraction(-1, 16)}, {0, fraction(9, 16)}, {1, fraction(9, 16)}, {2, fraction(-1, 16)}}};
    EXPECT_EQ(production_of(four_point, 1).production, (PointProduction{1, 1, 2, false, false, eq_25}));
    EXPECT_EQ(production_of(four_point, 0).production, (PointProduction{2, 1, 1, false, false, four_point_24}))
        << "eq. 26";
}

TEST(ClosedInference, ReadsThePrintedMatrixOfFourPoints) {
    const RowPattern pattern = closed(matrix_of("3/4 0 0 1/4\n3/4 1/4 0 0\n1/4 3/4 0 0\n0 3/4 1/4 0\n"
                                                "0 1/4 3/4 0\n0 0 3/4 1/4\n0 0 1/4 3/4\n1/4 0 0 3/4\n"));
    EXPECT_EQ(pattern.stencils, chaikin_14) << "eq. 7";
    EXPECT_THAT(pattern.not_affine, SizeIs(0));
}

TEST(ClosedInference, AShiftMovesTheRowsAndNothingElse) {
    std::mt19937 random(5);
    const auto any = [&random](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
    for (int trial = 0; trial < 80; ++trial) {
        Stencils stencils(static_cast<std::size_t>(any(1, 3)));
        for (PointStencil& stencil : stencils)
            for (int offset = -2; offset <= 2; ++offset)
                if (const int weight = any(-4, 4); weight != 0 && any(0, 2) > 0)
                    stencil.push_back({offset, fraction(weight, 8)});
        for (const std::size_t n : {6, 11}) {
            const RationalMatrix matrix = ring_matrix(stencils, n);
            const InferredPattern inferred = infer_closed(matrix);
            if (!inferred.pattern) {
                EXPECT_LT(n, 10U) << inferred.problem->message;
                continue;
            }
            EXPECT_EQ(inferred.pattern->arity(), stencils.size());
            for (std::ptrdiff_t shift = -7; shift <= 7; ++shift) {
                const ShiftedProduction production = production_of(*inferred.pattern, shift);
                const PointGrammar grammar = closed_grammar("g", production);
                EXPECT_EQ(tests::row_matrix(grammar, n), tests::rotated_rows(matrix, shift));
            }
        }
    }
}

TEST(ClosedInference, ASufficientRingGivesTheSchemeBack) {
    for (const Stencils& stencils : {chaikin_14, cubic_21, four_point_24})
        for (std::size_t n = 5; n <= 12; ++n) EXPECT_EQ(closed(ring_matrix(stencils, n)).stencils, stencils);
}

TEST(ClosedInference, ReportsTheRowsThatBreakThePattern) {
    RationalMatrix matrix = ring_matrix(chaikin_14, 6);
    matrix.rows[5] = {{2, fraction(1, 2)}, {3, fraction(1, 2)}};
    const InferredPattern inferred = infer_closed(matrix);
    ASSERT_TRUE(inferred.problem);
    ASSERT_THAT(inferred.problem->rows, SizeIs(1));
    EXPECT_EQ(inferred.problem->rows[0].row, 5U);
    EXPECT_EQ(inferred.problem->rows[0].like % 2, 1U);
    EXPECT_THAT(inferred.problem->message, HasSubstr("1 of 12 rows breaks the pattern of the others, row 6"));
}

TEST(ClosedInference, RefusesWhatItCannotTell) {
    const auto message = [](const RationalMatrix& matrix) {
        const InferredPattern inferred = infer_closed(matrix);
        return inferred.problem ? inferred.problem->message : std::string();
    };
    EXPECT_THAT(message(ring_matrix(four_point_24, 4)), HasSubstr("row 1 has weights in all of its 4 columns"));
    EXPECT_THAT(message(ring_matrix({{{-1, 1}, {1, 1}}}, 4)), HasSubstr("may begin at more than one"));
    EXPECT_THAT(message(matrix_of("1, 0\n0, 1\n1, 0\n")), HasSubstr("3 rows for 2 columns"));
    EXPECT_THAT(message(matrix_of("1, 0\n")), HasSubstr("1 rows for 2 columns"));
    EXPECT_THAT(message(RationalMatrix{}), HasSubstr("0 rows for 0 columns"));
    EXPECT_THAT(message(RationalMatrix{1, RationalMatrix{1, {}}.rows}), HasSubstr("0 rows"));
    RationalMatrix wide = ring_matrix({{{0, 1}}}, 500);
    for (std::size_t i = 0; i < wide.rows.size(); ++i) {
        wide.rows[i] = {{i, 1}, {(i + 2) % 500, 1}};
        std::ranges::sort(wide.rows[i], {}, &RationalEntry::column);
    }
    EXPECT_EQ(message(wide), "");
    EXPECT_THAT(message(RationalMatrix{1, std::vector<RationalRow>(100, {{0, 1}})}), HasSubstr("too small"));
    EXPECT_THAT(message(RationalMatrix{2, std::vector<RationalRow>(200)}), HasSubstr("100 new ones"));
}

TEST(ClosedInference, SaysWhichRowsAreNotAffine) {
    RationalMatrix matrix = ring_matrix({{{0, fraction(1, 2)}}, {{0, 1}}}, 3);
    EXPECT_THAT(closed(matrix).not_affine, ElementsAre(0, 2, 4));
}

} // namespace
} // namespace internode
