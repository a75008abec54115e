// SPDX-License-Identifier: MIT
//
// What no statement sees: bytes that are no text, and lines that are too long.

#pragma once

#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/token.h"

#include <span>
#include <string_view>

namespace internode {

/// Complains of each broken token, and of lines of more than max_line_bytes. Cost: linear in the text.
void check_bytes(std::string_view text, std::span<const Token> tokens, Complaints& complaints);

} // namespace internode
