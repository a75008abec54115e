// SPDX-License-Identifier: MIT

#include "internode/report/picture/graph_dot.h"
#include "internode/report/picture/graph_picture.h"
#include "tests/report/picture/drawn_points.h"
#include "tests/report/systems.h"

#include <algorithm>
#include <map>

namespace internode {
namespace {

using tests::DrawnShape;
using tests::Spot;

/// The box of a word as it is drawn.
struct WordBox {
    std::string word;
    Spot corner;
    double width = 0;
    double height = 0;
    std::string stroke;
};

std::vector<WordBox> boxes_of(const std::vector<DrawnShape>& shapes) {
    std::vector<WordBox> boxes;
    for (const DrawnShape& shape : shapes_in(shapes, "words")) {
        if (shape.name == "rect")
            boxes.push_back({"", shape.at, shape.number("width"), shape.number("height"), shape.attribute("stroke")});
        else
            boxes.back().word = shape.text;
    }
    return boxes;
}

/// Which box a spot is at the border of; arrows keep two pixels away from it.
std::size_t box_at(const std::vector<WordBox>& boxes, Spot spot) {
    for (std::size_t v = 0; v < boxes.size(); ++v) {
        const double across = std::abs(spot.x - boxes[v].corner.x - boxes[v].width / 2) - boxes[v].width / 2 - 2;
        const double along = std::abs(spot.y - boxes[v].corner.y - boxes[v].height / 2) - boxes[v].height / 2 - 2;
        if (std::abs(std::max(across, along)) < 0.02) return v;
    }
    ADD_FAILURE() << "an arrow that ends at no word";
    return boxes.size();
}

std::vector<std::pair<std::size_t, std::size_t>> drawn_arcs(const std::vector<DrawnShape>& shapes,
                                                            const std::vector<WordBox>& boxes) {
    std::vector<std::pair<std::size_t, std::size_t>> arcs;
    for (const DrawnShape& shape : shapes) {
        if (shape.name != "path" || shape.attribute("marker-end").empty()) continue;
        EXPECT_EQ(shape.runs.size(), 1U);
        const tests::Run& run = shape.runs.front();
        const std::size_t from = box_at(boxes, run.points.front());
        const std::size_t to = box_at(boxes, run.points.back());
        EXPECT_EQ(run.commands, from == to ? "C" : "Q");
        EXPECT_EQ(shape.attribute("stroke"), boxes.at(from).stroke) << "an arrow is as its word";
        arcs.emplace_back(from, to);
    }
    std::ranges::sort(arcs);
    return arcs;
}

TEST(GraphDrawing, ArrowsLeadFromWordsToTheFactorsOfTheirImages) {
    std::size_t compared = 0;
    for (const std::string& text : {testing_report::fibonacci, testing_report::slow_growth}) {
        const IntervalGrammar grammar = testing_report::grammar_of(text);
        for (std::size_t letters = 1; letters <= 3; ++letters) {
            const FactorGraph graph =
                factor_graph(grammar.rules, all_words(grammar.alphabet.size(), letters, 1000), 1000);
            const std::vector<DrawnShape> shapes =
                tests::shapes_of(tests::read_markup(graph_picture(graph, grammar.alphabet, "t", {"0", "x"})));
            const std::vector<WordBox> boxes = boxes_of(shapes);
            ASSERT_EQ(boxes.size(), graph.words.size());
            std::vector<std::pair<std::size_t, std::size_t>> arcs;
            for (std::size_t v = 0; v < graph.words.size(); ++v) {
                EXPECT_EQ(boxes[v].word, to_string(graph.words[v], grammar.alphabet));
                EXPECT_EQ(boxes[v].stroke, graph.persistent[v] ? "#0077bb" : "#8a8a8a");
                for (const CountedArc& arc : counted_arcs(graph.arcs[v])) arcs.emplace_back(v, arc.target);
            }
            std::ranges::sort(arcs);
            EXPECT_EQ(drawn_arcs(shapes, boxes), arcs);
            compared += arcs.size();
        }
    }
    EXPECT_GT(compared, 50U);
}

TEST(GraphDrawing, WordsStandClockwiseFromTheTopInsideThePicture) {
    const IntervalGrammar grammar = testing_report::grammar_of(testing_report::fibonacci);
    const FactorGraph graph = factor_graph(grammar.rules, all_words(2, 3, 8), 8);
    const tests::Element root = tests::read_markup(graph_picture(graph, grammar.alphabet, "t", {"0", "x"}));
    const std::vector<WordBox> boxes = boxes_of(tests::shapes_of(root));
    Spot middle;
    for (const WordBox& box : boxes) {
        middle.x += (box.corner.x + box.width / 2) / static_cast<double>(boxes.size());
        middle.y += (box.corner.y + box.height / 2) / static_cast<double>(boxes.size());
        EXPECT_TRUE(0 <= box.corner.x && box.corner.x + box.width <= root.number("width"));
        EXPECT_TRUE(0 <= box.corner.y && box.corner.y + box.height <= root.number("height"));
    }
    for (std::size_t v = 0; v < boxes.size(); ++v) {
        const double angle = 2 * 3.14159265358979 * static_cast<double>(v) / static_cast<double>(boxes.size());
        const double x = boxes[v].corner.x + boxes[v].width / 2 - middle.x;
        const double y = boxes[v].corner.y + boxes[v].height / 2 - middle.y;
        EXPECT_NEAR(x / std::hypot(x, y), std::sin(angle), 1e-3);
        EXPECT_NEAR(y / std::hypot(x, y), -std::cos(angle), 1e-3);
    }
}

} // namespace
} // namespace internode
