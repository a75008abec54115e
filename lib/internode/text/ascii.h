// SPDX-License-Identifier: MIT
//
// Letters and digits of ASCII, in any locale.

#pragma once

namespace internode {

[[nodiscard]] constexpr bool is_ascii_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

[[nodiscard]] constexpr bool is_ascii_digit(char c) {
    return c >= '0' && c <= '9';
}

} // namespace internode
