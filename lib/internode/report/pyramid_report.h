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
    Analysis analysis;  ///< with all details
    Pyramid kept;       ///< with those that are kept
    bool thresholded = false;
    std::vector<PolygonError> approximations; ///< of each level alone, against the fine polygon
    std::vector<PolygonError> round_trips;    ///< of each level put together again from all details
    PolygonError kept_error;                  ///< of the fine polygon put together from the kept details
};

/// Puts both pyramids together again and measures. `kept` holds some of the details of the analysis.
[[nodiscard]] PyramidReport pyramid_report(Analysis analysis, Pyramid kept, const Fitting& fitting,
                                           const std::string& source);

/// A table of the levels and what the details are worth, for a terminal.
[[nodiscard]] std::string pyramid_text(const PyramidReport& report);

/// One sentence about ill-conditioned ends and G, without a newline; empty for closed and clamped polygons.
[[nodiscard]] std::string loose_ends_warning(const PyramidReport& report);

/// Format "internode-pyramid" of the kept details (docs/json.md): enough to put the fine polygon together.
[[nodiscard]] std::string pyramid_json(const PyramidReport& report, const Generator& generator);

/// Every level as a panel over the fine polygon, finest first. An SVG text, 960 pixels wide.
[[nodiscard]] std::string pyramid_picture(const PyramidReport& report, const Generator& generator);

} // namespace internode
