// SPDX-License-Identifier: MIT
//
// A point grammar that can be run, for commands that ask about the grammar and not about one word of it.

#pragma once

#include "cli/shell/load.h"
#include "internode/point/point_system.h"
#include "internode/text/diagnostic.h"

#include <string>
#include <vector>

namespace internode::cli {

/// At its place in the grammar, or about the grammar as a whole.
[[nodiscard]] Diagnostic diagnostic_of(const LoadedText& text, const SourcePlace& place, const std::string& message,
                                       const std::string& hint);

/// \throw Failure (Refused) with everything that is wrong in the grammar
[[nodiscard]] PointSystem checked_system(const LoadedText& text, PointGrammar grammar, const PointSettings& settings);

/// For polygons of that dimension, with the constants that --set says. \throw Failure, Usage for --set
[[nodiscard]] PointSystem load_point_system(PointGrammar grammar, const LoadedText& text,
                                            const std::vector<std::string>& constants, std::size_t dimension);

/// \throw Failure (Refused) for open words, with what the command can do only with rings
void require_ring(const PointSystem& system, const std::string& name, const std::string& what);

} // namespace internode::cli
