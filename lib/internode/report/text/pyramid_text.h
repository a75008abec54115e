// SPDX-License-Identifier: MIT
//
// The levels of a pyramid and what its details are worth, for a terminal.

#pragma once

#include "internode/report/pyramid_report.h"

#include <string>

namespace internode {

/// A table of the levels and what the details are worth.
[[nodiscard]] std::string pyramid_text(const PyramidReport& report);

/// One sentence about ill-conditioned ends and G, without a newline; empty for closed and clamped polygons.
[[nodiscard]] std::string loose_ends_warning(const PyramidReport& report);

} // namespace internode
