// SPDX-License-Identifier: MIT

#include "internode/interval/class_graph.h"
#include "internode/interval/class_radius.h"

#include "tests/fixtures/interval_grammars.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using tests::make_grammar;
using tests::with_axiom;

TEST(ClassGraph, LeavesOutSymbolsThatCannotOccur) {
    const ClassGraph graph = class_graph(with_axiom(make_grammar({{"A", "A B"}, {"B", "B C"}, {"C", "B"}}), "B C"));
    EXPECT_THAT(graph.matrix[0], IsEmpty());
    EXPECT_THAT(graph.class_of, ElementsAre(no_class, 0, 0));
    ASSERT_EQ(graph.classes.size(), 1U);
    EXPECT_THAT(graph.classes.front().members, ElementsAre(1, 2));
    EXPECT_TRUE(graph.classes.front().final);
}

TEST(LargestRadius, IsNoneWithoutClasses) {
    EXPECT_THAT(class_radii(ClassGraph(), {}), IsEmpty());
    EXPECT_THROW((void)largest_radius({}), std::invalid_argument);
}

} // namespace
} // namespace internode
