// SPDX-License-Identifier: MIT
//
// A polygon mesh as a file gives it: Wavefront OBJ (`v`, `f`, tags `t`), Geomview OFF, Stanford PLY (ascii and binary),
// STL (ascii and binary). Whether its faces are a mesh is for mesh/mesh_fault.h to say.
//
// What stands for itself is kept: a face with a corner that is no vertex, or with too few corners. What cannot be read
// is refused with its place. Texture coordinates, normals, colours, groups and materials are passed over. Corners of an
// STL file are one vertex where their three numbers are the same, bit for bit but for the sign of zero.

#pragma once

#include "internode/mesh/polygon_mesh.h"
#include "internode/text/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

enum class MeshFileFormat { Obj, Off, Ply, Stl };

/// "OBJ".
[[nodiscard]] std::string_view name_of(MeshFileFormat format);

struct MeshFile {
    std::string source;
    MeshFileFormat format = MeshFileFormat::Obj;
    PolygonMesh mesh;
    /// The lines of the text where the vertices and the faces stand, from 1; empty for a binary file, and those of the
    /// vertices for STL, which has none.
    std::vector<std::uint32_t> vertex_lines;
    std::vector<std::uint32_t> face_lines;

    /// What the format counts from: 1 in OBJ, else 0.
    [[nodiscard]] std::size_t base() const { return format == MeshFileFormat::Obj ? 1 : 0; }
};

struct ParsedMesh {
    std::optional<MeshFile> file;   ///< present iff errors is empty
    std::vector<Diagnostic> errors; ///< errors in the order of the file, at most max_polygon_errors
};

/// By the first bytes: `ply`, `OFF` with its prefixes, `solid`, the length of a binary STL; all else is OBJ.
[[nodiscard]] MeshFileFormat mesh_format(std::string_view bytes);

/// Never throws on any bytes (but std::bad_alloc). Cost: O(n log n) for STL, linear else.
[[nodiscard]] ParsedMesh read_mesh(std::string_view bytes, std::string_view source);

} // namespace internode
