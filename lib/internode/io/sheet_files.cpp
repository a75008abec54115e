// SPDX-License-Identifier: MIT

#include "internode/io/sheet_files.h"

#include "internode/io/file/binary_buffer.h"
#include "internode/io/file/comment_text.h"
#include "internode/io/file/text_lines.h"
#include "internode/text/number.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace internode {

namespace {

std::uint64_t vertex_count(const Sheet& sheet) {
    return std::uint64_t{sheet.rows} * sheet.columns;
}

std::array<double, 3> vertex(const Sheet& sheet, std::size_t k) {
    assert(sheet.dimension <= max_mesh_dimension && (k + 1) * sheet.dimension <= sheet.points.size());
    std::array<double, 3> point{};
    std::copy_n(sheet.points.data() + k * sheet.dimension, sheet.dimension, point.data());
    return point;
}

std::array<double, 3> normal(const Sheet& sheet, std::size_t k) {
    assert(3 * k + 2 < sheet.normals.size());
    return {sheet.normals[3 * k], sheet.normals[3 * k + 1], sheet.normals[3 * k + 2]};
}

bool fits_float(double value) {
    return std::abs(value) <= double{std::numeric_limits<float>::max()};
}

void check(const Sheet& sheet, MeshFormat format) {
    if (const auto problem = mesh_problem(sheet, format)) throw std::invalid_argument(*problem);
}

/// "v 0 0.5 1", a line.
void append_numbers(std::string& text, std::string_view keyword, const std::array<double, 3>& numbers) {
    text += keyword;
    for (const double number : numbers) {
        text += ' ';
        append(text, number);
    }
    text += '\n';
}

void put_floats(BinaryBuffer& bytes, const std::array<double, 3>& numbers) {
    for (const double number : numbers) bytes.put(static_cast<float>(number));
}

std::string ply_header(const Sheet& sheet, std::span<const std::string> comments) {
    std::string header = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : comments) header += "comment " + comment_text(comment) + '\n';
    header += "element vertex " + std::to_string(vertex_count(sheet)) +
              "\nproperty double x\nproperty double y\nproperty double z\n";
    if (!sheet.normals.empty()) header += "property float nx\nproperty float ny\nproperty float nz\n";
    return header + "element face " + std::to_string(sheet.faces()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

/// Of length 1; 0 for a triangle without area.
std::array<double, 3> triangle_normal(const std::array<std::array<double, 3>, 3>& corners) {
    std::array<std::array<double, 3>, 2> legs{};
    double size = 0;
    for (std::size_t leg = 0; leg < 2; ++leg)
        for (std::size_t c = 0; c < 3; ++c) {
            legs[leg][c] = corners[leg + 1][c] - corners[0][c];
            size = std::max(size, std::abs(legs[leg][c]));
        }
    if (size == 0) return {};
    for (auto& leg : legs)
        for (double& coordinate : leg) coordinate /= size;
    const auto& [a, b] = legs;
    std::array<double, 3> product{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::sqrt(product[0] * product[0] + product[1] * product[1] + product[2] * product[2]);
    if (length == 0) return {};
    for (double& coordinate : product) coordinate /= length;
    return product;
}

void put_triangle(BinaryBuffer& bytes, const std::array<std::array<double, 3>, 3>& corners) {
    put_floats(bytes, triangle_normal(corners));
    for (const auto& corner : corners) put_floats(bytes, corner);
    bytes.put(std::uint16_t{0});
}

/// 80 bytes that do not begin with "solid", which would announce a text.
std::string stl_header(std::span<const std::string> comments) {
    constexpr std::size_t size = 80;
    std::string header = "binary STL";
    if (!comments.empty()) header += ": " + comment_text(comments.front());
    header.resize(size, ' ');
    return header;
}

} // namespace

std::optional<std::string> mesh_problem(const Sheet& sheet, MeshFormat format) {
    if (sheet.dimension == 0 || sheet.dimension > max_mesh_dimension)
        return "a mesh has points of at most " + std::to_string(max_mesh_dimension) + " coordinates, not " +
               std::to_string(sheet.dimension);
    if (sheet.points.size() != vertex_count(sheet) * sheet.dimension ||
        (!sheet.normals.empty() && sheet.normals.size() != vertex_count(sheet) * 3))
        return "the points or normals of the sheet are not one for each vertex";
    if (!std::ranges::all_of(sheet.points, [](double x) { return std::isfinite(x); }))
        return "a coordinate is beyond the range of doubles";
    if (format == MeshFormat::Ply && vertex_count(sheet) > max_ply_vertices)
        return std::to_string(vertex_count(sheet)) + " vertices, but PLY has at most " +
               std::to_string(max_ply_vertices);
    if (format != MeshFormat::Stl) return std::nullopt;
    if (sheet.faces() > max_stl_triangles / 2)
        return "two triangles for each of " + std::to_string(sheet.faces()) + " faces, but STL has at most " +
               std::to_string(max_stl_triangles);
    if (!std::ranges::all_of(sheet.points, fits_float))
        return "a coordinate is beyond the range of the single precision numbers of STL";
    return std::nullopt;
}

bool write_obj(Sink& sink, const Sheet& sheet, std::span<const std::string> comments, int threads) {
    check(sheet, MeshFormat::Obj);
    std::string head;
    for (const std::string& comment : comments) head += "# " + comment_text(comment) + '\n';
    const bool with_normals = !sheet.normals.empty();
    const auto put_vertex = [&](std::size_t k, std::string& text) { append_numbers(text, "v", vertex(sheet, k)); };
    const auto put_normal = [&](std::size_t k, std::string& text) { append_numbers(text, "vn", normal(sheet, k)); };
    const auto put_face = [&](std::size_t f, std::string& text) {
        text += 'f';
        for (const std::size_t corner : sheet.face(f)) {
            const std::string number = std::to_string(corner + 1);
            text += ' ' + number;
            if (with_normals) text += "//" + number;
        }
        text += '\n';
    };
    return sink.write(head) && write_lines(sink, vertex_count(sheet), threads, put_vertex) &&
           write_lines(sink, with_normals ? vertex_count(sheet) : 0, threads, put_normal) &&
           write_lines(sink, sheet.faces(), threads, put_face);
}

bool write_ply(Sink& sink, const Sheet& sheet, std::span<const std::string> comments) {
    check(sheet, MeshFormat::Ply);
    BinaryBuffer bytes(sink);
    bytes.put(std::string_view(ply_header(sheet, comments)));
    for (std::size_t k = 0; k < vertex_count(sheet); ++k) {
        for (const double coordinate : vertex(sheet, k)) bytes.put(coordinate);
        if (!sheet.normals.empty()) put_floats(bytes, normal(sheet, k));
        if (!bytes.end_element()) return false;
    }
    for (std::size_t f = 0; f < sheet.faces(); ++f) {
        bytes.put(std::uint8_t{4});
        for (const std::size_t corner : sheet.face(f)) bytes.put(static_cast<std::uint32_t>(corner));
        if (!bytes.end_element()) return false;
    }
    return bytes.flush();
}

bool write_stl(Sink& sink, const Sheet& sheet, std::span<const std::string> comments) {
    check(sheet, MeshFormat::Stl);
    BinaryBuffer bytes(sink);
    bytes.put(std::string_view(stl_header(comments)));
    bytes.put(static_cast<std::uint32_t>(2 * sheet.faces()));
    for (std::size_t f = 0; f < sheet.faces(); ++f) {
        const auto corners = sheet.face(f);
        const auto at = [&](std::size_t c) { return vertex(sheet, corners[c]); };
        put_triangle(bytes, {at(0), at(1), at(2)});
        put_triangle(bytes, {at(0), at(2), at(3)});
        if (!bytes.end_element()) return false;
    }
    return bytes.flush();
}

} // namespace internode
