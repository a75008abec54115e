// SPDX-License-Identifier: MIT
//
// What a mesh is, in numbers.

#pragma once

#include "internode/mesh/triangle_mesh.h"

#include <cstddef>
#include <map>

namespace internode {

struct MeshFacts {
    std::size_t components = 0;
    std::size_t boundary_loops = 0;
    long euler_characteristic = 0; ///< vertices - edges + faces
    std::size_t genus = 0; ///< of all components together: handles of the closed surface that filled holes leave
    std::map<std::size_t, std::size_t> interior_valences{}; ///< how many vertices have so many edges
    std::map<std::size_t, std::size_t> boundary_valences{};
};

/// Time and memory linear in the mesh.
[[nodiscard]] MeshFacts mesh_facts(const TriangleMesh& mesh);

} // namespace internode
