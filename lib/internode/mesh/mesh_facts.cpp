// SPDX-License-Identifier: MIT

#include "internode/mesh/mesh_facts.h"

#include "internode/mesh/face_sides.h"

#include <cassert>

namespace internode {
namespace {

/// Marks all faces that hang together with this one.
void visit_component(const FaceList& faces, const JoinedFaces& joined, std::size_t start, std::vector<bool>& seen) {
    std::vector<std::size_t> left{start};
    seen[start] = true;
    while (!left.empty()) {
        const std::size_t face = left.back();
        left.pop_back();
        for (std::size_t side = faces.first(face); side < faces.first(face + 1); ++side) {
            const std::uint32_t twin = joined.twin(static_cast<std::uint32_t>(side));
            if (twin == no_side || seen[joined.face(twin)]) continue;
            seen[joined.face(twin)] = true;
            left.push_back(joined.face(twin));
        }
    }
}

std::size_t component_count(const FaceList& faces, const JoinedFaces& joined) {
    std::vector<bool> seen(faces.size());
    std::size_t count = 0;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        if (seen[face]) continue;
        visit_component(faces, joined, face, seen);
        ++count;
    }
    return count;
}

/// The boundary side that begins where this one ends.
std::uint32_t next_along(const JoinedFaces& joined, std::uint32_t boundary) {
    std::uint32_t side = joined.next(boundary);
    while (joined.twin(side) != no_side) side = joined.next(joined.twin(side));
    return side;
}

std::size_t boundary_loop_count(const JoinedFaces& joined) {
    std::vector<bool> seen(joined.side_count());
    std::size_t count = 0;
    for (std::uint32_t side = 0; side < joined.side_count(); ++side) {
        if (seen[side] || joined.twin(side) != no_side) continue;
        for (std::uint32_t at = side; !seen[at]; at = next_along(joined, at)) seen[at] = true;
        ++count;
    }
    return count;
}

} // namespace

MeshTopology mesh_topology(std::size_t vertex_count, const FaceList& faces) {
    const JoinedFaces joined = joined_faces(faces);
    MeshTopology topology;
    topology.components = component_count(faces, joined);
    topology.boundary_loops = boundary_loop_count(joined);
    std::vector<std::size_t> faces_at(vertex_count);
    std::vector<bool> on_boundary(vertex_count);
    for (std::uint32_t side = 0; side < joined.side_count(); ++side) {
        ++faces_at[joined.origin(side)];
        if (joined.twin(side) != no_side) continue;
        ++topology.boundary_edges;
        on_boundary[joined.origin(side)] = true;
    }
    std::size_t vertices = 0;
    for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
        if (faces_at[vertex] == 0) continue;
        ++vertices;
        if (on_boundary[vertex])
            ++topology.boundary_valences[faces_at[vertex] + 1];
        else
            ++topology.interior_valences[faces_at[vertex]];
    }
    const std::size_t edges = (joined.side_count() + topology.boundary_edges) / 2;
    topology.euler_characteristic =
        static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces.size());
    // Each component with its holes filled has 2 - 2 handles.
    const long handles_twice = 2 * static_cast<long>(topology.components) - static_cast<long>(topology.boundary_loops) -
                               topology.euler_characteristic;
    assert(handles_twice >= 0 && handles_twice % 2 == 0);
    topology.genus = static_cast<std::size_t>(handles_twice / 2);
    return topology;
}

MeshCounts mesh_counts(std::size_t vertex_count, const FaceList& faces) {
    MeshCounts counts;
    counts.vertices = vertex_count;
    counts.faces = faces.size();
    for (std::size_t face = 0; face < faces.size(); ++face) ++counts.face_sizes[faces[face].size()];
    for_each_edge(sides_by_edge(faces), [&counts](std::span<const FaceSide>) { ++counts.edges; });
    return counts;
}

} // namespace internode
