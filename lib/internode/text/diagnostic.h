// SPDX-License-Identifier: MIT
//
// What is wrong in a text, and where: the one form of complaint for grammars, polygons and words.
//
// Lines and columns count from 1; a column counts code points, not bytes. The message names the offence, the hint the
// remedy. Text of the user is shown with control characters escaped, so that a terminal cannot be commanded by a file.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

struct Diagnostic {
    std::string source;     ///< file name as the user gave it, or "<expression>", "<stdin>", "<word>"
    std::size_t line = 0;   ///< from 1; 0 when the whole text is meant
    std::size_t column = 0; ///< from 1; 0 when the whole line is meant
    std::size_t width = 1;  ///< code points under the caret
    std::string message;    ///< "`S` has no rule"
    std::string hint;       ///< "write `S -> S` if it should stay whole"; may be empty
    std::string
        source_line; ///< the offending line, raw, or the part of a very long one round the offence; may be empty
    std::size_t source_column = 1; ///< the column of the first code point of source_line
    std::string_view code;         ///< stable name of the error, a literal: "grammar.no-rule"; empty where it has none
};

/// The most errors shown of one text; the rest is counted.
inline constexpr std::size_t shown_errors = 20;

/// `source:line:column: error: message`, the source line, a caret line, `hint: …`. Ends with a newline. Control
/// characters, bidirectional overrides and bytes that are not UTF-8 are escaped; long lines are cut round the caret.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

/// The first shown_errors diagnostics, then "and N more errors" when there are more.
[[nodiscard]] std::string to_string(const std::vector<Diagnostic>& diagnostics);

} // namespace internode
