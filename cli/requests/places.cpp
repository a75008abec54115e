// SPDX-License-Identifier: MIT

#include "cli/requests/places.h"

#include "cli/requests/exit_code.h"

#include <utility>

namespace internode::cli {

void settle_places(GrammarSource& grammar, PolygonOptions& polygon) {
    if (grammar.expression && polygon.place.empty()) std::swap(grammar.place, polygon.place);
    if (polygon.place == "-" && grammar.place == "-")
        throw failure(ExitCode::Usage, "grammar and polygon cannot both come from stdin");
}

void require_polygon(const PolygonOptions& polygon) {
    if (polygon.place.empty())
        throw failure(ExitCode::Usage, "no control polygon", "give a CSV, JSON or OBJ file, or - for stdin");
}

void check_grammar(const GrammarSource& grammar) {
    if (grammar.place.empty() == !grammar.expression.has_value())
        throw failure(ExitCode::Usage, grammar.expression ? "a grammar file and -e exclude each other" : "no grammar",
                      "give a file, @name (see `internode grammars`), - or -e 'L->SL, S->L'");
}

} // namespace internode::cli
