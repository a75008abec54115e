// SPDX-License-Identifier: MIT
//
// A polygon that is to be taken apart: its file and the command line say its degree, its ends, the word of the coarse
// polygon and the levels between; it may have to be resampled or cut to a number of points that is possible.

#pragma once

#include "cli/arguments/options.h"
#include "internode/curve/knots.h"
#include "internode/curve/reverse/resampling.h"

#include <string>
#include <vector>

namespace internode::cli {

struct LoadedContour {
    Knots coarse; ///< of the coarse polygon
    int levels = 0;
    std::size_t dimension = 2;
    std::vector<double> points; ///< as many as the knots ask for after the levels
    Fitting fitting;
    std::vector<std::string> columns; ///< names of the coordinates, when the file gives them
    std::string source;               ///< the base name of the file
};

/// \throw Failure: File, Refused with what does not fit and the numbers that would, Usage for what is missing
[[nodiscard]] LoadedContour load_contour(const IntervalSystem& system, const ReverseOptions& options);

} // namespace internode::cli
