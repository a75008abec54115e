// SPDX-License-Identifier: MIT
//
// From argv to a request. The only place that knows CLI11.

#pragma once

#include "cli/requests/options.h"

namespace internode::cli {

struct CommandLine {
    CommonOptions common;
    Request request;
};

/// \throw Failure (ExitCode::Usage) with a message and, where something is near, a "did you mean".
[[nodiscard]] CommandLine read_command_line(int argc, const char* const* argv);

} // namespace internode::cli
