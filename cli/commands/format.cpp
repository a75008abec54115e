// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/grammar/intervals/print.h"
#include "internode/grammar/points/print_points.h"

namespace internode::cli {

ExitCode run(const FormatOptions& options, const Context&) {
    const LoadedGrammar loaded = load_grammar(options.grammar);
    write_output(options.output.file, std::visit([](const auto& grammar) { return print(grammar); }, loaded.grammar));
    return ExitCode::Success;
}

} // namespace internode::cli
