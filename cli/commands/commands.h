// SPDX-License-Identifier: MIT
//
// One function per command, each in a file of its own: finds the kind of grammar and calls its handler, or calls the
// library and prints. No mathematics here.

#pragma once

#include "cli/requests/exit_code.h"
#include "cli/requests/options.h"

namespace internode::cli {

ExitCode run(const ValidateOptions& options, const Context& context);
ExitCode run(const MasksOptions& options, const Context& context);
ExitCode run(const SubdivideOptions& options, const Context& context);
ExitCode run(const ConvergeOptions& options, const Context& context);
ExitCode run(const ReverseOptions& options, const Context& context);
ExitCode run(const InferOptions& options, const Context& context);
ExitCode run(const ComposeOptions& options, const Context& context);
ExitCode run(const WordOptions& options, const Context& context);
ExitCode run(const FormatOptions& options, const Context& context);
ExitCode run(const MeshOptions& options, const Context& context);
ExitCode run(const FormatsOptions& options, const Context& context);
ExitCode run(const GrammarsOptions& options, const Context& context);
ExitCode run(const LimitsOptions& options, const Context& context);
ExitCode run(const VersionOptions& options, const Context& context);
ExitCode run(const HelpRequest& request, const Context& context);

} // namespace internode::cli
