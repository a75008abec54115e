// SPDX-License-Identifier: MIT

#include "internode/report/picture/tree_layout.h"

#include <gtest/gtest.h>

namespace internode {
namespace {

StepRecord step(std::vector<std::size_t> parent) {
    StepRecord record;
    record.read.resize(parent.size());
    record.rule.resize(parent.size());
    record.parent = std::move(parent);
    return record;
}

TEST(TreeLayout, ChildrenStandBelowTheirParent) {
    const std::vector<StepRecord> steps{step({0, 0, 1}), step({0, 1, 1, 1, 2})};
    const std::vector<std::size_t> sizes{2, 3, 5};
    const TreeLayout layout = tree_layout(sizes, steps, {{1, 1, 1}, {1, 1, 1, 1, 1}});
    EXPECT_EQ(layout.width, 5);
    EXPECT_EQ(layout.centre[0], (std::vector<double>{2, 4.5}));
    EXPECT_EQ(layout.centre[1], (std::vector<double>{0.5, 2.5, 4.5}));
    EXPECT_EQ(layout.centre[2], (std::vector<double>{0.5, 1.5, 2.5, 3.5, 4.5}));
}

TEST(TreeLayout, ErasedModulesKeepTheirPlace) {
    const std::vector<StepRecord> steps{step({1})};
    const std::vector<std::size_t> sizes{3, 1};
    const TreeLayout layout = tree_layout(sizes, steps, {{1}});
    EXPECT_EQ(layout.centre[0], (std::vector<double>{0.5, 1.5, 2.5}));
    EXPECT_EQ(layout.centre[1], (std::vector<double>{1.5}));
}

TEST(TreeLayout, SuccessorsOfAStrictPredecessorOfTwoStandBetweenThem) {
    const std::vector<StepRecord> steps{step({0, 2})};
    const std::vector<std::size_t> sizes{4, 2};
    const TreeLayout layout = tree_layout(sizes, steps, {{2, 2}});
    EXPECT_EQ(layout.centre[0], (std::vector<double>{0.5, 1.5, 2.5, 3.5}));
    EXPECT_EQ(layout.centre[1], (std::vector<double>{1, 3}));
}

TEST(TreeLayout, APredecessorAcrossTheSeamEndsAtTheSeam) {
    const std::vector<StepRecord> steps{step({1, 3})};
    const std::vector<std::size_t> sizes{4, 2};
    const TreeLayout layout = tree_layout(sizes, steps, {{2, 2}});
    EXPECT_EQ(layout.centre[1], (std::vector<double>{2, 3.5}));
}

} // namespace
} // namespace internode
