// SPDX-License-Identifier: MIT
//
// STL: triangles by their coordinates, as text (`facet`, `outer loop`, three `vertex`) or in 50 bytes each behind a
// header of 80 and their number (3D Systems, StereoLithography Interface Specification). Normals are passed over.

#include "internode/io/mesh/mesh_readers.h"
#include "internode/io/mesh/number_pieces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>

namespace internode {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

using Point = std::array<double, 3>;

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// One vertex for corners with the same numbers, in the order in which they come; three corners a triangle.
void weld(const std::vector<Point>& corners, MeshFile& file) {
    std::vector<std::uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&corners](std::uint32_t a, std::uint32_t b) {
        return corners[a] != corners[b] ? corners[a] < corners[b] : a < b;
    });
    std::vector<std::uint32_t> first(corners.size()); // of the same numbers
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_same = i > 0 && corners[order[i]] == corners[order[i - 1]];
        first[order[i]] = is_same ? first[order[i - 1]] : order[i];
    }
    std::vector<std::uint32_t> number(corners.size());
    std::vector<std::uint32_t> vertices(corners.size());
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
        if (first[corner] == corner) {
            number[corner] = static_cast<std::uint32_t>(file.mesh.vertex_count());
            file.mesh.points.insert(file.mesh.points.end(), corners[corner].begin(), corners[corner].end());
        }
        vertices[corner] = number[first[corner]];
    }
    file.mesh.faces = triangles(vertices);
}

class StlTextReader {
public:
    StlTextReader(std::string_view text, std::string_view source)
        : lines_(text, source, {}) {}

    ParsedMesh read() && {
        while (lines_.next() && lines_.errors().size() < max_polygon_errors) {
            const std::vector<LinePiece> pieces = pieces_of(lines_);
            if (!pieces.empty()) read_line(pieces);
        }
        if (lines_.errors().empty() && (is_open_ || corners_.size() % 3 != 0))
            lines_.refuse_text("the file ends within a triangle");
        if (!lines_.errors().empty()) return {std::nullopt, std::move(lines_.errors())};
        weld(corners_, file_);
        return {std::move(file_), {}};
    }

private:
    void read_line(const std::vector<LinePiece>& pieces) {
        const std::string_view keyword = pieces.front().text;
        if (keyword == "vertex")
            read_vertex(pieces);
        else if (keyword == "facet")
            begin_triangle(pieces.front());
        else if (keyword == "endfacet")
            end_triangle(pieces.front());
        else if (keyword != "solid" && keyword != "endsolid" && keyword != "outer" && keyword != "endloop")
            lines_.refuse(pieces.front(), piece_quoted(keyword) + " is no statement of STL");
    }

    void begin_triangle(const LinePiece& keyword) {
        if (is_open_) lines_.refuse(keyword, "a triangle within a triangle");
        if (corners_.size() >= max_mesh_vertices) lines_.refuse(keyword, beyond_mesh_limit("corners of faces"));
        is_open_ = true;
        first_ = corners_.size();
        file_.face_lines.push_back(static_cast<std::uint32_t>(lines_.number()));
    }

    void end_triangle(const LinePiece& keyword) {
        if (!is_open_ || corners_.size() - first_ != 3) lines_.refuse(keyword, "a triangle has three vertices");
        is_open_ = false;
    }

    void read_vertex(const std::vector<LinePiece>& pieces) {
        if (!is_open_ || pieces.size() != 4)
            return lines_.refuse(pieces.front(), "a vertex stands in a triangle and has x, y and z");
        Point point{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto coordinate = coordinate_of(pieces[i + 1], lines_);
            if (!coordinate) return;
            point[i] = *coordinate + 0.0; // no zero below zero
        }
        corners_.push_back(point);
    }

    TextLines lines_;
    MeshFile file_;
    std::vector<Point> corners_;
    bool is_open_ = false;  ///< within a triangle
    std::size_t first_ = 0; ///< the first corner of that triangle
};

ParsedMesh read_binary_stl(std::string_view bytes, std::string_view source) {
    const auto refuse = [source](std::string message) {
        Diagnostic diagnostic;
        diagnostic.source = source;
        diagnostic.message = std::move(message);
        return ParsedMesh{std::nullopt, {std::move(diagnostic)}};
    };
    const std::uint32_t count = little_endian(bytes, header_bytes - 4);
    if (count > max_mesh_vertices / 3) return refuse(beyond_mesh_limit("corners of faces"));
    std::vector<Point> corners;
    corners.reserve(std::size_t{3} * count);
    for (std::size_t triangle = 0; triangle < count; ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Point point{};
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t at = header_bytes + triangle * triangle_bytes + 12 * (corner + 1) + 4 * i;
                point[i] = double{std::bit_cast<float>(little_endian(bytes, at))} + 0.0;
                if (!std::isfinite(point[i]))
                    return refuse("triangle " + std::to_string(triangle) + " has a coordinate that is not finite");
            }
            corners.push_back(point);
        }
    ParsedMesh parsed;
    parsed.file.emplace();
    weld(corners, *parsed.file);
    return parsed;
}

} // namespace

bool is_binary_stl(std::string_view bytes) {
    return bytes.size() >= header_bytes &&
           bytes.size() - header_bytes == triangle_bytes * std::uint64_t{little_endian(bytes, header_bytes - 4)};
}

ParsedMesh read_stl_mesh(std::string_view bytes, std::string_view source) {
    return is_binary_stl(bytes) ? read_binary_stl(bytes, source) : StlTextReader(bytes, source).read();
}

} // namespace internode
