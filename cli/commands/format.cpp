// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/grammar/grammar_kind.h"
#include "internode/grammar/intervals/print.h"
#include "internode/grammar/points/print_points.h"

namespace internode::cli {
ExitCode run(const FormatOptions& options, const Context&) {
    const LoadedText input = load_grammar_text(options.grammar);
    write_output(options.output.file, kind_of(input.text) == GrammarKind::Points ? print(load_point_grammar(input))
                                                                                 : print(load_grammar(input)));
    return ExitCode::Success;
}

ExitCode run(const HelpRequest& request, const Context&) {
    write_output("-", request.text);
    return ExitCode::Success;
}

} // namespace internode::cli
