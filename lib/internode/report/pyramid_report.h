// SPDX-License-Identifier: MIT
//
// What is reported of a pyramid: where its fine polygon came from, its levels, what rounding and thresholds cost.

#pragma once

#include "internode/curve/reverse/pyramid_errors.h"
#include "internode/curve/reverse/resampling.h"

#include <string>

namespace internode {

struct PyramidReport {
    std::string source; ///< the polygon's, for titles
    Fitting fitting;    ///< how the measured polygon became the fine one
    Analysis analysis;  ///< the pyramid with all details
    Pyramid kept;       ///< the pyramid with the details that are kept
    PyramidErrors errors;
};

/// With the errors measured, on `threads` threads as pyramid_errors() has them. `kept` holds some or all of the details
/// of the analysis.
[[nodiscard]] PyramidReport pyramid_report(Analysis analysis, Pyramid kept, const Fitting& fitting,
                                           const std::string& source, int threads = 1);

} // namespace internode
