// SPDX-License-Identifier: MIT

#include "internode/io/mesh/mesh_writers.h"

#include "internode/io/file/binary_buffer.h"
#include "internode/io/file/comment_text.h"
#include "internode/io/file/text_buffer.h"

#include <algorithm>
#include <stdexcept>

namespace internode {
namespace {

void check(const PolygonMesh& mesh) {
    const auto is_there = [&mesh](std::uint32_t corner) { return corner < mesh.vertex_count(); };
    if (!std::ranges::all_of(mesh.faces.corners(), is_there))
        throw std::invalid_argument("a corner without a vertex is not written");
}

void write_comments(TextBuffer& text, std::span<const std::string> comments) {
    for (const std::string& comment : comments) text << "# " << comment_text(comment) << '\n';
}

bool write_points(TextBuffer& text, const PolygonMesh& mesh, std::string_view keyword) {
    for (std::size_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
        text << keyword << mesh.points[3 * vertex] << ' ' << mesh.points[3 * vertex + 1] << ' '
             << mesh.points[3 * vertex + 2];
        if (!text.end_line()) return false;
    }
    return true;
}

std::string ply_header(const PolygonMesh& mesh, std::string_view count_type, std::span<const std::string> comments) {
    std::string header = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : comments) header += "comment " + comment_text(comment) + '\n';
    header += "element vertex " + std::to_string(mesh.vertex_count()) +
              "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
              std::to_string(mesh.faces.size()) + "\nproperty list " + std::string(count_type) +
              " int vertex_indices\nend_header\n";
    return header;
}

} // namespace

bool write_obj(Sink& sink, const PolygonMesh& mesh, std::span<const std::string> comments) {
    check(mesh);
    TextBuffer text(sink);
    write_comments(text, comments);
    if (!write_points(text, mesh, "v ")) return false;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        text << 'f';
        for (const std::uint32_t corner : mesh.faces[face]) text << ' ' << std::size_t{corner} + 1;
        if (!text.end_line()) return false;
    }
    for (const SharpEdge& crease : mesh.creases) {
        text << "t crease 2/1/0 " << std::size_t{crease.ends[0]} << ' ' << std::size_t{crease.ends[1]} << ' '
             << crease.sharpness;
        if (!text.end_line()) return false;
    }
    for (const SharpVertex& corner : mesh.corners) {
        text << "t corner 1/1/0 " << std::size_t{corner.vertex} << ' ' << corner.sharpness;
        if (!text.end_line()) return false;
    }
    return text.flush();
}

bool write_off(Sink& sink, const PolygonMesh& mesh, std::span<const std::string> comments) {
    check(mesh);
    TextBuffer text(sink);
    text << "OFF\n";
    write_comments(text, comments);
    text << mesh.vertex_count() << ' ' << mesh.faces.size() << " 0\n";
    if (!write_points(text, mesh, "")) return false;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        text << mesh.faces[face].size();
        for (const std::uint32_t corner : mesh.faces[face]) text << ' ' << std::size_t{corner};
        if (!text.end_line()) return false;
    }
    return text.flush();
}

bool write_ply(Sink& sink, const PolygonMesh& mesh, std::span<const std::string> comments) {
    check(mesh);
    bool is_long = false; // a face has more corners than a byte can say
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) is_long = is_long || mesh.faces[face].size() > 255;
    BinaryBuffer bytes(sink);
    bytes.put(ply_header(mesh, is_long ? "uint" : "uchar", comments));
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        bytes.put(mesh.points[i]);
        if (!bytes.end_element()) return false;
    }
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const auto count = mesh.faces[face].size();
        if (is_long)
            bytes.put(static_cast<std::uint32_t>(count));
        else
            bytes.put(static_cast<std::uint8_t>(count));
        for (const std::uint32_t corner : mesh.faces[face]) bytes.put(corner);
        if (!bytes.end_element()) return false;
    }
    return bytes.flush();
}

} // namespace internode
