// SPDX-License-Identifier: MIT

#include "internode/curve/gather.h"

#include <gmock/gmock.h>
#include <limits>

namespace internode {
namespace {

using ::testing::ElementsAre;

std::vector<double> rows(Parents& parents, std::ptrdiff_t first, std::size_t count) {
    const double* row = parents.rows(first);
    return {row, row + count};
}

TEST(Gather, ReadsConsecutiveRowsInPlace) {
    const std::vector<double> points{1, 2, 3, 4, 5, 6};
    Parents parents(points, 2, 2);
    EXPECT_EQ(parents.rows(1), points.data() + 2);
    EXPECT_THAT(rows(parents, 1, 4), ElementsAre(3, 4, 5, 6));
}

TEST(Gather, WrapsAtBothEnds) {
    const std::vector<double> points{1, 2, 3};
    Parents parents(points, 1, 2);
    EXPECT_THAT(rows(parents, 2, 2), ElementsAre(3, 1));
    EXPECT_THAT(rows(parents, -1, 2), ElementsAre(3, 1));
    EXPECT_THAT(rows(parents, -3, 2), ElementsAre(1, 2));
}

TEST(Gather, WrapsMoreThanOnce) {
    const std::vector<double> points{1, 2};
    Parents parents(points, 1, 5);
    EXPECT_THAT(rows(parents, -5, 5), ElementsAre(2, 1, 2, 1, 2));
}

TEST(Gather, CombinesEachCoordinate) {
    const std::vector<double> points{1, 10, 2, 20, 4, 40};
    const std::vector<double> weights{0.5, 0.25, 0.25};
    std::vector<double> out(2);
    combine(weights, points.data(), 2, out.data());
    EXPECT_THAT(out, ElementsAre(2, 20));
}

TEST(Gather, ASingleOneCopiesExactly) {
    const std::vector<double> points{std::numeric_limits<double>::max(), 0.1, -std::numeric_limits<double>::max()};
    double out = 1;
    combine(std::vector<double>{0, 1, 0}, points.data(), 1, &out);
    EXPECT_EQ(out, 0.1);
}

} // namespace
} // namespace internode
