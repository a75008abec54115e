// SPDX-License-Identifier: MIT
//
// Constants and functions: `t = 1/2`, `f(s, t) = min(s, 1) + min(t, 1)`. They use earlier definitions only, so that
// none can call itself.

#pragma once

#include "internode/grammar/lexing/statement.h"
#include "internode/grammar/points/point_context.h"

#include <span>

namespace internode {

/// Whether a statement without an arrow is a definition: a name, perhaps parentheses, then `=`.
[[nodiscard]] bool is_definition(const Statement& statement, std::string_view text);

/// Reads the definitions among the statements into context.definitions.
void read_definitions(std::span<const Statement> statements, PointContext& context);

} // namespace internode
