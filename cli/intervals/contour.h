// SPDX-License-Identifier: MIT
//
// A polygon that is to be taken apart, as file and command line say it (input/settled_contour.h).

#pragma once

#include "cli/requests/options.h"
#include "internode/input/settled_contour.h"

namespace internode::cli {

/// \throw Failure: File, Refused with what does not fit and the numbers that would, Usage for what is missing
[[nodiscard]] SettledContour load_contour(const IntervalSystem& system, const ReverseOptions& options);

} // namespace internode::cli
