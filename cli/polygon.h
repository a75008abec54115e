// SPDX-License-Identifier: MIT
//
// A control polygon, its word and its ends, as the file and the command line say them together.
//
// The word: --word over the JSON's over the axiom; the last two must agree when both speak. Ends: an option, or the
// JSON's `closed`, or the word's own form, or open. --repeat repeats the letters and cuts at the N or N + d needed.

#pragma once

#include "cli/options.h"
#include "internode/curve/curve.h"

#include <string>
#include <vector>

namespace internode::cli {

struct LoadedCurve {
    Curve curve;
    std::vector<std::string> columns; ///< names of the coordinates, when the file gives them
    std::string source;               ///< for titles: the base name of the file
};

/// \throw Failure: File, Refused with what does not fit, Usage for a degree that is missing
[[nodiscard]] LoadedCurve load_curve(const IntervalSystem& system, const PolygonOptions& options);

} // namespace internode::cli
