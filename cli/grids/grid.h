// SPDX-License-Identifier: MIT
//
// A control net as file and command line say it (input/settled_grid.h).

#pragma once

#include "cli/requests/options.h"
#include "internode/surface/grid.h"

#include <string>

namespace internode::cli {

struct LoadedGrid {
    Grid grid;
    std::string source;
};

/// \throw Failure: File, Refused with what does not fit, Usage for a degree that is missing
[[nodiscard]] LoadedGrid load_grid(const SubdivideOptions& options);

} // namespace internode::cli
