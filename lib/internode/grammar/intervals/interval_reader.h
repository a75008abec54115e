// SPDX-License-Identifier: MIT
//
// An interval grammar from the statements after its opening.

#pragma once

#include "internode/grammar/intervals/interval_grammar.h"
#include "internode/grammar/lexing/opened_text.h"

#include <optional>

namespace internode {

/// The grammar when there is nothing to complain of. The opening is readable. Cost: linear in the text.
[[nodiscard]] std::optional<IntervalGrammar> read_interval_grammar(const OpenedText& opened, Complaints& complaints);

} // namespace internode
