// SPDX-License-Identifier: MIT
//
// Small readers of PLY, STL and OBJ, just enough to read back what the library writes. They trust nothing: whatever is
// not as expected is an exception.

#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace internode::reference {

/// The double of a whole word, in any locale.
inline double decimal(std::string_view word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) throw std::runtime_error("not a number");
    return value;
}

struct MeshFile {
    std::vector<double> points;  ///< 3 a vertex
    std::vector<double> normals; ///< 3 a vertex (PLY, OBJ) or a face (STL)
    std::vector<std::vector<std::size_t>> faces;
    std::string header;
};

class ByteReader {
public:
    explicit ByteReader(std::string_view bytes)
        : bytes_(bytes) {}

    std::string_view take(std::size_t count) {
        if (count > bytes_.size()) throw std::runtime_error("the file ends too early");
        const std::string_view taken = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return taken;
    }
    std::uint64_t unsigned_number(std::size_t size) {
        std::uint64_t value = 0;
        const std::string_view taken = take(size);
        for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(taken[i]);
        return value;
    }
    double real64() { return std::bit_cast<double>(unsigned_number(8)); }
    double real32() { return double{std::bit_cast<float>(static_cast<std::uint32_t>(unsigned_number(4)))}; }
    void end() const {
        if (!bytes_.empty()) throw std::runtime_error("bytes after the end");
    }

private:
    std::string_view bytes_;
};

inline MeshFile read_ply(std::string_view bytes) {
    constexpr std::string_view end_of_header = "end_header\n";
    const std::size_t header_size = bytes.find(end_of_header) + end_of_header.size();
    MeshFile mesh;
    mesh.header = bytes.substr(0, header_size);
    std::istringstream lines(mesh.header);
    std::vector<std::string> properties;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("element vertex ")) vertices = std::stoull(line.substr(15));
        if (line.starts_with("element face ")) faces = std::stoull(line.substr(13));
        if (line.starts_with("property ")) properties.push_back(line.substr(9));
    }
    std::vector<std::string> expected{"double x", "double y", "double z"};
    const bool with_normals = properties.size() == 7;
    if (with_normals) expected.insert(expected.end(), {"float nx", "float ny", "float nz"});
    expected.emplace_back("list uchar int vertex_indices");
    if (!mesh.header.starts_with("ply\nformat binary_little_endian 1.0\n") || properties != expected)
        throw std::runtime_error("another header");
    ByteReader in(bytes.substr(header_size));
    for (std::size_t k = 0; k < vertices; ++k) {
        for (int c = 0; c < 3; ++c) mesh.points.push_back(in.real64());
        for (int c = 0; c < 3 && with_normals; ++c) mesh.normals.push_back(in.real32());
    }
    for (std::size_t f = 0; f < faces; ++f) {
        mesh.faces.emplace_back(in.unsigned_number(1));
        for (std::size_t& corner : mesh.faces.back()) corner = in.unsigned_number(4);
    }
    in.end();
    return mesh;
}

/// Three points of its own for each triangle.
inline MeshFile read_stl(std::string_view bytes) {
    ByteReader in(bytes);
    MeshFile mesh;
    mesh.header = in.take(80);
    if (mesh.header.starts_with("solid")) throw std::runtime_error("a text");
    const std::size_t triangles = in.unsigned_number(4);
    for (std::size_t t = 0; t < triangles; ++t) {
        for (int c = 0; c < 3; ++c) mesh.normals.push_back(in.real32());
        for (int c = 0; c < 9; ++c) mesh.points.push_back(in.real32());
        mesh.faces.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        if (in.unsigned_number(2) != 0) throw std::runtime_error("an attribute");
    }
    in.end();
    return mesh;
}

inline MeshFile read_obj(const std::string& text) {
    MeshFile mesh;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        if (keyword == "#") mesh.header += line + '\n';
        if (keyword == "v" || keyword == "vn")
            for (std::string word; words >> word;)
                (keyword == "v" ? mesh.points : mesh.normals).push_back(decimal(word));
        if (keyword != "f") continue;
        mesh.faces.emplace_back();
        for (std::string corner; words >> corner;) {
            const std::size_t index = std::stoull(corner);
            const auto slashes = corner.find("//");
            if (slashes != std::string::npos && std::stoull(corner.substr(slashes + 2)) != index)
                throw std::runtime_error("the normal of another vertex");
            if (index == 0) throw std::runtime_error("index 0");
            mesh.faces.back().push_back(index - 1);
        }
    }
    return mesh;
}

} // namespace internode::reference
