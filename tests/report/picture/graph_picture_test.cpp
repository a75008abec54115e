// SPDX-License-Identifier: MIT

#include "internode/report/picture/graph_picture.h"

#include "tests/report/systems.h"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>

namespace internode {
namespace {

using ::testing::HasSubstr;

FactorGraph graph_of(const Morphism& rules, std::size_t letters, std::size_t words) {
    std::vector<Word> start = all_words(rules.size(), letters, 1000);
    if (start.size() > words) start.resize(words);
    return factor_graph(rules, start, 1000);
}

struct Box {
    double x, y, width, height;
};

std::vector<Box> boxes_of(const std::string& svg) {
    const std::regex pattern("<rect x=\"([-0-9.]+)\" y=\"([-0-9.]+)\" width=\"([0-9.]+)\" height=\"30\"");
    std::vector<Box> boxes;
    for (std::sregex_iterator match(svg.begin(), svg.end(), pattern), end; match != end; ++match)
        boxes.push_back({std::stod((*match)[1]), std::stod((*match)[2]), std::stod((*match)[3]), 30});
    return boxes;
}

TEST(GraphPicture, NoTwoWordsTouch) {
    const IntervalGrammar grammar = testing_report::grammar_of(testing_report::slow_growth);
    for (std::size_t letters = 1; letters <= 3; ++letters) {
        const FactorGraph graph = graph_of(grammar.rules, letters, 64);
        if (graph.words.size() > max_drawn_words) continue;
        const std::vector<Box> boxes = boxes_of(graph_picture(graph, grammar.alphabet, "slow", testing_report::drawer));
        ASSERT_EQ(boxes.size(), graph.words.size());
        for (std::size_t a = 0; a < boxes.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_TRUE(std::abs(boxes[a].x + boxes[a].width / 2 - boxes[b].x - boxes[b].width / 2) >=
                                (boxes[a].width + boxes[b].width) / 2 ||
                            std::abs(boxes[a].y - boxes[b].y) >= 30);
    }
}

TEST(GraphPicture, PersistentWordsAreBlue) {
    const IntervalGrammar grammar = testing_report::grammar_of(testing_report::fibonacci);
    const std::string svg =
        graph_picture(graph_of(grammar.rules, 3, 8), grammar.alphabet, "fibonacci", testing_report::drawer);
    EXPECT_THAT(svg, HasSubstr("transient"));
    std::size_t blue = 0;
    for (std::size_t at = 0; (at = svg.find("rx=\"15\" fill=\"#d6ebf8\"", at)) != std::string::npos; ++at) ++blue;
    EXPECT_EQ(blue, 4U);
}

TEST(GraphPicture, RefusesMoreWordsThanACircleShows) {
    const IntervalGrammar grammar = testing_report::grammar_of(testing_report::fibonacci);
    EXPECT_NO_THROW((void)graph_picture(graph_of(grammar.rules, 6, 64), grammar.alphabet, "", testing_report::drawer));
    EXPECT_THROW((void)graph_picture(graph_of(grammar.rules, 7, 128), grammar.alphabet, "", testing_report::drawer),
                 std::length_error);
    EXPECT_THROW((void)graph_picture({}, grammar.alphabet, "", testing_report::drawer), std::invalid_argument);
}

TEST(GraphPicture, NamesAreText) {
    const IntervalGrammar grammar = testing_report::hostile_grammar();
    testing_report::expect_inert(graph_picture(graph_of(grammar.rules, 2, 4), grammar.alphabet, testing_report::hostile,
                                               {"0", testing_report::hostile}));
}

} // namespace
} // namespace internode
