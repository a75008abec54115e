// SPDX-License-Identifier: MIT

#include "internode/report/picture/frame.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

/// Pixels per quarter that fill `pixels`; 0 for an extent that is nothing.
double filling(double pixels, double extent) {
    constexpr double nothing = 1e-300; // below, the scale would overflow
    return extent > nothing ? pixels / extent : 0;
}

} // namespace

void PlaneBox::include(std::span<const Point2> points) {
    for (const Point2& point : points) {
        assert(std::isfinite(point.x) && std::isfinite(point.y));
        least = {.x = std::min(least.x, point.x / 4), .y = std::min(least.y, point.y / 4)};
        greatest = {.x = std::max(greatest.x, point.x / 4), .y = std::max(greatest.y, point.y / 4)};
    }
}

Point2 filling_scale(Point2 size, Point2 room, Units units) {
    assert(size.x >= 0 && size.y >= 0 && "the size of a box with points");
    assert(room.x > 0 && room.y > 0);
    const double across = filling(room.x, size.x);
    const double up = filling(room.y, size.y);
    if (units == Units::Apart) return {.x = across, .y = up};
    const double scale = across == 0 ? up : up == 0 ? across : std::min(across, up);
    return {.x = scale, .y = scale};
}

} // namespace internode
