// SPDX-License-Identifier: MIT
//
// Which place on the command line is the grammar's and which the polygon's.

#pragma once

#include "cli/requests/options.h"

namespace internode::cli {

/// A grammar and a polygon both stand first on the line: with -e the one place given is the polygon's.
/// \throw Failure (Usage) when both come from stdin
void settle_places(GrammarSource& grammar, PolygonOptions& polygon);

/// \throw Failure (Usage) without a polygon
void require_polygon(const PolygonOptions& polygon);

/// \throw Failure (Usage) unless there is one grammar, by place or as a text
void check_grammar(const GrammarSource& grammar);

} // namespace internode::cli
