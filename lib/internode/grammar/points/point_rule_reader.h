// SPDX-License-Identifier: MIT
//
// One rule of a point grammar:
//
//     label : left < predecessor > right : condition -> successor : weight
//
// With one colon before the arrow, a single name before it is the label, unless `(` follows: `E : (n > 2) -> F` has a
// condition.

#pragma once

#include "internode/grammar/lexing/statement.h"
#include "internode/grammar/points/point_context.h"
#include "internode/grammar/points/point_grammar.h"

namespace internode {

/// The rule of a statement with an arrow. After a complaint the rule may lack parts. Its table is left open.
[[nodiscard]] PointRule read_point_rule(const Statement& statement, PointContext& context);

} // namespace internode
