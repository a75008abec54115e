// SPDX-License-Identifier: MIT
//
// A point grammar from the statements after its opening.

#pragma once

#include "internode/grammar/lexing/opened_text.h"
#include "internode/grammar/points/point_grammar.h"

#include <optional>

namespace internode {

/// The grammar; damaged after a complaint. The opening is readable. Cost: linear in the text.
[[nodiscard]] std::optional<PointGrammar> read_point_grammar(const OpenedText& opened, Complaints& complaints);

} // namespace internode
