// SPDX-License-Identifier: MIT

#include "internode/point/compile/compile.h"

#include "tests/fixtures/point_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace internode {
namespace {

using tests::bundled_system;
using tests::point_system;

CompiledGrammar compiled(const PointSystem& system, StartWord start) {
    Compilation compilation = compile(system, start);
    if (!compilation.compiled) throw std::runtime_error(compilation.reasons.front().reason);
    return *std::move(compilation.compiled);
}

std::string reason(const PointSystem& system, StartWord start = {many_points}) {
    const Compilation compilation = compile(system, start);
    return compilation.compiled ? "" : compilation.reasons.front().reason;
}

/// The rows of the automaton, applied step by step to the points of the start word.
std::vector<CellRow> stepped(const CompiledGrammar& grammar, int cycles) {
    std::vector<std::uint32_t> cells = grammar.cells();
    const auto n = static_cast<std::ptrdiff_t>(cells.size());
    std::vector<std::vector<Rational>> points;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        points.emplace_back(cells.size());
        points.back()[i] = 1;
    }
    const NumberField rationals;
    for (int cycle = 0; cycle < cycles; ++cycle) {
        std::vector<std::uint32_t> next_cells;
        std::vector<std::vector<Rational>> next;
        const auto count = static_cast<std::ptrdiff_t>(cells.size());
        for (std::ptrdiff_t cell = 0; cell < count; ++cell)
            for (const CellChild& child : grammar.rules()[cells[static_cast<std::size_t>(cell)]]) {
                next_cells.push_back(child.state);
                std::vector<Rational>& sum = next.emplace_back(static_cast<std::size_t>(n));
                for (std::size_t k = 0; k < child.row.weights.size(); ++k) {
                    const std::ptrdiff_t parent = cell + child.row.first + static_cast<std::ptrdiff_t>(k);
                    const auto& from = points[static_cast<std::size_t>(((parent % count) + count) % count)];
                    const Rational weight = child.row.weights[k].coefficients(rationals).front();
                    for (std::size_t j = 0; j < from.size(); ++j) sum[j] += weight * from[j];
                }
            }
        cells = std::move(next_cells);
        points = std::move(next);
    }
    std::vector<CellRow> rows;
    for (const auto& point : points) rows.push_back({0, {point.begin(), point.end()}});
    return rows;
}

std::vector<CellRow> dense(const RationalMatrix& matrix) {
    std::vector<CellRow> rows;
    for (const RationalRow& row : matrix.rows) {
        rows.push_back({0, std::vector<Number>(matrix.columns)});
        for (const RationalEntry& entry : row) rows.back().weights[entry.column] = entry.value;
    }
    return rows;
}

void expect_same_as_derivation(const PointSystem& system, std::size_t points, int cycles, const std::string& what) {
    SCOPED_TRACE(what + ", " + std::to_string(points) + " points, " + std::to_string(cycles) + " cycles");
    const CompiledGrammar grammar = compiled(system, {points});
    const auto exact = point_matrix(system, points, static_cast<std::uint64_t>(cycles));
    ASSERT_TRUE(std::holds_alternative<RationalMatrix>(exact));
    const auto& matrix = std::get<RationalMatrix>(exact);
    EXPECT_EQ(stepped(grammar, cycles), dense(matrix));
    // By the plan of several cycles at once, on the corners of a simplex.
    std::vector<double> corners(points * points);
    for (std::size_t i = 0; i < points; ++i) corners[i * points + i] = 1;
    PlanOptions greedy;
    greedy.points_per_row = 1;
    const RefinementPlan plan = grammar.plan(cycles, greedy);
    ASSERT_EQ(plan.output_size(), matrix.rows.size());
    std::vector<double> refined(plan.output_size() * points);
    plan.apply<double>(corners, points, refined);
    for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
        std::vector<double> expected(points);
        for (const RationalEntry& entry : matrix.rows[row]) expected[entry.column] = to_double(entry.value);
        for (std::size_t column = 0; column < points; ++column)
            ASSERT_NEAR(refined[row * points + column], expected[column], 1e-14) << row << ' ' << column;
    }
}

TEST(Compile, EqualsDerivationForTheGrammarsOfThePapers) {
    for (const char* name :
         {"s0/13", "s0/17", "s0/18", "s0/20", "s0/22", "s0/23", "s0/25", "s0/26", "s0/28-33", "s0/34-36", "s1/7",
          "s1/8", "s1/10", "s1/17", "s1/19", "four-point", "six-point", "corner-cutting", "lane-riesenfeld"})
        for (const std::size_t points : {3, 4, 5, 8})
            for (const int cycles : {1, 2, 3}) expect_same_as_derivation(bundled_system(name), points, cycles, name);
}

TEST(Compile, EqualsDerivationForRandomAffineGrammars) {
    std::mt19937 random(20030901);
    for (int round = 0; round < 60; ++round) {
        const std::string text = tests::random_affine_grammar(round % 2 == 0, random);
        const PointSystem system = point_system(text);
        for (const std::size_t points : {1, 2, 3, 5, 7})
            for (const int cycles : {1, 2, 3}) expect_same_as_derivation(system, points, cycles, text);
    }
}

TEST(Compile, TakesStatesThatNumbersTell) {
    // Every second point stays: a state is a number.
    const PointSystem system = point_system("points\nring\ninput P(v, 0)\n"
                                            "P(v, s) > P(r, t) : s == 0 -> P(v, 1) P(1/2 v + 1/2 r, 0)\n"
                                            "P(v, s) > P(r, t) -> P(1/4 v + 3/4 r, 0) P(3/4 v + 1/4 r, 1)\n");
    for (const std::size_t points : {1, 2, 5})
        for (const int cycles : {1, 2, 3, 4}) expect_same_as_derivation(system, points, cycles, "numbers");
}

TEST(Compile, HasOneStateWhereEveryPointDoesTheSame) {
    for (const char* name : {"s0/13", "s0/17", "s0/18", "s0/20", "s0/22", "s0/23", "s0/25", "s0/26"})
        EXPECT_EQ(compiled(bundled_system(name), {many_points}).automaton().state_count(), 1U) << name;
}

TEST(Compile, ManyPointsAreCellsOfAFewStates) {
    const CompiledGrammar grammar = compiled(bundled_system("s0/28-33"), {many_points});
    EXPECT_EQ(grammar.cells().size(), many_points);
    EXPECT_EQ(grammar.automaton().state_count(), 5U);
    const CompiledGrammar few = compiled(bundled_system("s0/28-33"), {40});
    ASSERT_EQ(few.cells().size(), 40U);
    EXPECT_EQ(std::ranges::count(few.cells(), few.cells()[20]), 36);
}

TEST(Compile, TheCellsOfATriangleAreItsThreePoints) {
    const CompiledGrammar grammar = compiled(bundled_system("sierpinski"), {});
    const RefinementPlan plan = grammar.plan(3);
    EXPECT_EQ(plan.input_size() % 3, 0U);
    EXPECT_EQ(plan.output_size() % 3, 0U);
}

TEST(Compile, SaysWhyItDoesNot) {
    EXPECT_EQ(reason(bundled_system("s0/38")), "has a strict predecessor of several modules");
    EXPECT_EQ(reason(bundled_system("s1/11")), "needs letters that lie further away with every cycle");
    EXPECT_EQ(reason(point_system("points\nP(v) -> P((v.x, v.y))\n")), "mixes coordinates");
    EXPECT_EQ(reason(point_system("points\nP(v) -> P(v) P(v) : 1\n")), "is chosen by chance");
    EXPECT_EQ(reason(point_system("points\ninput P(v) [ P(v) ]\nP(v) -> P(v) P(v)\n")), "has branches");
    EXPECT_EQ(reason(point_system("points\ninput P(v) ?E(0)\nP(v) -> P(v) P(v)\n")), "asks its surroundings by `?E`");
    EXPECT_EQ(reason(point_system("points\ninput P(v, 1)\nP(v, s) -> P(v, 2 s) P(v, s)\n")),
              "has too many states: letters, numbers and neighbours differ in more than 4096 ways");
    EXPECT_EQ(reason(point_system("points\naxiom A\nA -> A A\n"), {}), "has no points");
    EXPECT_THROW((void)compile(bundled_system("s0/13"), {0}), std::invalid_argument);
    EXPECT_THROW((void)compile(bundled_system("s0/13"), {}), std::invalid_argument);
}

TEST(Compile, SaysWhenARowIsTooWide) {
    std::string text = "points\nring\ninput P(v)\nP(a)";
    for (int i = 1; i < 14; ++i) text += fmt::format("{} P(a{})", i == 1 ? " >" : "", i);
    text += " -> P(a) P(1/2 a + 1/2 a13)\n";
    EXPECT_EQ(reason(point_system(text)), "needs more than 13 neighbouring points for a new one");
}

TEST(Compile, KeepsItsLimitOfWork) {
    CompileLimits limits;
    limits.work = 10;
    const Compilation compilation = compile(bundled_system("s0/13"), {many_points}, limits);
    ASSERT_FALSE(compilation.compiled);
    EXPECT_EQ(compilation.reasons.front().reason, "takes too long to compile");
}

TEST(CompiledGrammar, FusesSeveralCyclesIntoRowsOfSum1) {
    for (const char* name : {"s0/13", "s0/22", "s0/25", "s0/28-33", "six-point"}) {
        const CompiledGrammar grammar = compiled(bundled_system(name), {many_points});
        const std::vector<bool> all(grammar.automaton().state_count(), true);
        for (const int cycles : {1, 2, 3, 5}) {
            const std::optional<FusedStencils> table = grammar.fuse(cycles, all);
            ASSERT_TRUE(table) << name << cycles;
            for (std::size_t row = 0; row < table->row_count(); ++row) {
                double sum = 0;
                for (std::size_t k = 0; k < table->width; ++k) sum += table->weights[row * table->width + k];
                EXPECT_NEAR(sum, 1, 1e-14) << name;
            }
        }
        EXPECT_THROW((void)grammar.fuse(0, all), std::invalid_argument);
        EXPECT_THROW((void)grammar.fuse(1, {}), std::invalid_argument);
    }
}

} // namespace
} // namespace internode
