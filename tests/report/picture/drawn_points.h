// SPDX-License-Identifier: MIT
//
// Compares what is drawn with the points it was drawn from: one scale to the right, one upwards, and nothing turned
// over.

#pragma once

#include "internode/report/picture/svg.h"
#include "tests/fixtures/drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace internode::testing_report {

/// Pixels are written with two decimals.
inline constexpr double written_exactly = 0.011;

/// x' = x + right * p.x, y' = y - up * p.y
struct WayToScreen {
    double right = 0;
    double up = 0;
    double x = 0;
    double y = 0;

    [[nodiscard]] tests::Spot operator()(Point2 point) const {
        return {.x = x + right * point.x, .y = y - up * point.y};
    }
};

/// The way by which points have become spots, found from the two furthest points of each direction.
inline WayToScreen way_of(const std::vector<Point2>& points, const std::vector<tests::Spot>& spots) {
    if (points.size() != spots.size() || points.empty()) {
        ADD_FAILURE() << points.size() << " points, " << spots.size() << " drawn";
        return {};
    }
    const auto at = [&](auto place) { return spots[static_cast<std::size_t>(place - points.begin())]; };
    const auto [left, right] = std::ranges::minmax_element(points, {}, &Point2::x);
    const auto [low, high] = std::ranges::minmax_element(points, {}, &Point2::y);
    WayToScreen way;
    way.right = (at(right).x - at(left).x) / (right->x - left->x);
    way.up = -(at(high).y - at(low).y) / (high->y - low->y);
    EXPECT_GT(way.right, 0) << "right in the plane is right on the screen";
    EXPECT_GT(way.up, 0) << "up in the plane is up on the screen";
    way.x = at(left).x - way.right * left->x;
    way.y = at(low).y + way.up * low->y;
    return way;
}

inline void expect_near(tests::Spot drawn, tests::Spot expected, double tolerance = 3 * written_exactly) {
    EXPECT_NEAR(drawn.x, expected.x, tolerance);
    EXPECT_NEAR(drawn.y, expected.y, tolerance);
}

/// Every point in its order, along one way.
inline void expect_drawn(const std::vector<Point2>& points, const std::vector<tests::Spot>& spots,
                         const WayToScreen& way) {
    ASSERT_EQ(points.size(), spots.size());
    for (std::size_t i = 0; i < points.size(); ++i) expect_near(spots[i], way(points[i]));
}

/// Points of many coordinates in a row as points of the plane.
inline std::vector<Point2> plane_points(const std::vector<double>& rows, std::size_t dimension = 2) {
    std::vector<Point2> points;
    for (std::size_t row = 0; row + 1 < rows.size(); row += dimension)
        points.push_back({.x = rows[row], .y = rows[row + 1]});
    return points;
}

/// The starts of all runs: dots are lines without length.
inline std::vector<tests::Spot> dots_of(const tests::DrawnShape& path) {
    std::vector<tests::Spot> spots;
    for (const tests::Run& run : path.runs) {
        EXPECT_EQ(run.commands, "h");
        spots.push_back(run.points.front());
    }
    return spots;
}

/// Corners stand in rows of `columns`, from left to right and from top to bottom, and panels do not touch.
inline void expect_reading_order(const std::vector<tests::Spot>& corners, std::size_t columns, double width,
                                 double height) {
    for (std::size_t place = 0; place < corners.size(); ++place) {
        const std::size_t column = place % columns;
        const std::size_t row = place / columns;
        EXPECT_EQ(corners[place].x, corners[column].x) << "panel " << place;
        EXPECT_EQ(corners[place].y, corners[row * columns].y) << "panel " << place;
        if (column > 0) {
            EXPECT_GE(corners[place].x, corners[place - 1].x + width);
        }
        if (row > 0) {
            EXPECT_GE(corners[place].y, corners[place - columns].y + height);
        }
        EXPECT_GE(corners[place].x, 0);
        EXPECT_LE(corners[place].x + width, 960);
    }
    // As many side by side as there is room for: the next one would leave the picture.
    if (corners.size() >= columns) {
        EXPECT_GT(corners[columns - 1].x + 2 * width, 960);
    }
}

} // namespace internode::testing_report
