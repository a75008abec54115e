// SPDX-License-Identifier: MIT
//
// What the commands do with grids: two grammars, one along each direction.

#pragma once

#include "cli/requests/exit_code.h"
#include "cli/requests/options.h"

namespace internode::cli {

/// `subdivide` with --u and --v.
ExitCode subdivide_grid(const SubdivideOptions& options, const Context& context);

} // namespace internode::cli
