// SPDX-License-Identifier: MIT
//
// `cycle p q^n`: the tables of the derivation steps of one cycle. A count is an integer, the name of a constant, or an
// expression of constants in parentheses.

#pragma once

#include "internode/grammar/lexing/statement.h"
#include "internode/grammar/points/point_context.h"
#include "internode/grammar/points/point_grammar.h"

#include <string>
#include <vector>

namespace internode {

/// The cycle of a statement that begins with `cycle`. After a complaint items may lack.
[[nodiscard]] std::vector<CycleItem> read_cycle_items(const Statement& statement,
                                                      const std::vector<std::string>& tables, PointContext& context);

} // namespace internode
