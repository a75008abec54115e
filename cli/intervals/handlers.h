// SPDX-License-Identifier: MIT
//
// What the commands do with interval grammars: one handler a command, in a file of its own. cli/commands/by_kind.h
// calls them; each chooses its format, which refuses the options that would do nothing.

#pragma once

#include "cli/requests/exit_code.h"
#include "cli/requests/options.h"
#include "cli/shell/load.h"
#include "internode/grammar/intervals/interval_grammar.h"

namespace internode::cli {

ExitCode run(const IntervalGrammar& grammar, const LoadedText& text, const ValidateOptions& options,
             const Context& context);
ExitCode run(const IntervalGrammar& grammar, const LoadedText& text, const MasksOptions& options,
             const Context& context);
ExitCode run(const IntervalGrammar& grammar, const LoadedText& text, const SubdivideOptions& options,
             const Context& context);
ExitCode run(const IntervalGrammar& grammar, const LoadedText& text, const ReverseOptions& options,
             const Context& context);

} // namespace internode::cli
