// SPDX-License-Identifier: MIT
//
// From a command to the handler of the grammar's kind. The text is read once; the kind is the alternative that it
// became. A new kind is an alternative of the variant, a folder with its handlers, and an include here.

#pragma once

#include "cli/intervals/handlers.h"
#include "cli/points/handlers.h"
#include "cli/shell/load.h"

#include <variant>

namespace internode::cli {

/// Calls run(grammar, text, options, context) of the kind that the grammar has. \throw Failure as load_grammar()
template<class Options>
ExitCode run_by_kind(const Options& options, const Context& context) {
    const LoadedGrammar loaded = load_grammar(options.grammar);
    return std::visit([&](const auto& grammar) { return run(grammar, loaded.text, options, context); }, loaded.grammar);
}

} // namespace internode::cli
