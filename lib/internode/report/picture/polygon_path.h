// SPDX-License-Identifier: MIT
//
// Path data of a polygon in pixels, without the vertices that the eye cannot tell apart.

#pragma once

#include "internode/report/picture/svg.h"

#include <span>
#include <string>

namespace internode {

/// Appends `M… L… …`, and `Z` when closed. The first and the last vertex are always kept.
void append_polygon(std::string& path, std::span<const Point2> pixels, bool closed);

} // namespace internode
