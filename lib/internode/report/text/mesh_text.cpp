// SPDX-License-Identifier: MIT

#include "internode/report/text/mesh_text.h"

#include "internode/report/text/text_table.h"
#include "internode/text/printable.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace internode {
namespace {

constexpr std::size_t shown_faults = 20;
constexpr std::size_t shown_elements = 8; // of one fault

/// "1 face", "2 faces".
std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

void add_valences(TextTable& table, const std::map<std::size_t, std::size_t>& valences, std::string_view where) {
    for (const auto& [valence, vertices] : valences)
        table.row({fmt::format("vertices of valence {}{}", valence, where), std::to_string(vertices)});
}

std::string facts_text(const MeshReport& report) {
    TextTable table({Align::Left, Align::Right});
    table.row({"vertices", std::to_string(report.counts.vertices)});
    table.row({"edges", std::to_string(report.counts.edges)});
    table.row({"faces", std::to_string(report.counts.faces)});
    for (const auto& [corners, faces] : report.counts.face_sizes)
        table.row({fmt::format("faces of {}", counted(corners, "corner", "corners")), std::to_string(faces)});
    if (const auto& topology = report.topology) {
        table.row({"components", std::to_string(topology->components)});
        table.row({"boundary loops", std::to_string(topology->boundary_loops)});
        table.row({"boundary edges", std::to_string(topology->boundary_edges)});
        table.row({"Euler characteristic", std::to_string(topology->euler_characteristic)});
        table.row({"genus", std::to_string(topology->genus)});
        add_valences(table, topology->interior_valences, "");
        add_valences(table, topology->boundary_valences, ", boundary");
    }
    const PolygonMesh& mesh = report.file.mesh;
    if (!mesh.creases.empty()) table.row({"sharp edges", std::to_string(mesh.creases.size())});
    if (!mesh.corners.empty()) table.row({"sharp vertices", std::to_string(mesh.corners.size())});
    return table.text();
}

/// A fault of many faces shows the first of them.
std::string shortened(MeshFault fault, std::size_t base) {
    const std::size_t faces = fault.faces.size();
    const std::size_t vertices = fault.vertices.size();
    const std::string many = fault.kind == MeshFaultKind::NonManifoldEdge && faces > shown_elements
                                 ? fmt::format(" of {}", faces)
                                 : std::string();
    fault.faces.resize(std::min(faces, shown_elements));
    fault.vertices.resize(std::min(vertices, shown_elements));
    return description(fault, base) + (faces > shown_elements || vertices > shown_elements ? " …" + many : "");
}

std::string fault_line(const MeshFault& fault, const MeshFile& file) {
    const std::vector<std::size_t> lines = lines_of(fault, file);
    const std::string where = lines.empty() ? std::string() : fmt::format(":{}", lines.front());
    return fmt::format("  {}{}: {}: {}\n", printable(file.source), where, name_of(fault.kind),
                       shortened(fault, file.base()));
}

} // namespace

std::string mesh_text(const MeshReport& report) {
    const MeshFile& file = report.file;
    std::string text = fmt::format("{}, {}\n{}", printable(file.source), name_of(file.format), facts_text(report));
    if (report.faults.empty()) return text + "An oriented manifold without faults.\n";
    text += counted(report.faults.size(), "fault:\n", "faults:\n");
    const std::size_t shown = std::min(report.faults.size(), shown_faults);
    for (std::size_t i = 0; i < shown; ++i) text += fault_line(report.faults[i], file);
    if (shown < report.faults.size()) text += fmt::format("  and {} more\n", report.faults.size() - shown);
    return text;
}

std::string repairs_text(const MeshRepairs& repairs) {
    struct Repair {
        std::size_t count;
        std::string_view one;
        std::string_view many;
    };
    const std::array<Repair, 7> all{{
        {repairs.corners_dropped, "repeated corner dropped", "repeated corners dropped"},
        {repairs.faces_dropped, "degenerate face dropped", "degenerate faces dropped"},
        {repairs.duplicates_dropped, "duplicate face dropped", "duplicate faces dropped"},
        {repairs.faces_turned, "face turned", "faces turned"},
        {repairs.edges_cut, "edge cut", "edges cut"},
        {repairs.vertices_added, "vertex added", "vertices added"},
        {repairs.vertices_dropped, "isolated vertex dropped", "isolated vertices dropped"},
    }};
    std::string text;
    for (const Repair& repair : all)
        if (repair.count > 0) text += (text.empty() ? "" : ", ") + counted(repair.count, repair.one, repair.many);
    return text.empty() ? "nothing to repair" : text;
}

} // namespace internode
