// SPDX-License-Identifier: MIT
//
// `input P(v, 2) E | P(v, 0) E | P(v, 2)`: what the points of a polygon become. Its point is the one name in it that
// is no constant.

#pragma once

#include "internode/grammar/lexing/statement.h"
#include "internode/grammar/points/point_context.h"
#include "internode/grammar/points/point_grammar.h"

namespace internode {

/// The input of a statement that begins with `input`. After a complaint parts may lack.
[[nodiscard]] PointInput read_point_input(const Statement& statement, PointContext& context);

} // namespace internode
