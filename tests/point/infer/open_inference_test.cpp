// SPDX-License-Identifier: MIT

#include "internode/algebra/fraction.h"
#include "internode/io/matrix/fraction_matrix.h"
#include "internode/point/infer/inference.h"
#include "tests/reference/point_rows.h"

#include <random>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

using Stencils = std::vector<PointStencil>;

/// The family of matrices of an open scheme: fixed rows at the first points, a pattern, fixed rows at the last points.
struct OpenScheme {
    std::vector<RationalRow> first; ///< columns from the first point
    Stencils pattern;               ///< about an old point
    std::size_t from = 0;           ///< the first old point about which the pattern stands
    std::size_t until = 0;          ///< so many old points before the end it stops
    std::vector<RationalRow> last;  ///< columns backwards from the last point
};

RationalMatrix matrix_of(const OpenScheme& scheme, std::size_t n) {
    RationalMatrix matrix{n, scheme.first};
    for (std::size_t i = scheme.from; i + scheme.until < n; ++i)
        for (const PointStencil& stencil : scheme.pattern) {
            RationalRow& row = matrix.rows.emplace_back();
            for (const StencilTerm& term : stencil)
                row.push_back({static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + term.offset), term.weight});
        }
    for (const RationalRow& last : scheme.last) {
        RationalRow row = last;
        for (RationalEntry& entry : row) entry.column = n - 1 - entry.column;
        std::ranges::sort(row, {}, &RationalEntry::column);
        matrix.rows.push_back(row);
    }
    return matrix;
}

/// S0 eq. 27.
const OpenScheme chaikin_27{{{{0, 1}}, {{0, fraction(1, 2)}, {1, fraction(1, 2)}}},
                            {{{0, fraction(3, 4)}, {1, fraction(1, 4)}}, {{0, fraction(1, 4)}, {1, fraction(3, 4)}}},
                            1,
                            2,
                            {{{1, fraction(1, 2)}, {0, fraction(1, 2)}}, {{0, 1}}}};

OpenPattern open(const RationalMatrix& matrix) {
    InferredOpenPattern inferred = infer_open(matrix);
    EXPECT_TRUE(inferred.pattern) << (inferred.problem ? inferred.problem->message : "");
    return inferred.pattern ? *std::move(inferred.pattern) : OpenPattern();
}

TEST(OpenInference, ReadsThePrintedMatrix) {
    const auto printed = read_fraction_csv("1 0 0 0 0 0\n1/2 1/2 0 0 0 0\n0 3/4 1/4 0 0 0\n0 1/4 3/4 0 0 0\n"
                                           "0 0 3/4 1/4 0 0\n0 0 1/4 3/4 0 0\n0 0 0 3/4 1/4 0\n0 0 0 1/4 3/4 0\n"
                                           "0 0 0 0 1/2 1/2\n0 0 0 0 0 1\n",
                                           "m");
    EXPECT_EQ(printed.matrix.value(), matrix_of(chaikin_27, 6));
    const OpenPattern pattern = open(*printed.matrix);
    EXPECT_EQ(pattern.pattern.arity(), 2U);
    EXPECT_EQ(pattern.first_regular, 2U);
    EXPECT_EQ(pattern.end_regular, 8U);
}

TEST(OpenInference, GivesTheLongFormOfThePaper) {
    const OpenPattern pattern = open(matrix_of(chaikin_27, 8));
    EXPECT_EQ(sensible_open_shifts(pattern).recommended, -1);
    const OpenProductions productions = open_productions(pattern, -1).productions.value();
    EXPECT_EQ(productions.least_points, 4U) << "at least four modules";
    const Stencils eq_28{{{0, 1}}};
    const Stencils eq_29{{{-1, fraction(1, 2)}, {0, fraction(1, 2)}}, {{0, fraction(3, 4)}, {1, fraction(1, 4)}}};
    const Stencils eq_30{{{-1, fraction(1, 4)}, {0, fraction(3, 4)}}, {{0, fraction(3, 4)}, {1, fraction(1, 4)}}};
    const Stencils eq_31{{{-1, fraction(1, 4)}, {0, fraction(3, 4)}}, {{0, fraction(1, 2)}, {1, fraction(1, 2)}}};
    const std::vector<PointProduction> expected{{0, 1, 0, true, false, eq_28},
                                                {1, 1, 1, true, false, eq_29},
                                                {2, 1, 2, false, false, eq_30},
                                                {1, 1, 1, false, true, eq_31},
                                                {0, 1, 0, false, true, eq_28}};
    EXPECT_EQ(open_grammar("g", productions, OpenForm::Long), to_grammar("g", WordEnds::KeptMarkers, expected));
}

TEST(OpenInference, GivesTheOrderedFormOfThePaper) {
    const OpenProductions productions = open_productions(open(matrix_of(chaikin_27, 8)), -1).productions.value();
    const Stencils eq_34{{{-1, fraction(1, 2)}, {0, fraction(1, 2)}}, {{0, fraction(3, 4)}, {1, fraction(1, 4)}}};
    const Stencils eq_35{{{-1, fraction(1, 4)}, {0, fraction(3, 4)}}, {{0, fraction(1, 2)}, {1, fraction(1, 2)}}};
    const Stencils eq_36{{{-1, fraction(1, 4)}, {0, fraction(3, 4)}}, {{0, fraction(3, 4)}, {1, fraction(1, 4)}}};
    const std::vector<PointProduction> expected{
        {1, 1, 1, true, false, eq_34}, {1, 1, 1, false, true, eq_35}, {1, 1, 1, false, false, eq_36}};
    EXPECT_EQ(open_grammar("g", productions, OpenForm::Ordered), to_grammar("g", WordEnds::Markers, expected));
}

/// How many rules fit each module of the word of n points.
std::vector<int> fitting_rules(const PointGrammar& grammar, std::size_t n) {
    std::vector<Symbol> letters;
    for (const tests::RowModule& module : tests::row_input(grammar, n)) letters.push_back(module.letter);
    const WordShape shape(letters, grammar);
    std::vector<int> counts;
    std::vector<std::size_t> modules;
    for (std::size_t i = 0; i < letters.size(); ++i)
        counts.push_back(static_cast<int>(
            std::ranges::count_if(grammar.rules, [&](const PointRule& rule) { return shape.fits(rule, i, modules); })));
    return counts;
}

/// Checks both forms of every sensible shift on all sizes up to 12.
int expect_both_forms(const OpenScheme& scheme, std::size_t size) {
    const OpenPattern pattern = open(matrix_of(scheme, size));
    int shifts = 0;
    for (const std::ptrdiff_t shift : sensible_open_shifts(pattern).shifts) {
        ++shifts;
        const OpenProductions productions = open_productions(pattern, shift).productions.value();
        for (std::size_t n = std::max<std::size_t>(productions.least_points, 2); n <= 12; ++n) {
            const PointGrammar full = open_grammar("g", productions, OpenForm::Long);
            EXPECT_EQ(tests::row_matrix(full, n), matrix_of(scheme, n)) << "long, shift " << shift << ", n " << n;
            EXPECT_THAT(fitting_rules(full, n), testing::Each(1)) << "shift " << shift << ", n " << n;
            const PointGrammar ordered = open_grammar("g", productions, OpenForm::Ordered);
            EXPECT_EQ(tests::row_matrix(ordered, n), matrix_of(scheme, n)) << "ordered, shift " << shift << ", n " << n;
        }
    }
    return shifts;
}

TEST(OpenInference, BothFormsSayWhatTheMatrixSaysForAllSizes) {
    EXPECT_EQ(expect_both_forms(chaikin_27, 10), 5);
}

TEST(OpenInference, BothFormsSayWhatTheMatrixSaysForRandomSchemes) {
    std::mt19937 random(11);
    const auto any = [&random](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
    const auto row = [&any](int columns) {
        RationalRow result;
        for (int column = 0; column < columns; ++column)
            if (const int weight = any(-3, 4); weight != 0)
                result.push_back({static_cast<std::size_t>(column), fraction(weight, 4)});
        return result;
    };
    int shifts = 0;
    for (int trial = 0; trial < 60; ++trial) {
        OpenScheme scheme;
        scheme.from = static_cast<std::size_t>(any(1, 3));
        scheme.until = static_cast<std::size_t>(any(1, 3));
        for (int r = any(1, 3); r > 0; --r) {
            PointStencil& stencil = scheme.pattern.emplace_back();
            for (std::ptrdiff_t offset = -any(0, static_cast<int>(scheme.from));
                 offset <= any(0, static_cast<int>(scheme.until)); ++offset)
                if (offset >= -2 && offset <= 2) stencil.push_back({offset, fraction(any(1, 5), 4)});
            if (stencil.empty()) stencil.push_back({0, 1});
            while (stencil.back().offset > static_cast<std::ptrdiff_t>(scheme.until)) stencil.pop_back();
        }
        for (int k = any(0, 4); k > 0; --k) scheme.first.push_back(row(3));
        for (int k = any(0, 4); k > 0; --k) scheme.last.push_back(row(3));
        shifts += expect_both_forms(scheme, 14);
    }
    EXPECT_GT(shifts, 100);
}

TEST(OpenInference, ReadsAPatternThatReachesTheEnds) {
    // Each point twice: no point near an end is different.
    const OpenScheme doubled{{}, {{{0, 1}}, {{0, 1}}}, 0, 0, {}};
    const OpenPattern pattern = open(matrix_of(doubled, 6));
    const OpenProductions productions = open_productions(pattern, 0).productions.value();
    EXPECT_THAT(productions.first, SizeIs(0));
    EXPECT_THAT(productions.last, SizeIs(0));
    EXPECT_EQ(productions.least_points, 1U);
}

TEST(OpenInference, KeepsAnIdentityRuleThatTheInnerRuleWouldReplace) {
    // The first point stays; the pattern, a copy and the half way to the right, would fit it too.
    const OpenScheme scheme{{{{0, 1}}}, {{{0, 1}}, {{0, fraction(1, 2)}, {1, fraction(1, 2)}}}, 1, 1, {{{0, 1}}}};
    const OpenProductions productions = open_productions(open(matrix_of(scheme, 9)), -1).productions.value();
    EXPECT_GT(expect_both_forms(scheme, 9), 0);
    EXPECT_THAT(productions.first, SizeIs(1));
}

TEST(OpenInference, ReportsRowsThatBreakThePatternInTheMiddle) {
    RationalMatrix matrix = matrix_of(chaikin_27, 14);
    matrix.rows[13] = {{0, 1}};
    const InferredOpenPattern inferred = infer_open(matrix);
    ASSERT_TRUE(inferred.problem);
    EXPECT_THAT(inferred.problem->rows, SizeIs(1));
    EXPECT_EQ(inferred.problem->rows[0].row, 13U);
    EXPECT_EQ(inferred.problem->rows[0].like % 2, 1U);
}

TEST(OpenInference, RefusesWhatItCannotTell) {
    EXPECT_THAT(infer_open(matrix_of(chaikin_27, 4)).problem.value().message, HasSubstr("too small"));
    EXPECT_THAT(infer_open(RationalMatrix{}).problem.value().message, HasSubstr("too small"));
    // The ring of Chaikin: its first and last rows reach round.
    RationalMatrix ring = matrix_of(chaikin_27, 8);
    ring.rows[1] = {{0, fraction(3, 4)}, {7, fraction(1, 4)}};
    const OpenPattern pattern = open(ring);
    EXPECT_TRUE(open_productions(pattern, -1).problem);
    EXPECT_THAT(open_productions(pattern, -1).problem->hint, HasSubstr("without --open"));
    EXPECT_THAT(sensible_open_shifts(pattern).shifts, SizeIs(0));
    EXPECT_TRUE(open_productions(open(matrix_of(chaikin_27, 6)), 100).problem);
}

} // namespace
} // namespace internode
