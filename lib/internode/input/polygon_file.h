// SPDX-License-Identifier: MIT
//
// From the bytes of a file to the polygons or the grid in it, whatever the format: OBJ by name or by first statement,
// else JSON by its first bracket, else CSV.

#pragma once

#include "internode/input/refusal.h"
#include "internode/io/json/input_grid.h"
#include "internode/io/polygon.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace internode {

/// By its name, or by its first statement.
[[nodiscard]] bool is_obj(std::string_view text, std::string_view source);

/// All polygons in the order of the file, or the one that `element` says, from 1: curves of free form or polylines of
/// OBJ, parts of CSV, the curves of "internode-curves". `threads` read a CSV, 0: as many as the machine has. Cost:
/// linear in the text.
[[nodiscard]] Settled<std::vector<InputPolygon>> polygons_of_file(std::string_view text, std::string_view source,
                                                                  std::optional<std::uint64_t> element = {},
                                                                  int threads = 1);

/// The only polygon, or the one that `element` says.
[[nodiscard]] Settled<InputPolygon> polygon_of_file(std::string_view text, std::string_view source,
                                                    std::optional<std::uint64_t> element = {}, int threads = 1);

/// The grid of "internode-grid", or the only surface of OBJ, or the one that `element` says.
[[nodiscard]] Settled<InputGrid> grid_of_file(std::string_view text, std::string_view source,
                                              std::optional<std::uint64_t> element = {});

} // namespace internode
