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

TEST(ClassGraph, AClassSplitsWhereASymbolBecomesSeveralOfIt) {
    const auto splitting = [](const IntervalGrammar& grammar) {
        std::vector<bool> result;
        for (const IntervalClass& one : class_graph(grammar).classes) result.push_back(splits(one));
        return result;
    };
    EXPECT_THAT(splitting(make_grammar({{"A", "A"}})), ElementsAre(false));
    EXPECT_THAT(splitting(make_grammar({{"A", "A A"}})), ElementsAre(true));
    EXPECT_THAT(splitting(make_grammar({{"A", "B"}, {"B", "A B"}})), ElementsAre(true));
    EXPECT_THAT(splitting(make_grammar({{"A", "B B"}, {"B", "B"}})), ElementsAre(false, false));
}

TEST(ClassRadius, ExactOnesAreOrderedWhateverTheirBounds) {
    ClassRadius two;
    two.field = NumberField({-2, 1}, 2, 2);
    two.value = exact_quantity(Number(2));
    for (const Enclosure& bounds : {Enclosure{1, 2}, Enclosure{1, 3}}) {
        ClassRadius root_of_three;
        root_of_three.field = NumberField({-3, 0, 1}, 1, 2);
        root_of_three.value = enclosed_quantity(bounds);
        EXPECT_EQ(compare(two, root_of_three), std::partial_ordering::greater);
        EXPECT_EQ(compare(root_of_three, two), std::partial_ordering::less);
    }
}

TEST(LargestRadius, IsNoneWithoutClasses) {
    EXPECT_THAT(class_radii(ClassGraph(), {}), IsEmpty());
    EXPECT_THROW((void)largest_radius({}), std::invalid_argument);
}

} // namespace
} // namespace internode
