// SPDX-License-Identifier: MIT
//
// What a pyramid costs: its levels alone, its rounding, and the details that are left out. All measured, none
// estimated.

#pragma once

#include "internode/curve/reverse/pyramid.h"

#include <vector>

namespace internode {

/// What each level, 0 … n, is worth alone: its polygon, refined without details, against the fine one.
[[nodiscard]] std::vector<PolygonError> approximation_errors(const Analysis& analysis);

struct PyramidErrors {
    std::vector<PolygonError> approximations; ///< errors of each level alone, against the fine polygon
    std::vector<PolygonError> round_trips;    ///< errors of each level put together again from all details
    PolygonError kept;                        ///< error of the fine polygon put together from the kept details
};

/// Puts both pyramids together again and measures, on at most `threads` threads (0: all that there are). `kept` holds
/// some or all of the details of the analysis.
[[nodiscard]] PyramidErrors pyramid_errors(const Analysis& analysis, const Pyramid& kept, int threads = 1);

} // namespace internode
