// SPDX-License-Identifier: MIT
//
// Any bytes as a mesh: refused with places, or a mesh whose faults are told, whose repair has none, and whose files
// read back as they were written.

#include "internode/io/mesh/mesh_file.h"
#include "internode/io/mesh/mesh_writers.h"
#include "internode/mesh/mesh_facts.h"
#include "internode/mesh/mesh_fault.h"
#include "internode/mesh/mesh_repair.h"
#include "tests/fuzz/require.h"

#include <cmath>
#include <cstdint>

namespace {

using namespace internode;
using fuzz::require;

void require_sound(const MeshFile& file) {
    require(file.mesh.points.size() % 3 == 0);
    for (const double coordinate : file.mesh.points) require(std::isfinite(coordinate));
    require(file.vertex_lines.empty() || file.vertex_lines.size() == file.mesh.vertex_count());
    require(file.face_lines.empty() || file.face_lines.size() == file.mesh.faces.size());
}

template<typename Write>
void require_back(const PolygonMesh& mesh, MeshFileFormat format, const Write& write) {
    StringSink sink;
    require(write(sink, mesh));
    const ParsedMesh again = read_mesh(sink.text(), "again");
    require(again.file.has_value() && again.file->format == format);
    require(again.file->mesh.points == mesh.points && again.file->mesh.faces == mesh.faces);
}

void require_repaired(const PolygonMesh& mesh) {
    const RepairedPolygons made = repaired(mesh);
    require(mesh_faults(made.mesh.vertex_count(), made.mesh.faces).empty());
    (void)mesh_topology(made.mesh.vertex_count(), made.mesh.faces);
    require(repaired(made.mesh).done == MeshRepairs{});
    if (made.mesh.faces.size() == 0) return; // OBJ without a face is refused
    require_back(made.mesh, MeshFileFormat::Obj,
                 [](Sink& sink, const PolygonMesh& one) { return write_obj(sink, one); });
    require_back(made.mesh, MeshFileFormat::Off,
                 [](Sink& sink, const PolygonMesh& one) { return write_off(sink, one); });
    require_back(made.mesh, MeshFileFormat::Ply,
                 [](Sink& sink, const PolygonMesh& one) { return write_ply(sink, one); });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const ParsedMesh parsed = read_mesh(bytes, "fuzz");
    require(parsed.file.has_value() == parsed.errors.empty());
    if (!parsed.file) return 0;
    require_sound(*parsed.file);
    (void)mesh_counts(parsed.file->mesh.vertex_count(), parsed.file->mesh.faces);
    require_repaired(parsed.file->mesh);
    return 0;
}
