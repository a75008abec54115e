// SPDX-License-Identifier: MIT
//
// Points of the surface itself, by exact rows: at the pairs of distinct knots, with normals.
//
// The position at a pair of knots is a combination of (d_u + 1)(d_v + 1) control points, the product of one row of
// weights in each direction. Tangents are those of the given grid (surface/normal_rows.h). Rational: S = A / w, and S_u
// is parallel to A_u - w_u S. The normal is S_u × S_v made of length 1; at a knot where the surface has an edge, that
// of the face after it. Where one tangent vanishes, as at a pole, S_uv takes its place: the limit of the normals
// nearby.

#pragma once

#include "internode/surface/sheet.h"

#include <vector>

namespace internode {

enum class Normals { None, Unit };

struct SurfaceLimit {
    std::vector<double>
        parameters_u; ///< parameter of each row of the sheet: ascending, twice the same where the surface breaks,
    std::vector<double> parameters_v; ///< then limit from the left, limit from the right
    Sheet sheet;
};

/// The surface at all pairs of distinct knots of its domain; of a closed direction without the period's end, unless it
/// breaks there. Normals are 0 0 0 where there is no normal. \throw std::invalid_argument for normals of a surface that
/// is not in three dimensions
[[nodiscard]] SurfaceLimit surface_limit(const Grid& grid, Normals normals);

/// The same at the knots of `fine`, which is `given` after any steps: assert. Normals come from the points of `given`,
/// and do not lose digits with the steps.
[[nodiscard]] SurfaceLimit surface_limit(const Grid& given, const Grid& fine, Normals normals);

} // namespace internode
