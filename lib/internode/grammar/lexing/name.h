// SPDX-License-Identifier: MIT
//
// The name of a grammar: plain, a letter and then letters, digits, `_` or `'`; or quoted, with the escapes `\"`,
// `\\` and `\u{1f331}`. A name has no control characters; anything else of Unicode may stand in quotes.

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace internode {

/// The name that a plain or quoted text stands for; empty if it stands for none.
[[nodiscard]] std::optional<std::string> read_grammar_name(std::string_view text);

/// The text of a name, in ASCII: plain where that can be. A control character or a byte that is not UTF-8 becomes
/// U+FFFD.
[[nodiscard]] std::string write_grammar_name(std::string_view name);

} // namespace internode
