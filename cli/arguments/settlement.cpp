// SPDX-License-Identifier: MIT

#include "cli/arguments/settlement.h"

#include "cli/requests/exit_code.h"
#include "cli/requests/places.h"

#include <fmt/format.h>

#include <utility>

namespace internode::cli {
namespace {

void settle_grid(SubdivideOptions& options) {
    const auto& [u, v] = options.sides;
    if (u.grammar.empty() || v.grammar.empty())
        throw failure(ExitCode::Usage, fmt::format("no grammar along {}", u.grammar.empty() ? 'u' : 'v'),
                      "a grid needs both --u and --v");
    if (options.grammar.place.empty() || !options.polygon.place.empty())
        throw failure(ExitCode::Usage, options.grammar.place.empty() ? "no grid" : "a second grid",
                      "beside --u and --v give one JSON file, or - for stdin");
    std::swap(options.grammar.place, options.polygon.place);
    if ((u.grammar == "-") + (v.grammar == "-") + (options.polygon.place == "-") > 1)
        throw failure(ExitCode::Usage, "grammars and grid cannot come from stdin together");
}

} // namespace

void settle(ValidateOptions& options) {
    check_grammar(options.grammar);
}

void settle(MasksOptions& options) {
    check_grammar(options.grammar);
}

void settle(WordOptions& options) {
    check_grammar(options.grammar);
}

void settle(FormatOptions& options) {
    check_grammar(options.grammar);
}

void settle(SubdivideOptions& options) {
    if (options.is_grid()) return settle_grid(options);
    if (options.sides[0].degree != options.sides[1].degree)
        throw failure(ExitCode::Usage, "only a grid has two degrees", "give their grammars: --u G --v G");
    settle_places(options.grammar, options.polygon);
    check_grammar(options.grammar);
}

void settle(ConvergeOptions& options) {
    settle_places(options.grammar, options.polygon);
    check_grammar(options.grammar);
    require_polygon(options.polygon);
}

void settle(ReverseOptions& options) {
    settle_places(options.grammar, options.polygon);
    check_grammar(options.grammar);
}

} // namespace internode::cli
