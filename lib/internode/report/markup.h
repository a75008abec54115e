// SPDX-License-Identifier: MIT
//
// Text of a user inside SVG, HTML and DOT: always text, never markup (docs/promises.md, P19).
//
// Controls, bidirectional overrides and bytes that are not UTF-8 become visible escapes first (text/diagnostic.h);
// XML has no way to say them at all. Then whatever the language would read as its own is written as an entity.

#pragma once

#include <string>
#include <string_view>

namespace internode {

/// `text` for element content and for attributes in double quotes, in XML and HTML alike.
[[nodiscard]] std::string markup(std::string_view text);

/// `text` as a quoted string of DOT, quotes included; a label shows exactly the text.
[[nodiscard]] std::string dot_quoted(std::string_view text);

} // namespace internode
