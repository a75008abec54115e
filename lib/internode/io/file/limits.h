// SPDX-License-Identifier: MIT
//
// How much the readers of io/ accept. Each limit is there so that no input can take the machine with it; each
// refusal names its number. `internode limits` prints the table.

#pragma once

#include "internode/text/limits.h"

#include <array>
#include <cstdint>

namespace internode {

inline constexpr std::uint64_t max_file_bytes = std::uint64_t{1} << 30; ///< any text file: it is held in memory
inline constexpr std::uint64_t max_json_depth = 200;                    ///< brackets open at once
inline constexpr std::uint64_t max_json_values = 20'000'000;            ///< held in less than 2 GB
inline constexpr std::uint64_t max_knots = 5'000'000;                   ///< exact numbers, of 100 bytes and more each
inline constexpr std::uint64_t max_obj_vertices = 40'000'000; ///< vertices of 32 bytes each; and as many indices
inline constexpr std::uint64_t max_mesh_vertices =
    40'000'000; ///< of a mesh file; and as many faces, and corners of faces
inline constexpr std::uint64_t max_mesh_line_bytes = std::uint64_t{1} << 24; ///< of OFF, PLY and STL: cut into pieces
inline constexpr std::uint64_t max_input_degree = 1'000'000;                 ///< so that points + degree never wraps
inline constexpr std::uint64_t max_filter_window = 64;                       ///< intervals of a pyramid's local filters
inline constexpr std::uint64_t max_matrix_side = 1'000'000;                  ///< rows, and columns, of a matrix file
inline constexpr std::uint64_t max_matrix_entries = 2'000'000;               ///< fractions, of 100 bytes and more each
inline constexpr std::uint64_t max_polygon_errors = 100; ///< a table is given up after so many errors

inline constexpr std::array<Limit, 14> input_limits{{
    {"input file", max_file_bytes, "bytes"},
    {"JSON depth", max_json_depth, "open brackets"},
    {"JSON values", max_json_values, "values"},
    {"knots of a file", max_knots, "knots"},
    {"vertices, and indices of elements, of an OBJ file", max_obj_vertices, "vertices"},
    {"vertices, faces, and corners of faces, of a mesh file", max_mesh_vertices, ""},
    {"line of an OFF, PLY or STL file", max_mesh_line_bytes, "bytes"},
    {"polygon dimension", max_dimension, "coordinates"},
    {"polygon degree as read", max_input_degree, ""},
    {"window of a local filter", max_filter_window, "intervals"},
    {"rows, and columns, of a matrix file", max_matrix_side, ""},
    {"entries of a matrix file, zeros of CSV not counted", max_matrix_entries, "entries"},
    {"polygon errors", max_polygon_errors, "errors"},
    {"source line shown", max_shown_line_bytes, "bytes"},
}};

} // namespace internode
