// SPDX-License-Identifier: MIT
//
// Cuts tokens at marks that stand outside brackets.

#pragma once

#include "internode/grammar/lexing/token.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace internode {

/// The indices of a mark outside `( )` and `[ ]`, which must have their partners (mark_unbalanced).
[[nodiscard]] std::vector<std::size_t> find_outside(std::span<const Token> tokens, std::string_view text, char mark);

/// The tokens before, between and after these indices: one part more than indices, perhaps empty ones.
[[nodiscard]] std::vector<std::span<const Token>> split_at(std::span<const Token> tokens,
                                                           const std::vector<std::size_t>& indices);

} // namespace internode
