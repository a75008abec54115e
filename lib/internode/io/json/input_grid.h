// SPDX-License-Identifier: MIT
//
// A control net as a JSON file of format "internode-grid" gives it (docs/json.md): rows of points, and for each of the
// two directions whatever the file says about degree, ends, word, lengths, origin and knots. Whether these fit each
// other and two grammars is for input/ to say.

#pragma once

#include "internode/io/polygon.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

struct InputGrid {
    std::string source;         ///< the file's name, for diagnostics about what stands here
    std::size_t rows = 0;       ///< N_u >= 1
    std::size_t columns = 0;    ///< N_v >= 1
    std::size_t dimension = 0;  ///< 1 … max_dimension, the weight included
    bool rational = false;      ///< the last coordinate is the weight
    std::vector<double> points; ///< rows · columns, row after row, all finite
    std::array<InputPolygon, 2>
        sides{}; ///< u and v: degree, closed, word, lengths, origin and knots of each; without points
};

struct ParsedGrid {
    std::optional<InputGrid> grid;  ///< present iff errors is empty
    std::vector<Diagnostic> errors; ///< errors in the order of the text, at most max_polygon_errors
};

/// Never throws on any text (but std::bad_alloc). Cost: linear in the text.
[[nodiscard]] ParsedGrid read_grid_json(std::string_view text, std::string_view source);

} // namespace internode
