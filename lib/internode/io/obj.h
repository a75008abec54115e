// SPDX-License-Identifier: MIT
//
// A polygon as a Wavefront OBJ file: `v x y z` for the points, missing coordinates 0, and `l` for the polyline.

#pragma once

#include "internode/io/points_view.h"
#include "internode/io/sink.h"
#include "internode/word/symbol.h"

#include <span>
#include <string>

namespace internode {

inline constexpr std::size_t max_obj_dimension = 3;

/// Writes all points; false if the sink failed. A circular polygon ends at its first index; a lone point is a `p`. The
/// polyline is cut into `l` lines of at most 256 indices, each beginning where the one before ended. `comments` come
/// first, a line each, `# ` before them. \throw std::invalid_argument for more than three dimensions, rows that are not
/// whole and numbers that are not finite
bool write_obj(Sink& sink, const PointsView& points, Ends ends, std::span<const std::string> comments = {});

} // namespace internode
