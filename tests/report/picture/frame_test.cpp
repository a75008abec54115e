// SPDX-License-Identifier: MIT

#include "internode/report/picture/frame.h"
#include "internode/report/picture/panels.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace internode {
namespace {

TEST(Frame, ABoxIsTheSmallestAroundItsPointsInQuarters) {
    PlaneBox box;
    EXPECT_TRUE(box.is_empty());
    box.include(std::vector<Point2>{{4, 8}, {-4, 12}});
    box.include(std::vector<Point2>{{0, -4}});
    EXPECT_FALSE(box.is_empty());
    EXPECT_EQ(box.least.x, -1);
    EXPECT_EQ(box.least.y, -1);
    EXPECT_EQ(box.greatest.x, 1);
    EXPECT_EQ(box.greatest.y, 3);
    EXPECT_EQ(box.size().y, 4);
    EXPECT_EQ(box.middle().y, 1);
}

TEST(Frame, NoDifferenceOverflows) {
    constexpr double largest = std::numeric_limits<double>::max();
    PlaneBox box;
    box.include(std::vector<Point2>{{-largest, -largest}, {largest, largest}});
    const Point2 scale = filling_scale(box.size(), {.x = 100, .y = 100}, Units::Equal);
    const Frame frame{.anchor = box.middle(), .at = {.x = 50, .y = 50}, .scale = scale};
    EXPECT_NEAR(frame.pixel({-largest, -largest}).x, 0, 1e-9);
    EXPECT_NEAR(frame.pixel({largest, largest}).x, 100, 1e-9);
    EXPECT_NEAR(frame.pixel({largest, largest}).y, 0, 1e-9) << "up is up";
}

TEST(Frame, TheScaleFillsTheRoomAndNeverLeavesIt) {
    EXPECT_EQ(filling_scale({.x = 2, .y = 10}, {.x = 100, .y = 100}, Units::Equal).x, 10);
    EXPECT_EQ(filling_scale({.x = 10, .y = 2}, {.x = 100, .y = 100}, Units::Equal).y, 10);
    EXPECT_EQ(filling_scale({.x = 2, .y = 10}, {.x = 100, .y = 100}, Units::Apart).x, 50);
    EXPECT_EQ(filling_scale({.x = 2, .y = 10}, {.x = 100, .y = 100}, Units::Apart).y, 10);
    EXPECT_EQ(filling_scale({.x = 0, .y = 10}, {.x = 100, .y = 100}, Units::Equal).x, 10) << "as the other direction";
    EXPECT_EQ(filling_scale({.x = 10, .y = 0}, {.x = 100, .y = 100}, Units::Equal).y, 10);
    EXPECT_EQ(filling_scale({.x = 0, .y = 0}, {.x = 100, .y = 100}, Units::Equal).x, 0);
}

TEST(Panels, AreCutWhereNoiseLeavesThem) {
    PlaneBox box;
    box.include(std::vector<Point2>{{0, 0}, {4, 4}});
    const PanelGrid grid = panel_grid(2, 100, box, {.x = 100, .y = 100});
    const Point2 far = grid.pixel({1e300, -1e300});
    EXPECT_EQ(far.x, 2 * grid.size.x);
    EXPECT_EQ(far.y, 2 * grid.size.y);
    EXPECT_EQ(grid.pixel({2, 2}).x, grid.size.x / 2) << "the middle of the box in the middle of the panel";
    EXPECT_EQ(grid.pixel({2, 2}).y, grid.size.y / 2);
}

TEST(Panels, HaveTheShapeOfTheirBoxNeitherFlatNorTall) {
    EXPECT_EQ(panel_height(100, {.x = 10, .y = 5}, false), 50);
    EXPECT_EQ(panel_height(100, {.x = 10, .y = 0.1}, false), 10);
    EXPECT_EQ(panel_height(100, {.x = 1, .y = 100}, false), 160);
    EXPECT_EQ(panel_height(100, {.x = 0, .y = 100}, false), 45);
    EXPECT_EQ(panel_height(100, {.x = 10, .y = 5}, true), 45);
}

} // namespace
} // namespace internode
