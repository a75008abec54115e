// SPDX-License-Identifier: MIT
//
// The signs and words of expressions, and how strongly they bind; shared by what reads and what prints.

#pragma once

#include "internode/expression/expression.h"
#include "internode/grammar/lexing/token_cursor.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace internode {

/// Of names, literals, calls and parentheses: nothing tears them apart.
inline constexpr int primary_precedence = 8;

/// From 1, `or`, to 7, the unary minus.
[[nodiscard]] int precedence(Operation operation);

/// min, max, floor, abs, sqrt.
[[nodiscard]] std::optional<Operation> builtin_function(std::string_view name);

/// "+", "<=", "and", "min": how an operation with a sign or a name is printed.
[[nodiscard]] std::string_view sign_of(Operation operation);

struct BinarySign {
    Operation operation = Operation::Add;
    std::size_t bytes = 1;
};

/// The sign of a binary operation at the cursor.
[[nodiscard]] std::optional<BinarySign> find_binary_sign(const TokenCursor& cursor);

/// The remedy for a sign of another language; may be empty.
[[nodiscard]] std::string_view hint_for_sign(std::string_view sign);

} // namespace internode
