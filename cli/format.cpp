// SPDX-License-Identifier: MIT

#include "cli/commands.h"
#include "cli/load.h"
#include "cli/output.h"
#include "internode/grammar/print.h"

namespace internode::cli {

ExitCode run(const FormatOptions& options, const Context&) {
    write_output(options.output.file, print(load_grammar(options.grammar)));
    return ExitCode::Success;
}

ExitCode run(const HelpRequest& request, const Context&) {
    write_output("-", request.text);
    return ExitCode::Success;
}

} // namespace internode::cli
