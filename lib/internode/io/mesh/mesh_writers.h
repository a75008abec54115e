// SPDX-License-Identifier: MIT
//
// A polygon mesh (mesh/polygon_mesh.h) as a file: OBJ with its creases and corners, OFF, PLY.
//
// Coordinates are written so that they read back bit for bit. `comments` stand in the file, a line each. Every corner
// must be a vertex and every coordinate finite. False if the sink failed. \throw std::invalid_argument

#pragma once

#include "internode/io/file/sink.h"
#include "internode/mesh/polygon_mesh.h"

#include <span>
#include <string>

namespace internode {

/// `v`, `f`, `t crease`, `t corner`.
bool write_obj(Sink& sink, const PolygonMesh& mesh, std::span<const std::string> comments = {});

/// Without what is sharp.
bool write_off(Sink& sink, const PolygonMesh& mesh, std::span<const std::string> comments = {});

/// Binary, little endian: x y z as doubles, corners as ints behind their number. Without what is sharp.
bool write_ply(Sink& sink, const PolygonMesh& mesh, std::span<const std::string> comments = {});

} // namespace internode
