// SPDX-License-Identifier: MIT
//
// The command line as outputs show it (docs/promises.md, P25).

#pragma once

#include <string>

namespace internode::cli {

/// Base names of files, and no word about what changes no byte: threads, where outputs go.
[[nodiscard]] std::string public_command_line(int argc, const char* const* argv);

} // namespace internode::cli
