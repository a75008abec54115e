// SPDX-License-Identifier: MIT
//
// refine() of a point grammar.

#pragma once

#include "internode/grammar/points/point_grammar.h"
#include "internode/refine.h"
#include "internode/text/limits.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace internode {

/// What refine() was asked, with the text that its grammar was read from, which errors quote.
struct RefineRequest {
    std::string_view text;
    std::string_view source;
    std::span<const double> points; ///< whole rows
    std::size_t dimension;
    const RefineOptions& options;
    int steps; ///< 0 or more
};

/// The refusal of more than max_points points.
[[nodiscard]] LimitExceeded too_many_points(const RefineRequest& request);

/// The points of the word after all cycles and all interpretations. \throw as refine() (internode/refine.h)
[[nodiscard]] std::vector<double> refined(const PointGrammar& grammar, const RefineRequest& request);

} // namespace internode
