// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/shell/output.h"

namespace internode::cli {

ExitCode run(const HelpRequest& request, const Context&) {
    write_output("-", request.text);
    return ExitCode::Success;
}

} // namespace internode::cli
