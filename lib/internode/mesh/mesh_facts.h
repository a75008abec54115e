// SPDX-License-Identifier: MIT
//
// What a mesh is, in numbers.

#pragma once

#include "internode/mesh/face_list.h"

#include <cstddef>
#include <map>
#include <optional>

namespace internode {

/// Of an oriented manifold. Vertices without faces do not count.
struct MeshTopology {
    std::size_t components = 0;
    std::size_t boundary_loops = 0;
    std::size_t boundary_edges = 0;
    long euler_characteristic = 0; ///< vertices - edges + faces
    std::size_t genus = 0; ///< of all components together: handles of the closed surface that filled holes leave
    std::map<std::size_t, std::size_t> interior_valences{}; ///< how many vertices have so many edges
    std::map<std::size_t, std::size_t> boundary_valences{};

    friend bool operator==(const MeshTopology&, const MeshTopology&) = default;
};

/// Of faces without faults (mesh_faults) but isolated vertices. O(n log n).
[[nodiscard]] MeshTopology mesh_topology(std::size_t vertex_count, const FaceList& faces);

/// What can be counted in any faces.
struct MeshCounts {
    std::size_t vertices = 0;
    std::size_t edges = 0; ///< different pairs of corners that follow one another
    std::size_t faces = 0;
    std::map<std::size_t, std::size_t> face_sizes{}; ///< how many faces have so many corners
};

[[nodiscard]] MeshCounts mesh_counts(std::size_t vertex_count, const FaceList& faces);

} // namespace internode
