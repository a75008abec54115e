// SPDX-License-Identifier: MIT
//
// A free form of an OBJ file as what other formats give: a polygon with knots and weights.

#pragma once

#include "internode/io/obj_freeform.h"
#include "internode/io/polygon.h"

namespace internode {

/// A curve as a control polygon of dimension 3 with its knots, and weights when it is rational.
/// \throw std::invalid_argument for a surface
[[nodiscard]] InputPolygon free_form_polygon(const FreeFormFile& file, const FreeForm& curve);

} // namespace internode
