// SPDX-License-Identifier: MIT
//
// A free form of an OBJ file as what other formats give: a polygon or a grid, with knots and weights.

#pragma once

#include "internode/io/json/input_grid.h"
#include "internode/io/obj/obj_freeform.h"
#include "internode/io/polygon.h"

namespace internode {

/// A curve as a control polygon of dimension 3 with its knots, and weights when it is rational.
/// \throw std::invalid_argument for a surface
[[nodiscard]] InputPolygon free_form_polygon(const FreeFormFile& file, const FreeForm& curve);

/// A surface as a grid with the knots of both sides: rows along u, homogeneous points when it is rational.
/// \throw std::invalid_argument for a curve
[[nodiscard]] InputGrid free_form_grid(const FreeFormFile& file, const FreeForm& surface);

} // namespace internode
