// SPDX-License-Identifier: MIT
//
// Points of a surface in rows and columns, joined to quadrilaterals: what formats of meshes are written from.
//
// Rows i that are joined, times columns j that are joined, are the faces: p(i,j) p(i',j) p(i',j') p(i,j') goes round
// counterclockwise when seen from where the normal S_u × S_v points to. A closed direction joins its last row to its
// first; where the surface breaks, nothing is joined.

#pragma once

#include "internode/surface/grid.h"

#include <array>
#include <cstddef>
#include <vector>

namespace internode {

/// Two neighbouring rows (or columns).
struct Join {
    std::size_t from;
    std::size_t to;
    friend bool operator==(const Join&, const Join&) = default;
};

struct Sheet {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::size_t dimension = 3;     ///< >= 1
    std::vector<double> points;    ///< rows · columns, row after row, of `dimension` coordinates
    std::vector<double> normals;   ///< empty, or three coordinates a point: of length 1, or 0 0 0 where there is none
    std::vector<Join> joined_rows; ///< ascending by `from`
    std::vector<Join> joined_columns;

    [[nodiscard]] std::size_t faces() const { return joined_rows.size() * joined_columns.size(); }
    /// The four corners of face k < faces(), counterclockwise.
    [[nodiscard]] std::array<std::size_t, 4> face(std::size_t k) const;
};

/// The control points in space.
[[nodiscard]] Sheet control_sheet(const Grid& grid);

} // namespace internode
