// SPDX-License-Identifier: MIT

#include "internode/report/json/mesh_json.h"

#include "internode/report/json/json_parts.h"

namespace internode {
namespace {

/// [{"corners": 4, "faces": 6}], for each count with its number.
void write_numbers(JsonWriter& json, const std::map<std::size_t, std::size_t>& numbers, std::string_view of,
                   std::string_view what) {
    json.begin_array();
    for (const auto& [key, count] : numbers)
        json.begin_object(one_line).key(of).integer(key).key(what).integer(count).end_object();
    json.end_array();
}

void write_topology(JsonWriter& json, const MeshTopology& topology) {
    json.begin_object();
    json.key("components").integer(topology.components);
    json.key("boundary_loops").integer(topology.boundary_loops);
    json.key("boundary_edges").integer(topology.boundary_edges);
    json.key("euler_characteristic").number(static_cast<double>(topology.euler_characteristic));
    json.key("genus").integer(topology.genus);
    write_numbers(json.key("interior_valences"), topology.interior_valences, "valence", "vertices");
    write_numbers(json.key("boundary_valences"), topology.boundary_valences, "valence", "vertices");
    json.end_object();
}

template<typename Numbers>
void write_list(JsonWriter& json, std::string_view key, const Numbers& numbers) {
    json.key(key).begin_array(one_line);
    for (const auto number : numbers) json.integer(number);
    json.end_array();
}

void write_fault(JsonWriter& json, const MeshFault& fault, const MeshFile& file) {
    json.begin_object().key("kind").string(name_of(fault.kind));
    write_list(json, "vertices", fault.vertices);
    write_list(json, "faces", fault.faces);
    write_list(json, "lines", lines_of(fault, file));
    json.end_object();
}

} // namespace

bool write_mesh_json(Sink& sink, const MeshReport& report, const Generator& generator) {
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-mesh", generator);
    json.key("file_format").string(name_of(report.file.format));
    json.key("vertices").integer(report.counts.vertices);
    json.key("edges").integer(report.counts.edges);
    json.key("faces").integer(report.counts.faces);
    write_numbers(json.key("face_sizes"), report.counts.face_sizes, "corners", "faces");
    json.key("topology");
    if (report.topology)
        write_topology(json, *report.topology);
    else
        json.null();
    json.key("sharp_edges").integer(report.file.mesh.creases.size());
    json.key("sharp_vertices").integer(report.file.mesh.corners.size());
    json.key("faults").begin_array();
    for (const MeshFault& fault : report.faults) write_fault(json, fault, report.file);
    return json.end_array().end_object().finish();
}

} // namespace internode
