// SPDX-License-Identifier: MIT
//
// The user's text inside a comment that ends with its line.

#pragma once

#include <string>
#include <string_view>

namespace internode {

/// The text on one line of at most 900 bytes (MatrixMarket allows 1024): what a terminal or a reader could stumble
/// over, and bytes that are not UTF-8, become `?`.
[[nodiscard]] std::string comment_text(std::string_view text);

} // namespace internode
