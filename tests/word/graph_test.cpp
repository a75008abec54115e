// SPDX-License-Identifier: MIT

#include "internode/word/graph.h"
#include "tests/fixtures/words.h"
#include "tests/reference/persistent_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

using namespace internode;
using testing::ElementsAre;

namespace {

/// All 2^(n^2) graphs of n nodes, arc i -> j when bit i n + j is set.
Graph graph_of(std::size_t n, unsigned bits) {
    Graph graph(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            if ((bits >> (i * n + j) & 1U) != 0) graph[i].push_back(static_cast<std::uint32_t>(j));
    return graph;
}

/// The greatest common divisor of the lengths up to n of the closed walks through a node.
std::size_t slow_period(const Graph& graph, std::uint32_t node) {
    std::size_t divisor = 0;
    std::vector<bool> here(graph.size(), false);
    here[node] = true;
    for (std::size_t length = 1; length <= graph.size() * graph.size(); ++length) {
        std::vector<bool> next(graph.size(), false);
        for (std::size_t i = 0; i < graph.size(); ++i)
            for (const std::uint32_t j : graph[i])
                if (here[i]) next[j] = true;
        here = next;
        if (here[node]) divisor = std::gcd(divisor, length);
    }
    return divisor;
}

template<typename Check>
void for_all_small_graphs(Check check) {
    for (std::size_t n = 0; n <= 3; ++n)
        for (unsigned bits = 0; bits < 1U << (n * n); ++bits) check(graph_of(n, bits));
    for (unsigned bits = 0; bits < 1U << 16; bits += 7) check(graph_of(4, bits));
}

} // namespace

TEST(StrongComponents, AreTheClassesOfMutualReachability) {
    for_all_small_graphs([](const Graph& graph) {
        const StrongComponents result = strong_components(graph);
        const auto walks = reference::walks(graph);
        for (std::size_t i = 0; i < graph.size(); ++i)
            for (std::size_t j = 0; j < graph.size(); ++j)
                ASSERT_EQ(result.component[i] == result.component[j], i == j || (walks[i][j] && walks[j][i]));
    });
}

TEST(StrongComponents, ListEachMemberOnceAscendingAndSuccessorsFirst) {
    for_all_small_graphs([](const Graph& graph) {
        const StrongComponents result = strong_components(graph);
        std::size_t count = 0;
        for (std::size_t c = 0; c < result.members.size(); ++c) {
            ASSERT_TRUE(std::ranges::is_sorted(result.members[c]));
            for (const std::uint32_t node : result.members[c]) ASSERT_EQ(result.component[node], c);
            count += result.members[c].size();
        }
        ASSERT_EQ(count, graph.size());
        for (std::size_t i = 0; i < graph.size(); ++i)
            for (const std::uint32_t j : graph[i]) ASSERT_LE(result.component[j], result.component[i]);
    });
}

TEST(StrongComponents, AreFinalWithoutAnArcOutAndCyclicWithAWalkBack) {
    for_all_small_graphs([](const Graph& graph) {
        const StrongComponents result = strong_components(graph);
        const auto walks = reference::walks(graph);
        std::vector<bool> final(result.members.size(), true);
        for (std::size_t i = 0; i < graph.size(); ++i) {
            for (const std::uint32_t j : graph[i])
                if (result.component[i] != result.component[j]) final[result.component[i]] = false;
            ASSERT_EQ(result.cyclic[result.component[i]], walks[i][i]);
        }
        ASSERT_EQ(result.final, final);
    });
}

TEST(StrongComponents, DoNotMindRepeatedArcs) {
    const StrongComponents result = strong_components({{1, 1}, {0, 0, 1}, {1, 1}});
    EXPECT_THAT(result.component, ElementsAre(0, 0, 1));
}

TEST(StrongComponents, OfAPathOfAMillionNodesNeedNoDeepStack) {
    Graph path(1'000'000);
    for (std::uint32_t i = 0; i + 1 < path.size(); ++i) path[i].push_back(i + 1);
    EXPECT_EQ(strong_components(path).members.size(), path.size());
    path.back().push_back(0);
    const StrongComponents cycle = strong_components(path);
    EXPECT_EQ(cycle.members.size(), 1U);
    EXPECT_EQ(period(path, cycle, 0), path.size());
}

TEST(Period, IsTheCommonDivisorOfTheCycleLengths) {
    for_all_small_graphs([](const Graph& graph) {
        const StrongComponents result = strong_components(graph);
        for (std::size_t c = 0; c < result.members.size(); ++c)
            ASSERT_EQ(period(graph, result, c), slow_period(graph, result.members[c].front()));
    });
}

TEST(Period, RefusesAComponentThatIsNotThere) {
    EXPECT_THROW((void)period({{0}}, strong_components({{0}}), 1), std::out_of_range);
}

TEST(Reachable, HoldsTheStartAndAllThatWalksReach) {
    for_all_small_graphs([](const Graph& graph) {
        const auto walks = reference::walks(graph);
        for (std::uint32_t i = 0; i < graph.size(); ++i) {
            const std::vector<bool> reached = reachable(graph, {i, i});
            for (std::size_t j = 0; j < graph.size(); ++j) ASSERT_EQ(reached[j], i == j || walks[i][j]);
        }
    });
    EXPECT_THAT(reachable({{1}, {0}}, {}), ElementsAre(false, false));
}
