// SPDX-License-Identifier: MIT
//
// A vertex is left out when it is nearer to the last one that was drawn than an eye can tell.

#include "internode/report/picture/polygon_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {
namespace {

constexpr double nearest_vertices = 0.35; // pixels; closer ones are one to the eye

} // namespace

void append_polygon(std::string& path, std::span<const Point2> pixels, bool closed) {
    assert(std::ranges::all_of(pixels, [](Point2 pixel) { return std::isfinite(pixel.x) && std::isfinite(pixel.y); }));
    Point2 last;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Point2 pixel = pixels[i];
        const bool near = std::max(std::abs(pixel.x - last.x), std::abs(pixel.y - last.y)) < nearest_vertices;
        if (i > 0 && i + 1 < pixels.size() && near) continue;
        path += i == 0 ? 'M' : 'L';
        append_point(path, pixel);
        last = pixel;
    }
    if (closed) path += 'Z';
}

} // namespace internode
