// SPDX-License-Identifier: MIT
//
// The way from the plane to pixels that all pictures share: y points up in the plane and down on the screen.
//
// A point p stands at the pixel `at` + scale (p/4 − anchor), the second coordinate negated. Boxes, anchors and scales
// are in quarters of the plane's unit, so that no difference of finite numbers overflows; quarters are exact.

#pragma once

#include "internode/report/picture/svg.h"

#include <limits>
#include <span>

namespace internode {

/// Pixels across of every picture with a frame.
inline constexpr double picture_width = 960;

/// The smallest box around points, in quarters.
struct PlaneBox {
    Point2 least{.x = std::numeric_limits<double>::max(), .y = std::numeric_limits<double>::max()};
    Point2 greatest{.x = std::numeric_limits<double>::lowest(), .y = std::numeric_limits<double>::lowest()};

    /// Grows around points of the plane.
    void include(std::span<const Point2> points);
    [[nodiscard]] bool is_empty() const { return least.x > greatest.x; }
    [[nodiscard]] Point2 size() const { return {.x = greatest.x - least.x, .y = greatest.y - least.y}; }
    [[nodiscard]] Point2 middle() const {
        return {.x = least.x / 2 + greatest.x / 2, .y = least.y / 2 + greatest.y / 2};
    }
};

/// Whether a unit to the right and a unit upwards are equally long on the screen; in a graph they are not.
enum class Units { Equal, Apart };

/// Pixels per quarter with which `size` (in quarters) fills `room` (in pixels) without leaving it. A direction without
/// extent follows the other one; without any extent the scale is 0, and all points stand on the anchor.
[[nodiscard]] Point2 filling_scale(Point2 size, Point2 room, Units units);

struct Frame {
    Point2 anchor; ///< a point of the plane, in quarters
    Point2 at;     ///< the pixel of the anchor
    Point2 scale;  ///< pixels per quarter, not negative

    /// Where a point of the plane stands on the screen.
    [[nodiscard]] Point2 pixel(Point2 point) const {
        return {.x = at.x + (point.x / 4 - anchor.x) * scale.x, .y = at.y - (point.y / 4 - anchor.y) * scale.y};
    }
};

} // namespace internode
