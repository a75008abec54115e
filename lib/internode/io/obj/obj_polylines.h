// SPDX-License-Identifier: MIT
//
// Polylines of a Wavefront OBJ file, as write_obj (io/obj/obj.h) and other programs write them: `v x y z` and `l`.
//
// A polyline whose last index is its first is closed. Lines that are pieces of one polyline, each beginning where the
// one before ended, are put together. These are lines of two indices (an edge a line), and those after one of 256, the
// longest that write_obj makes. Every index is checked where it stands, as in obj_freeform.h.

#pragma once

#include "internode/io/obj/obj_freeform.h"
#include "internode/io/polygon.h"

#include <string_view>

namespace internode {

/// Whether the text has a polyline and no curve or surface of free form.
[[nodiscard]] bool has_only_polylines(std::string_view text);

/// Each a polygon of three coordinates, open or closed, with the line of its first `l`. Never throws on any text (but
/// std::bad_alloc). Cost: linear in the text.
[[nodiscard]] ParsedPolygons read_obj_polylines(std::string_view text, std::string_view source,
                                                const ObjLimits& limits = {});

} // namespace internode
