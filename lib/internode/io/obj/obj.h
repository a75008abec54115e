// SPDX-License-Identifier: MIT
//
// A polygon as a Wavefront OBJ file: `v x y z` for the points, missing coordinates 0, and `l` for the polyline.

#pragma once

#include "internode/io/file/sink.h"
#include "internode/io/points_view.h"
#include "internode/word/symbol.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace internode {

inline constexpr std::size_t max_obj_dimension = 3;

/// Writes all points; false if the sink failed. A circular polygon ends at its first index; a lone point is a `p`. The
/// polyline is cut into `l` lines of at most 256 indices, each beginning where the one before ended. `comments` come
/// first, a line each, `# ` before them. \throw std::invalid_argument for more than three dimensions, rows that are not
/// whole and numbers that are not finite. `before` vertices stand in the file already: the polygon of another call.
/// `threads` make the lines of the vertices, 0: as many as the machine has.
bool write_obj(Sink& sink, const PointsView& points, Ends ends, std::span<const std::string> comments = {},
               std::size_t before = 0, int threads = 1);

/// One polyline of an OBJ file.
struct ObjPolyline {
    std::vector<std::size_t> points; ///< indices of rows, from 0
    bool closed = false;
};

/// The same for several polylines over the points; one of a single point is a `p`. \throw std::out_of_range for an
/// index without a row, else as above
bool write_obj(Sink& sink, const PointsView& points, std::span<const ObjPolyline> polylines,
               std::span<const std::string> comments = {}, std::size_t before = 0, int threads = 1);

} // namespace internode
