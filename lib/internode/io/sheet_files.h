// SPDX-License-Identifier: MIT
//
// A sheet (surface/sheet.h) as a file of quadrilaterals or triangles: OBJ, PLY, STL.
//
// Points of one or two coordinates get zeros; normals go along where the sheet has them and the format takes them.
// Corners go round counterclockwise seen from outside. `comments` stand in the file, a line each.

#pragma once

#include "internode/io/file/sink.h"
#include "internode/surface/sheet.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace internode {

inline constexpr std::size_t max_mesh_dimension = 3;

/// Indices of PLY are 32-bit integers with a sign, the number of triangles of STL one without: what is beyond cannot be
/// said in these formats.
inline constexpr std::uint64_t max_ply_vertices = (std::uint64_t{1} << 31U) - 1;
inline constexpr std::uint64_t max_stl_triangles = (std::uint64_t{1} << 32U) - 1;

enum class MeshFormat { Obj, Ply, Stl };

/// Why the sheet cannot be written in that format, a sentence with the numbers; nothing when it can. Looks at every
/// coordinate: all must be finite, and floats for STL.
[[nodiscard]] std::optional<std::string> mesh_problem(const Sheet& sheet, MeshFormat format);

// Each writes the whole sheet; false if the sink failed. \throw std::invalid_argument with mesh_problem()

/// Wavefront OBJ: `v`, `vn`, and a quadrilateral `f` per face. `threads` make the lines, 0: as many as the machine has.
bool write_obj(Sink& sink, const Sheet& sheet, std::span<const std::string> comments = {}, int threads = 1);

/// PLY, binary, little endian: x y z as doubles, nx ny nz as floats, faces of four int indices.
bool write_ply(Sink& sink, const Sheet& sheet, std::span<const std::string> comments = {});

/// STL, binary: two triangles per face, each with its own normal, all numbers floats. The first comment stands in the
/// header of 80 bytes as far as it fits.
bool write_stl(Sink& sink, const Sheet& sheet, std::span<const std::string> comments = {});

} // namespace internode
