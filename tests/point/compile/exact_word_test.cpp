// SPDX-License-Identifier: MIT

#include "internode/point/compile/exact_word.h"

#include "tests/fixtures/point_systems.h"
#include "tests/fixtures/stride.h"

#include <gtest/gtest.h>

namespace internode {
namespace {

using tests::bundled_system;
using tests::point_system;

RationalMatrix matrix(const PointSystem& system, std::size_t points, std::uint64_t cycles = 1) {
    return std::get<RationalMatrix>(point_matrix(system, points, cycles));
}

std::string reason(const PointSystem& system, std::size_t points) {
    const auto made = point_matrix(system, points);
    return std::get<ExactStop>(made).reason;
}

RationalMatrix from_rows(std::size_t columns, const std::vector<std::vector<Rational>>& rows) {
    RationalMatrix matrix{columns, {}};
    for (const std::vector<Rational>& row : rows) {
        matrix.rows.emplace_back();
        for (std::size_t column = 0; column < row.size(); ++column)
            if (row[column] != 0) matrix.rows.back().push_back({column, row[column]});
    }
    return matrix;
}

RationalMatrix product(const RationalMatrix& a, const RationalMatrix& b) {
    std::vector<std::vector<Rational>> rows;
    for (const RationalRow& row : a.rows) {
        std::vector<Rational>& sum = rows.emplace_back(b.columns);
        for (const RationalEntry& entry : row)
            for (const RationalEntry& other : b.rows[entry.column]) sum[other.column] += entry.value * other.value;
    }
    return from_rows(b.columns, rows);
}

TEST(PointMatrix, OfChaikinOnASquareIsEquation7) {
    const Rational q(1, 4);
    const Rational t(3, 4);
    const RationalMatrix expected = from_rows(4, {{t, 0, 0, q},
                                                  {t, q, 0, 0},
                                                  {q, t, 0, 0},
                                                  {0, t, q, 0},
                                                  {0, q, t, 0},
                                                  {0, 0, t, q},
                                                  {0, 0, q, t},
                                                  {q, 0, 0, t}});
    EXPECT_EQ(matrix(bundled_system("s0/13"), 4), expected);
}

TEST(PointMatrix, OfSeveralCyclesIsTheProduct) {
    for (const char* name : {"s0/13", "s0/22", "s0/25", "s0/28-33", "s1/8", "lane-riesenfeld"}) {
        const PointSystem system = bundled_system(name);
        const RationalMatrix once = matrix(system, 6);
        const RationalMatrix twice = matrix(system, 6, 2);
        // S1 (8) begins its words with an edge after a cycle: another word than the input of as many points.
        if (std::string(name) == "s1/8" || std::string(name) == "lane-riesenfeld") {
            EXPECT_EQ(twice.rows.size(), 4 * once.columns);
            continue;
        }
        EXPECT_EQ(twice, product(matrix(system, once.rows.size()), once)) << name;
    }
}

TEST(PointMatrix, WeightsOfShortRingsAdd) {
    // One point is its own neighbour on both sides.
    EXPECT_EQ(matrix(bundled_system("s0/25"), 1), from_rows(1, {{1}, {1}}));
    EXPECT_EQ(matrix(bundled_system("s0/22"), 2), from_rows(2, {{Rational(3, 4), Rational(1, 4)},
                                                                {Rational(1, 2), Rational(1, 2)},
                                                                {Rational(1, 4), Rational(3, 4)},
                                                                {Rational(1, 2), Rational(1, 2)}}));
}

TEST(PointMatrix, TakesPredecessorsOfSeveralModules) {
    const RationalMatrix reverse = matrix(bundled_system("s0/38"), 8);
    const RationalMatrix forward = matrix(bundled_system("s0/13"), 4);
    const RationalMatrix identity = from_rows(4, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});
    EXPECT_EQ(product(reverse, forward), identity);
}

TEST(PointMatrix, UsesConditionsNumbersAndConstants) {
    const PointSystem system =
        point_system("points\nring\ninput P(v, 1)\nw = 1/3\nf(a, b) = max(a, b) - floor(3/2)\n"
                     "P(v, s) > P(r, u) : s + u == 2 and not s < 1 -> P(w v + (1 - w) r, f(s, 2))\n");
    EXPECT_EQ(matrix(system, 2), from_rows(2, {{Rational(1, 3), Rational(2, 3)}, {Rational(2, 3), Rational(1, 3)}}));
}

TEST(PointMatrix, SaysWhyItCannotBeExact) {
    EXPECT_EQ(reason(point_system("points\nP(v) -> P((v.x, v.y))\n"), 3), "mixes coordinates");
    EXPECT_EQ(reason(point_system("points\nw = sqrt(2)\nP(v) -> P(w v + (1 - w) v)\n"), 3),
              "uses a square root that is not rational");
    EXPECT_EQ(reason(point_system("points\ninput P(v, 2)\nP(v, s) -> P(sqrt(s) v, s)\n"), 3),
              "takes a square root that is not rational");
    EXPECT_EQ(reason(point_system("points\ninput P(v, 0)\nP(v, s) -> P((1/s) v, s)\n"), 3), "divides by zero");
    EXPECT_EQ(reason(point_system("points\nP(v) -> P(v) : 1\nP(v) -> P(v) P(v) : 1\n"), 3), "is chosen by chance");
    EXPECT_EQ(reason(bundled_system("s0/38"), 3), "leaves a module over");
    EXPECT_THROW((void)point_matrix(bundled_system("s0/13"), 0), std::invalid_argument);
}

TEST(PointMatrix, TakesTheRootOfASquare) {
    EXPECT_EQ(matrix(point_system("points\ninput P(v, 9/4)\nP(v, s) -> P((1/sqrt(s)) v + 1/3 v, s)\n"), 1),
              from_rows(1, {{1}}));
}

TEST(PointMatrix, StopsAtNumbersThatAreTooLong) {
    const std::string digits(900, '7');
    const PointSystem system =
        point_system("points\nw = 0." + digits + "\nP(v) -> P(w w w w w v + (1 - w w w w w) v)\n");
    EXPECT_EQ(reason(system, 1), "has numbers of too many digits");
}

TEST(PointMatrix, DecidesOnlyWhatDoublesDecideAlike) {
    const PointSystem system = point_system("points\ninput P(v, 3)\nP(v, s) -> P(v, s s s s)\n");
    EXPECT_NO_THROW((void)matrix(system, 1, 2)); // 3^16 is a double
    const auto made = point_matrix(system, 1, 4);
    EXPECT_EQ(std::get<ExactStop>(made).reason, "computes with numbers that doubles round");
}

TEST(PointMatrix, HasALimitOfItsWork) {
    if (!tests::in_full()) GTEST_SKIP() << "all the work that there may be";
    const PointSystem system =
        point_system("points\nring\ntable q\nP(v) > P(u) -> P(v) P(1/2 v + 1/2 u)\ncycle q^40\n");
    EXPECT_EQ(reason(system, 4), "needs too much exact arithmetic");
}

TEST(ExactStep, AsksNoSurroundings) {
    const PointSystem system = point_system("points\ninput P(v) ?E(0)\nP(v) -> P(v) P(v)\n");
    const auto word = exact_input(system, 2);
    ExactBudget budget;
    const auto next = exact_step(system, std::get<ExactWord>(word), std::nullopt, budget);
    EXPECT_EQ(std::get<ExactStop>(next).reason, "asks its surroundings");
}

TEST(ExactPieceStep, SettlesWhatIsCertainOnly) {
    const PointSystem system = bundled_system("s0/13");
    const ExactWord word = std::get<ExactWord>(exact_input(system, 7));
    ExactBudget budget;
    const PieceStep step = exact_piece_step(system, word, {true, true}, 3, 4, std::nullopt, budget);
    ASSERT_TRUE(step.word);
    EXPECT_EQ(step.first, 1U); // the modules at both ends have neighbours that are not known
    EXPECT_EQ(step.last, 6U);
    EXPECT_EQ(step.word->size(), 10U);
    EXPECT_FALSE(exact_piece_step(system, word, {true, true}, 0, 1, std::nullopt, budget).word);
    // Where the word ends, the rule does not fit for certain.
    EXPECT_EQ(exact_piece_step(system, word, {false, false}, 0, 1, std::nullopt, budget).word->size(), 12U);
}

/// What the modules first … last - 1 become in a step of the whole word, their parents counted from `first`.
ExactWord successors(const ExactWord& next, std::size_t first, std::size_t last) {
    ExactWord some;
    for (const ExactModule& module : next)
        if (module.parent >= first && module.parent < last) {
            some.push_back(module);
            some.back().parent -= first;
        }
    return some;
}

/// All pieces of an open word, cut anywhere, against the step of the whole.
void expect_pieces_agree(const PointSystem& system, std::size_t points) {
    const ExactWord word = std::get<ExactWord>(exact_input(system, points));
    const auto table = system.cycle().front();
    ExactBudget budget;
    const ExactWord next = std::get<ExactWord>(exact_step(system, word, table, budget));
    for (std::size_t begin = 0; begin < word.size(); ++begin)
        for (std::size_t end = begin + 1; end <= word.size(); ++end) {
            const PieceSides sides{begin > 0, end < word.size()};
            const ExactWord piece(word.begin() + static_cast<std::ptrdiff_t>(begin),
                                  word.begin() + static_cast<std::ptrdiff_t>(end));
            for (std::size_t wanted = 0; wanted < piece.size(); ++wanted) {
                const PieceStep step = exact_piece_step(system, piece, sides, wanted, wanted + 1, table, budget);
                if (!step.word) continue;
                ASSERT_LE(step.first, wanted);
                ASSERT_GT(step.last, wanted);
                EXPECT_EQ(successors(*step.word, step.first, step.last),
                          successors(next, begin + step.first, begin + step.last))
                    << begin << ' ' << end << ' ' << wanted;
                EXPECT_EQ(step.sides.left_open, begin + step.first > 0);
                EXPECT_EQ(step.sides.right_open, begin + step.last < word.size());
            }
        }
}

TEST(ExactPieceStep, OfAnyPieceIsThatOfTheWholeWord) {
    for (const char* name : {"s0/28-33", "s0/34-36", "s1/12", "s1/13"}) expect_pieces_agree(bundled_system(name), 6);
    expect_pieces_agree(point_system("points\ninput # P(v) #\n# P(u) < P(v) -> P(u) P(v)\n"
                                     "P(u) P(p) < P(v) > P(w) P(q) -> P(u) P(q)\nP(v) > P(w) # -> P(1/2 v + 1/2 w)\n"),
                        6);
}

TEST(ExactPieceStep, TheStartOfTheWordIsCertain) {
    // Two points are missed on the left: nothing is known of them in the middle, and there are none at the start.
    const PointSystem system = point_system("points\ninput # P(v) #\nP(u) P(p) < P(v) -> P(u) P(v)\n");
    const ExactWord word = std::get<ExactWord>(exact_input(system, 5));
    const ExactWord piece(word.begin(), word.begin() + 4); // # P P P
    ExactBudget budget;
    const PieceStep known = exact_piece_step(system, piece, {false, true}, 1, 2, std::nullopt, budget);
    ASSERT_TRUE(known.word);
    EXPECT_EQ(known.first, 0U);
    EXPECT_EQ(known.last, 4U);
    EXPECT_FALSE(known.sides.left_open);
    const ExactWord inner(word.begin() + 1, word.begin() + 4); // P P P, of unknown surroundings
    EXPECT_FALSE(exact_piece_step(system, inner, {true, true}, 0, 1, std::nullopt, budget).word);
    EXPECT_FALSE(exact_piece_step(system, inner, {true, true}, 1, 2, std::nullopt, budget).word);
    EXPECT_TRUE(exact_piece_step(system, inner, {true, true}, 2, 3, std::nullopt, budget).word);
    const PieceStep begins = exact_piece_step(system, inner, {false, true}, 0, 1, std::nullopt, budget);
    ASSERT_TRUE(begins.word) << "a word that begins with P";
    EXPECT_EQ(begins.first, 0U);
}

TEST(ExactPieceStep, OfAWholeOpenWordIsTheStep) {
    for (const char* name : {"s0/28-33", "s0/34-36", "s1/12", "s1/13"}) {
        const PointSystem system = bundled_system(name);
        const ExactWord word = std::get<ExactWord>(exact_input(system, 5));
        ExactBudget budget;
        const PieceStep piece = exact_piece_step(system, word, {}, 0, 1, system.cycle().front(), budget);
        EXPECT_EQ(*piece.word, std::get<ExactWord>(exact_step(system, word, system.cycle().front(), budget))) << name;
    }
}

} // namespace
} // namespace internode
