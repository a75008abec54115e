// SPDX-License-Identifier: MIT
//
// What keeps faces from being a mesh: a manifold, oriented, without doubled elements.

#pragma once

#include "internode/mesh/face_list.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

enum class MeshFaultKind {
    TooLarge,          ///< 2^31 half-edges or more
    IndexOutOfRange,   ///< a corner without a vertex
    DegenerateFace,    ///< a corner twice, or fewer than three
    DuplicateFace,     ///< the corners of another face, in whatever order
    Orientation,       ///< two faces pass an edge in the same direction
    NonManifoldEdge,   ///< more than two faces at an edge
    NonManifoldVertex, ///< the faces at a vertex are more than one fan
    IsolatedVertex,    ///< no face at a vertex
};

struct MeshFault {
    MeshFaultKind kind;
    std::vector<std::uint32_t> vertices; ///< that show it
    std::vector<std::size_t> faces;      ///< where it is, ascending, counted from 0

    friend bool operator==(const MeshFault&, const MeshFault&) = default;
};

/// "non-manifold edge".
[[nodiscard]] std::string_view name_of(MeshFaultKind kind);

/// "the edge 3 7 has 3 faces: 0, 4, 9": vertices and faces counted from `base`.
[[nodiscard]] std::string description(const MeshFault& fault, std::size_t base = 0);

/// All faults of faces with corners from 0 to vertex_count - 1, by their kinds in the order above; none: they are a
/// mesh. Where a fault is, others that may be but its consequences are not looked for: a face that has one, and copies
/// of a face, count for no edge, the ends of an edge that has one for no fan. O(n log n).
[[nodiscard]] std::vector<MeshFault> mesh_faults(std::size_t vertex_count, const FaceList& faces);

} // namespace internode
