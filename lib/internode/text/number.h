// SPDX-License-Identifier: MIT
//
// Doubles as text: the only place where a double is read or written in decimal.
//
// Reading takes the whole token or nothing, is correctly rounded (ties to even) and knows no locale: `1,5`, `nan`,
// `inf`, `0x1` and `1e` are no numbers. Writing is the shortest text that reads back bit for bit, the sign of zero
// included.

#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>

namespace internode {

/// "3", "-0.25", ".5", "5.", "1e-3", "+1" (some CSV writers put the plus). Empty for anything else and for what rounds
/// to infinity; what rounds to zero is a zero of its sign.
[[nodiscard]] std::optional<double> parse_double(std::string_view text);

/// The shortest decimal text of a finite double. \throw std::invalid_argument for NaN and infinities
[[nodiscard]] std::string to_string(double value);

/// Integers have std::to_string; as doubles 10000000 would print as 1e+07.
template<std::integral T>
std::string to_string(T value) = delete;

/// to_string(value) put at the end of `text`.
void append(std::string& text, double value);

} // namespace internode
