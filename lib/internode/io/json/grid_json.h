// SPDX-License-Identifier: MIT
//
// A grid as JSON of format "internode-grid": what read_grid_json reads, written as it is computed.

#pragma once

#include "internode/io/json/curve_json.h"

#include <array>
#include <string>

namespace internode {

/// One direction: everything of a curve but its points.
struct GridSide {
    std::size_t degree = 1;
    Ends ends = Ends::Open;
    std::vector<std::string> symbols; ///< names of the letters of `word`
    WordView word;
    std::vector<CurveLength> lengths; ///< lengths of the symbols; those without an exact value are left out
    CurveOrigin origin;               ///< null in the file without an exact value; no key without either
    std::vector<double>
        knots; ///< rounded, for the eye and for a check; null in the file when empty, no key when both are
};

struct GridDocument {
    std::string version; ///< the version of internode, for "generator"
    std::string command; ///< the command that made the grid, for "generator": base names, no output name
    std::array<GridSide, 2> sides;
    std::size_t columns = 1; ///< points in a row
    bool rational = false;
    PointsView points;
    int threads = 1; ///< that make the text of the points; 0: as many as the machine has
};

/// Writes the document; false if the sink failed. \throw std::invalid_argument for rows that are not whole and numbers
/// that are not finite; std::out_of_range for a letter without a name
bool write_grid_json(Sink& sink, const GridDocument& grid);

} // namespace internode
