// SPDX-License-Identifier: MIT

#include "internode/curve/reverse/resampling.h"

#include <gmock/gmock.h>
#include <stdexcept>

namespace internode {
namespace {

using ::testing::ElementsAre;

// A square of side 2, one edge with its middle.
const std::vector<double> square{0, 0, 1, 0, 2, 0, 2, 2, 0, 2};

TEST(Resampling, PutsPointsAtEqualStepsOfTheChordLength) {
    EXPECT_THAT(resampled(square, 2, Ends::Circular, 4).points, ElementsAre(0, 0, 2, 0, 2, 2, 0, 2));
    EXPECT_THAT(resampled(square, 2, Ends::Circular, 8).points,
                ElementsAre(0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1));
    EXPECT_THAT(resampled(square, 2, Ends::Open, 4).points, ElementsAre(0, 0, 2, 0, 2, 2, 0, 2));
    EXPECT_EQ(resampled(square, 2, Ends::Open, 4).spacing, Spacing::ChordLength);
}

TEST(Resampling, KeepsTheEndsOfAnOpenPolygonExactly) {
    const std::vector<double> points{0.1, 0.7, 0.3, 0.9, 1.1, -0.7};
    for (std::size_t count = 2; count < 40; ++count) {
        const std::vector<double> fine = resampled(points, 2, Ends::Open, count).points;
        ASSERT_EQ(fine.size(), 2 * count);
        EXPECT_THAT(std::vector<double>(fine.begin(), fine.begin() + 2), ElementsAre(0.1, 0.7));
        EXPECT_THAT(std::vector<double>(fine.end() - 2, fine.end()), ElementsAre(1.1, -0.7));
    }
    EXPECT_THAT(resampled(points, 2, Ends::Open, 1).points, ElementsAre(0.1, 0.7));
}

TEST(Resampling, StepsByIndexWhereThereIsNoChordLength) {
    const ResampledPolygon signal = resampled(std::vector<double>{0, 10, 11}, 1, Ends::Open, 5);
    EXPECT_EQ(signal.spacing, Spacing::Index);
    EXPECT_THAT(signal.points, ElementsAre(0, 5, 10, 10.5, 11));
    const ResampledPolygon same = resampled(std::vector<double>{3, 4, 3, 4}, 2, Ends::Circular, 3);
    EXPECT_EQ(same.spacing, Spacing::Index);
    EXPECT_THAT(same.points, ElementsAre(3, 4, 3, 4, 3, 4));
    EXPECT_THAT(resampled(std::vector<double>{3, 4}, 2, Ends::Open, 2).points, ElementsAre(3, 4, 3, 4));
}

TEST(Resampling, PassesOverRepeatedPoints) {
    const std::vector<double> points{0, 0, 0, 0, 2, 0, 2, 0, 4, 0};
    EXPECT_THAT(resampled(points, 2, Ends::Open, 5).points, ElementsAre(0, 0, 1, 0, 2, 0, 3, 0, 4, 0));
}

TEST(Resampling, CutsFromTheEnd) {
    EXPECT_THAT(cut(square, 2, 2), ElementsAre(0, 0, 1, 0));
    EXPECT_THROW((void)cut(square, 2, 6), std::invalid_argument);
}

TEST(Resampling, FitsAsItIsAskedAndSaysWhatWasDone) {
    const FittedPolygon same = fitted(square, 2, Ends::Circular, Fit::Cut, square.size() / 2);
    EXPECT_EQ(same.points, square);
    EXPECT_EQ(same.fitting.fit, Fit::AsMeasured);
    const FittedPolygon fewer = fitted(square, 2, Ends::Circular, Fit::Cut, 2);
    EXPECT_EQ(fewer.points, cut(square, 2, 2));
    EXPECT_EQ(fewer.fitting.fit, Fit::Cut);
    EXPECT_EQ(fewer.fitting.measured, square.size() / 2);
    EXPECT_EQ(fewer.fitting.points, 2U);
    const FittedPolygon more = fitted(square, 2, Ends::Circular, Fit::Resampled, 9);
    EXPECT_EQ(more.points, resampled(square, 2, Ends::Circular, 9).points);
    EXPECT_EQ(more.fitting.fit, Fit::Resampled);
    EXPECT_EQ(fitted(std::vector<double>{1, 2, 4}, 1, Ends::Open, Fit::Resampled, 5).fitting.spacing, Spacing::Index);
    EXPECT_THROW((void)fitted(square, 2, Ends::Open, Fit::Cut, 99), std::invalid_argument);
    EXPECT_THROW((void)fitted({}, 2, Ends::Open, Fit::Cut, 1), std::invalid_argument);
}

TEST(Resampling, RefusesWhatIsNoPolygon) {
    EXPECT_THROW((void)resampled({}, 2, Ends::Open, 3), std::invalid_argument);
    EXPECT_THROW((void)resampled(square, 3, Ends::Open, 3), std::invalid_argument);
    EXPECT_THROW((void)resampled(square, 2, Ends::Open, 0), std::invalid_argument);
    EXPECT_THROW((void)cut(square, 0, 1), std::invalid_argument);
}

} // namespace
} // namespace internode
