// SPDX-License-Identifier: MIT
//
// What is reported of a pyramid: where its fine polygon came from, its levels, what rounding and thresholds cost.

#pragma once

#include "internode/curve/reverse/pyramid.h"
#include "internode/curve/reverse/resampling.h"
#include "internode/report/generator.h"

#include <string>
#include <vector>

namespace internode {

struct PyramidReport {
    std::string source; ///< the polygon's, for titles
    Fitting fitting;    ///< how the measured polygon became the fine one
    Analysis analysis;  ///< the pyramid with all details
    Pyramid kept;       ///< the pyramid with the details that are kept
    bool thresholded = false;
    std::vector<PolygonError> approximations; ///< errors of each level alone, against the fine polygon
    std::vector<PolygonError> round_trips;    ///< errors of each level put together again from all details
    PolygonError kept_error;                  ///< error of the fine polygon put together from the kept details
};

/// Puts both pyramids together again and measures. `kept` holds some of the details of the analysis.
[[nodiscard]] PyramidReport pyramid_report(Analysis analysis, Pyramid kept, const Fitting& fitting,
                                           const std::string& source);

} // namespace internode
