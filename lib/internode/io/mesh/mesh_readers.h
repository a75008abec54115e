// SPDX-License-Identifier: MIT
//
// The readers behind read_mesh(), one a format; read_mesh() says what the file is called. Not installed.

#pragma once

#include "internode/io/mesh/mesh_file.h"

namespace internode {

[[nodiscard]] ParsedMesh read_obj_mesh(std::string_view text, std::string_view source);
[[nodiscard]] ParsedMesh read_off_mesh(std::string_view text, std::string_view source);
[[nodiscard]] ParsedMesh read_ply_mesh(std::string_view bytes, std::string_view source);
[[nodiscard]] ParsedMesh read_stl_mesh(std::string_view bytes, std::string_view source);

/// Whether the first word of a text is the keyword of OFF.
[[nodiscard]] bool is_off(std::string_view text);
/// Whether a file has the length that a binary STL of its number of triangles has.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);

} // namespace internode
