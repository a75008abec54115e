// SPDX-License-Identifier: MIT

#include "internode/report/mesh_report.h"

#include <algorithm>

namespace internode {

MeshReport mesh_report(const MeshFile& file) {
    const FaceList& faces = file.mesh.faces;
    const std::size_t vertices = file.mesh.vertex_count();
    MeshReport report{file, mesh_counts(vertices, faces), mesh_faults(vertices, faces), {}};
    const bool is_manifold = std::ranges::all_of(
        report.faults, [](const MeshFault& fault) { return fault.kind == MeshFaultKind::IsolatedVertex; });
    if (is_manifold) report.topology = mesh_topology(vertices, faces);
    return report;
}

std::vector<std::size_t> lines_of(const MeshFault& fault, const MeshFile& file) {
    std::vector<std::size_t> lines;
    for (const std::size_t face : fault.faces)
        if (face < file.face_lines.size()) lines.push_back(file.face_lines[face]);
    if (fault.faces.empty())
        for (const std::uint32_t vertex : fault.vertices)
            if (vertex < file.vertex_lines.size()) lines.push_back(file.vertex_lines[vertex]);
    return lines;
}

} // namespace internode
