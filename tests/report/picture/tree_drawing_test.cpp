// SPDX-License-Identifier: MIT

#include "internode/point/interpreter.h"
#include "internode/point/start_word.h"
#include "internode/report/picture/derivation_tree.h"
#include "tests/fixtures/point_systems.h"
#include "tests/report/picture/drawn_points.h"
#include "tests/report/picture/trees.h"

namespace internode {
namespace {

using testing_report::tree_of;
using tests::DrawnShape;
using tests::point_system;
using tests::Spot;

constexpr double mark_radius = 6.5;
constexpr double mark_gap = 3; // between a mark and its arrows

/// The marks of every word: grammars here have points only, and each module is a circle.
std::vector<std::vector<Spot>> marks_of(const std::vector<DrawnShape>& shapes, const DerivationTree& tree) {
    std::vector<std::vector<Spot>> rows(tree.words.size());
    std::size_t row = 0;
    for (const DrawnShape& shape : shapes) {
        if (shape.name != "circle" || shape.is_in("legend")) continue;
        while (row < rows.size() && rows[row].size() == tree.words[row].size()) ++row;
        if (row == rows.size()) break;
        rows[row].push_back(shape.at);
    }
    return rows;
}

/// The arrow ends at the mark: on the line from its start, just outside.
void expect_ends_at(const tests::Run& arrow, Spot mark) {
    const Spot end = arrow.points.back();
    const Spot start = arrow.points.front();
    EXPECT_NEAR(std::max(std::abs(end.x - mark.x), std::abs(end.y - mark.y)), mark_radius + mark_gap, 0.03);
    const double across = (mark.x - start.x) * (end.y - start.y) - (mark.y - start.y) * (end.x - start.x);
    EXPECT_NEAR(across / std::hypot(mark.x - start.x, mark.y - start.y), 0, 0.05);
    EXPECT_LT(end.y, mark.y) << "from above";
}

tests::Run reversed(tests::Run run) {
    std::ranges::reverse(run.points);
    return run;
}

void expect_starts_at(const tests::Run& arrow, Spot mark) {
    const tests::Run back = reversed(arrow);
    const Spot end = back.points.back();
    EXPECT_NEAR(std::max(std::abs(end.x - mark.x), std::abs(end.y - mark.y)), mark_radius + mark_gap, 0.03);
    EXPECT_GT(end.y, mark.y) << "downwards";
}

std::vector<tests::Run> arrows_in(const std::vector<DrawnShape>& shapes, std::string_view layer) {
    std::vector<tests::Run> arrows;
    for (const DrawnShape& shape : shapes_in(shapes, layer)) {
        EXPECT_EQ(shape.attribute("marker-end"), "url(#head)");
        EXPECT_EQ(shape.attribute("stroke-dasharray").empty(), layer == "successors");
        arrows.push_back(shape.runs.at(0));
    }
    return arrows;
}

TEST(TreeDrawing, RowsStandBelowEachOtherAndModulesFromLeftToRight) {
    const PointSystem system = point_system("points g\naxiom P((0,0)) P((1,0)) P((2,1))\nP(v) -> P(v) P(2 v)\n");
    const DerivationTree tree = tree_of(system, 2);
    const tests::Element root = tests::read_markup(derivation_tree(tree, system));
    const auto rows = marks_of(tests::shapes_of(root), tree);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        ASSERT_EQ(rows[row].size(), 3U << row);
        for (std::size_t i = 0; i < rows[row].size(); ++i) {
            EXPECT_EQ(rows[row][i].y, rows[row][0].y);
            EXPECT_TRUE(mark_radius <= rows[row][i].x && rows[row][i].x <= root.number("width") - mark_radius);
            EXPECT_TRUE(mark_radius <= rows[row][i].y && rows[row][i].y <= root.number("height") - mark_radius);
            if (i > 0) {
                EXPECT_GT(rows[row][i].x, rows[row][i - 1].x);
            }
            if (row > 0 && i % 2 == 1) {
                EXPECT_NEAR((rows[row][i].x + rows[row][i - 1].x) / 2, rows[row - 1][i / 2].x, 0.02);
            }
        }
        if (row > 0) {
            EXPECT_GT(rows[row][0].y, rows[row - 1][0].y + 4 * mark_radius);
        }
    }
}

TEST(TreeDrawing, SolidArrowsLeadFromPredecessorsToSuccessors) {
    const PointSystem system = point_system("points g\naxiom P((0,0)) P((1,0)) P((2,1))\nP(v) -> P(v) P(2 v)\n");
    const DerivationTree tree = tree_of(system, 2);
    const std::vector<DrawnShape> shapes = tests::shapes_of(tests::read_markup(derivation_tree(tree, system)));
    const auto rows = marks_of(shapes, tree);
    const std::vector<tests::Run> arrows = arrows_in(shapes, "successors");
    std::size_t next = 0;
    for (std::size_t row = 0; row + 1 < rows.size(); ++row)
        for (std::size_t child = 0; child < rows[row + 1].size(); ++child, ++next) {
            ASSERT_LT(next, arrows.size());
            expect_starts_at(arrows[next], rows[row][child / 2]);
            expect_ends_at(arrows[next], rows[row + 1][child]);
        }
    EXPECT_EQ(next, arrows.size());
    EXPECT_TRUE(arrows_in(shapes, "contexts").empty()) << "no rule reads a neighbour";
}

/// A rule of a ring that reads one neighbour, and makes one module. The context of the module at the seam stands at the
/// other end of the row; its arrow comes from outside, from the side on which the rule looks.
void expect_contexts_from(std::string_view rule, int side) {
    constexpr std::size_t size = 6;
    const std::string axiom = "P((0,0)) P((1,0)) P((2,1)) P((2,2)) P((1,3)) P((0,2))";
    const PointSystem system = point_system("points r\nring\naxiom " + axiom + "\n" + std::string(rule) + "\n");
    const DerivationTree tree = tree_of(system, 1);
    const std::vector<DrawnShape> shapes = tests::shapes_of(tests::read_markup(derivation_tree(tree, system)));
    const auto rows = marks_of(shapes, tree);
    const std::vector<tests::Run> arrows = arrows_in(shapes, "contexts");
    ASSERT_EQ(arrows.size(), size);
    for (std::size_t child = 0; child < size; ++child) {
        const bool at_seam = child == (side < 0 ? 0 : size - 1);
        const std::size_t neighbour = at_seam ? child : child + static_cast<std::size_t>(side);
        expect_ends_at(arrows[child], rows[1][child]);
        EXPECT_GT(side * (arrows[child].points.front().x - rows[1][child].x), mark_radius) << "from the context's side";
        if (!at_seam) expect_starts_at(arrows[child], rows[0][neighbour]);
    }
}

TEST(TreeDrawing, LeftContextsComeFromTheLeftAcrossTheSeamToo) {
    expect_contexts_from("P(u) < P(v) -> P(1/2 u + 1/2 v)", -1);
}

TEST(TreeDrawing, RightContextsComeFromTheRightAcrossTheSeamToo) {
    expect_contexts_from("P(v) > P(w) -> P(1/2 v + 1/2 w)", 1);
}

TEST(TreeDrawing, BothContextsOfAnOpenWordAreReadFromTheirMarks) {
    const PointSystem system = point_system("points o\naxiom P((0,0)) P((1,0)) P((2,1)) P((2,2))\n"
                                            "P(u) < P(v) > P(w) -> P(1/4 u + 1/2 v + 1/4 w)\n");
    const DerivationTree tree = tree_of(system, 1);
    const std::vector<DrawnShape> shapes = tests::shapes_of(tests::read_markup(derivation_tree(tree, system)));
    const auto rows = marks_of(shapes, tree);
    const std::vector<tests::Run> arrows = arrows_in(shapes, "contexts");
    ASSERT_EQ(arrows.size(), 4U) << "the modules at the ends have no rule that matches";
    for (std::size_t child = 1; child <= 2; ++child) {
        std::vector<double> starts;
        for (std::size_t which = 0; which < 2; ++which) {
            const tests::Run& arrow = arrows[2 * (child - 1) + which];
            expect_ends_at(arrow, rows[1][child]);
            const bool is_left = arrow.points.front().x < rows[1][child].x;
            expect_starts_at(arrow, rows[0][is_left ? child - 1 : child + 1]);
            starts.push_back(arrow.points.front().x);
        }
        EXPECT_GT(std::abs(starts[0] - starts[1]), mark_radius) << "one from each side";
    }
}

/// Equal letters and states have one colour, and the legend says which.
TEST(TreeDrawing, MarksHaveTheColourOfTheirLetterInTheLegend) {
    const PointSystem system = point_system("points s\naxiom P((0,0), 2) Q((1,0)) P((1,0), 0) P((3,0), 2)\n"
                                            "P(v, s) -> P(v, s)\n");
    const DerivationTree tree = tree_of(system, 0);
    std::vector<std::string> fills;
    std::vector<std::string> legend;
    for (const DrawnShape& shape : tests::shapes_of(tests::read_markup(derivation_tree(tree, system))))
        if (shape.name == "circle") (shape.is_in("legend") ? legend : fills).push_back(shape.attribute("fill"));
    ASSERT_EQ(fills.size(), 4U);
    ASSERT_EQ(legend.size(), 3U);
    EXPECT_EQ(fills, (std::vector<std::string>{legend[0], legend[1], legend[2], legend[0]}));
    EXPECT_NE(legend[0], legend[1]);
    EXPECT_NE(legend[1], legend[2]);
}

} // namespace
} // namespace internode
