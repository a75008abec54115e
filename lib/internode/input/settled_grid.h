// SPDX-License-Identifier: MIT
//
// A control net, its words and its ends, as a file and a caller say them together, settled against two systems.
//
// For each direction: knots in the file leave nothing to the caller; else the word is the caller's over the JSON's over
// the axiom. The last two must agree when both speak. The ends are the JSON's `closed`, or the word's own form, or
// open.

#pragma once

#include "internode/input/refusal.h"
#include "internode/io/json/input_grid.h"
#include "internode/surface/grid.h"

#include <array>
#include <optional>
#include <string>

namespace internode {

/// What a caller says of one direction.
struct GridSideOptions {
    std::optional<int> degree; ///< none: the file's
    std::string word;          ///< a word in the language of grammars; empty = the file's, or the axiom
};

struct GridOptions {
    std::array<GridSideOptions, 2> sides; ///< u and v
    bool repeat = false;                  ///< the letters of words are repeated to fit the points
};

/// `systems` of u and v.
[[nodiscard]] Settled<Grid> settle_grid(const std::array<IntervalSystem, 2>& systems, InputGrid input,
                                        const GridOptions& options);

} // namespace internode
