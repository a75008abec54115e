// SPDX-License-Identifier: MIT
//
// The normal form must be readable again: powers and exponents written out may exceed a line or a text.

#pragma once

#include "internode/grammar/lexing/complaints.h"

#include <string_view>

namespace internode {

/// Complains of a printed grammar that exceeds max_grammar_bytes, or a line of it max_line_bytes.
void check_normal_form(std::string_view printed, Complaints& complaints);

} // namespace internode
