// SPDX-License-Identifier: MIT

#include "cli/commands/by_kind.h"
#include "cli/commands/commands.h"

namespace internode::cli {

ExitCode run(const ValidateOptions& options, const Context& context) {
    return run_by_kind(options, context);
}

} // namespace internode::cli
