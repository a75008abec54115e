// SPDX-License-Identifier: MIT
//
// What keeps triangles from being a mesh: a manifold, oriented, without doubled elements.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace internode {

enum class MeshFaultKind {
    TooLarge,          ///< 2^31 half-edges or more
    IndexOutOfRange,   ///< a corner without a vertex
    DegenerateFace,    ///< a corner twice
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

/// "the edge 3 7 has 3 faces: 0, 4, 9": vertices and faces counted from 0.
[[nodiscard]] std::string description(const MeshFault& fault);

/// All faults of triangles with corners from 0 to vertex_count - 1, three indices a face; none: they are a mesh. A
/// fault that hides others (an index out of range, a corner twice) is told alone. O(n log n). \throw
/// std::invalid_argument for corners that are not threes
[[nodiscard]] std::vector<MeshFault> mesh_faults(std::size_t vertex_count, std::span<const std::uint32_t> corners);

} // namespace internode
