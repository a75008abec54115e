// SPDX-License-Identifier: MIT
//
// What stands in the metadata of outputs.

#pragma once

#include "cli/requests/options.h"
#include "internode/report/generator.h"

namespace internode::cli {

/// The version, and the command line as outputs show it.
[[nodiscard]] Generator generator(const Context& context);

} // namespace internode::cli
