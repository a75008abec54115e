// SPDX-License-Identifier: MIT
//
// Faces made into a mesh: what is degenerate is dropped, faces are turned to agree, and what is not manifold is cut
// apart. No vertex moves.
//
// An edge of more than two faces is cut: each of its faces ends there. So is one where a surface that cannot be
// oriented (a Möbius band) comes back to itself the other way round. A vertex whose faces are several fans becomes as
// many vertices (Guéziec et al., IEEE TVCG 7, 2001, "cutting").

#pragma once

#include "internode/mesh/face_list.h"
#include "internode/mesh/polygon_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace internode {

/// What was done; all 0: nothing.
struct MeshRepairs {
    std::size_t corners_dropped = 0;    ///< that repeated the corner before them
    std::size_t faces_dropped = 0;      ///< without three corners, with one twice, or with one that is not there
    std::size_t duplicates_dropped = 0; ///< copies of a face
    std::size_t faces_turned = 0;
    std::size_t edges_cut = 0;
    std::size_t vertices_added = 0;
    std::size_t vertices_dropped = 0; ///< without a face

    friend bool operator==(const MeshRepairs&, const MeshRepairs&) = default;
};

struct RepairedMesh {
    FaceList faces;                         ///< without faults (mesh_faults)
    std::vector<std::uint32_t> vertices;    ///< for each of its vertices, which one it was
    std::vector<std::uint32_t> face_before; ///< for each of its faces, which one it was
    MeshRepairs done;
};

/// Of fewer than 2^31 vertices and corners. The faces of a component keep their direction, or the fewer of them turn.
/// O(n log n). \throw std::invalid_argument for more
[[nodiscard]] RepairedMesh repaired(std::size_t vertex_count, const FaceList& faces);

/// The repaired mesh with the points of its vertices. What was sharp is sharp on every copy; that of an edge that no
/// face has any more is dropped.
struct RepairedPolygons {
    PolygonMesh mesh;
    MeshRepairs done;
};
[[nodiscard]] RepairedPolygons repaired(const PolygonMesh& mesh);

} // namespace internode
