// SPDX-License-Identifier: MIT
//
// One function per command, each in a file of its own: calls the library and prints. No mathematics here.

#pragma once

#include "cli/shell/exit_code.h"
#include "cli/shell/load.h"
#include "cli/arguments/options.h"
#include "internode/report/generator.h"

namespace internode::cli {

struct LoadedText;

/// What a command needs of its surroundings.
using Context = CommonOptions;

/// What stands in the metadata of outputs.
[[nodiscard]] Generator generator(const Context& context);

ExitCode run(const ValidateOptions& options, const Context& context);
ExitCode run(const MasksOptions& options, const Context& context);
/// `masks` with a point grammar.
ExitCode masks_points(const LoadedText& text, const MasksOptions& options, const Context& context);
ExitCode run(const SubdivideOptions& options, const Context& context);
/// `subdivide` with --u and --v.
ExitCode subdivide_grid(const SubdivideOptions& options, const Context& context);
/// `subdivide` with a point grammar.
ExitCode subdivide_points(const LoadedText& grammar, const SubdivideOptions& options, const Context& context);
ExitCode run(const ConvergeOptions& options, const Context& context);
ExitCode run(const ReverseOptions& options, const Context& context);
/// `reverse` with a point grammar.
ExitCode reverse_points(const LoadedText& text, const ReverseOptions& options, const Context& context);
ExitCode run(const InferOptions& options, const Context& context);
ExitCode run(const ComposeOptions& options, const Context& context);
ExitCode run(const WordOptions& options, const Context& context);
ExitCode run(const FormatOptions& options, const Context& context);
ExitCode run(const GrammarsOptions& options, const Context& context);
ExitCode run(const LimitsOptions& options, const Context& context);
ExitCode run(const VersionOptions& options, const Context& context);
ExitCode run(const HelpRequest& request, const Context& context);

} // namespace internode::cli
