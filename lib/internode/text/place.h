// SPDX-License-Identifier: MIT
//
// From a byte of a text to the line and column that a person counts, and to a Diagnostic there.

#pragma once

#include "internode/text/diagnostic.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace internode {

struct TextPlace {
    std::size_t line = 1;   ///< from 1
    std::size_t column = 1; ///< from 1, in code points (bytes 10xxxxxx are not counted)
};

/// The place of text[offset]; offset == size() is the end. Cost: linear in offset, and linear in the step when it
/// continues from the `known` place of an earlier offset.
[[nodiscard]] TextPlace place_of(std::string_view text, std::size_t offset);
[[nodiscard]] TextPlace place_of(std::string_view text, std::size_t offset, std::size_t known_offset, TextPlace known);

/// The columns that a piece of a line takes, at least 1: how wide the mark below it is.
[[nodiscard]] std::size_t columns_of(std::string_view piece);

/// A diagnostic at text[offset], with the source line unless it is longer than max_shown_line_bytes.
[[nodiscard]] Diagnostic diagnostic_at(std::string_view text, std::size_t offset, std::string_view source,
                                       std::string message);

/// The same for a place already counted; cost: linear in the text before it.
[[nodiscard]] Diagnostic diagnostic_at(std::string_view text, TextPlace place, std::string_view source,
                                       std::string message);

} // namespace internode
