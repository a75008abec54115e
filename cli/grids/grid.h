// SPDX-License-Identifier: MIT
//
// A control net, its words and its ends, as the file and the command line say them together.
//
// For each direction: the word is that of --word-u or --word-v over the JSON's over the axiom, the last two must agree
// when both speak; the ends are the JSON's `closed`, or the word's own form, or open.

#pragma once

#include "cli/arguments/options.h"
#include "internode/surface/grid.h"

#include <string>

namespace internode::cli {

/// With --u and --v the place after the command is the grid's. \throw Failure (Usage) for options that a grid has not,
/// or that only a grid has
void settle_grid_options(SubdivideOptions& options);

struct LoadedGrid {
    Grid grid;
    std::string source;
};

/// \throw Failure: File, Refused with what does not fit, Usage for a degree that is missing
[[nodiscard]] LoadedGrid load_grid(const SubdivideOptions& options);

} // namespace internode::cli
