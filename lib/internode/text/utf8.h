// SPDX-License-Identifier: MIT
//
// One code point of a text that may be damaged: a byte that starts no well-formed UTF-8 sequence (overlong forms,
// surrogates and values past U+10FFFF included) stands for itself, one byte long and not valid.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace internode {

struct CodePoint {
    char32_t value = 0;    ///< the byte itself when not valid
    std::size_t bytes = 1; ///< 1 … 4
    bool valid = false;
};

/// The text behind the byte order mark that it may begin with.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);

/// The code point at text[place]; place < text.size().
[[nodiscard]] CodePoint code_point_at(std::string_view text, std::size_t place);

/// The number of code points, damaged bytes counted one each.
[[nodiscard]] std::size_t count_code_points(std::string_view text);

/// Appends a code point up to U+10FFFF that is no surrogate.
void append_utf8(std::string& text, char32_t value);

} // namespace internode
