// SPDX-License-Identifier: MIT

#include "internode/mesh/mesh_facts.h"

#include <cassert>

namespace internode {
namespace {

/// Marks all faces that hang together with this one.
void visit_component(const TriangleMesh& mesh, Face start, std::vector<bool>& seen) {
    std::vector<Face> left{start};
    seen[to_index(start)] = true;
    while (!left.empty()) {
        HalfEdge h = TriangleMesh::half_edge(left.back());
        left.pop_back();
        for (int side = 0; side < 3; ++side, h = TriangleMesh::next(h)) {
            if (mesh.twin(h) == no_half_edge) continue;
            const Face neighbour = TriangleMesh::face(mesh.twin(h));
            if (seen[to_index(neighbour)]) continue;
            seen[to_index(neighbour)] = true;
            left.push_back(neighbour);
        }
    }
}

std::size_t component_count(const TriangleMesh& mesh) {
    std::vector<bool> seen(mesh.face_count());
    std::size_t count = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (seen[f]) continue;
        visit_component(mesh, handle_of<Face>(f), seen);
        ++count;
    }
    return count;
}

std::size_t boundary_loop_count(const TriangleMesh& mesh) {
    std::vector<bool> seen(mesh.vertex_count());
    std::size_t count = 0;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        auto at = handle_of<Vertex>(v);
        if (seen[v] || !mesh.is_boundary(at)) continue;
        for (; !seen[to_index(at)]; at = mesh.target(mesh.half_edge(at))) seen[to_index(at)] = true;
        ++count;
    }
    return count;
}

} // namespace

MeshFacts mesh_facts(const TriangleMesh& mesh) {
    MeshFacts facts;
    facts.components = component_count(mesh);
    facts.boundary_loops = boundary_loop_count(mesh);
    facts.euler_characteristic = static_cast<long>(mesh.vertex_count()) - static_cast<long>(mesh.edge_count()) +
                                 static_cast<long>(mesh.face_count());
    // Each component with its holes filled has 2 - 2 handles.
    const long handles_twice =
        2 * static_cast<long>(facts.components) - static_cast<long>(facts.boundary_loops) - facts.euler_characteristic;
    assert(handles_twice >= 0 && handles_twice % 2 == 0);
    facts.genus = static_cast<std::size_t>(handles_twice / 2);
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
        const auto v = handle_of<Vertex>(i);
        ++(mesh.is_boundary(v) ? facts.boundary_valences : facts.interior_valences)[mesh.valence(v)];
    }
    return facts;
}

} // namespace internode
