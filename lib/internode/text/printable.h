// SPDX-License-Identifier: MIT
//
// Text of a user as a terminal may see it, and the columns that it takes there.

#pragma once

#include "internode/text/utf8.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace internode {

/// Text of a user as a terminal may see it: control characters, bidirectional and invisible ones as \u{202e}, bytes
/// that are not UTF-8 as \xNN, a tab as four blanks.
[[nodiscard]] std::string printable(std::string_view text);

/// A code point as it is shown, and the columns that it takes: 0 for a combining mark, 2 for a wide character.
struct Shown {
    std::string text;
    std::size_t columns = 1;
};

/// The code point at text[place], which is `point`, as printable() shows it.
[[nodiscard]] Shown show(std::string_view text, std::size_t place, const CodePoint& point);

} // namespace internode
