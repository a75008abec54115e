// SPDX-License-Identifier: MIT

#include "internode/report/picture/graph_dot.h"

#include "tests/report/systems.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using ::testing::HasSubstr;

TEST(GraphDot, HasANodePerWordAndAnArcPerTarget) {
    const IntervalGrammar grammar = testing_report::grammar_of("A -> A A");
    const FactorGraph graph = factor_graph(grammar.rules, all_words(1, 2, 10), 10);
    const std::string text = graph_dot(graph, grammar.alphabet, {"0.1.0", "internode"});
    EXPECT_THAT(text, HasSubstr("w0 [label=\"AA\", color=\"#0077bb\""));
    EXPECT_THAT(text, HasSubstr("w0 -> w0 [label=\"×3\"];"));
}

TEST(GraphDot, CountsArcsInOrderOfTheirFirst) {
    const std::vector<CountedArc> arcs = counted_arcs({3, 1, 3, 3});
    ASSERT_EQ(arcs.size(), 2U);
    EXPECT_EQ(arcs[0].target, 3U);
    EXPECT_EQ(arcs[0].count, 3U);
    EXPECT_EQ(arcs[1].count, 1U);
}

TEST(GraphDot, NamesAreText) {
    const IntervalGrammar grammar = testing_report::hostile_grammar();
    const FactorGraph graph = factor_graph(grammar.rules, all_words(2, 2, 10), 10);
    testing_report::expect_inert(graph_dot(graph, grammar.alphabet, {"0", testing_report::hostile}));
}

} // namespace
} // namespace internode
