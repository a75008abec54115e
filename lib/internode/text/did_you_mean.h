// SPDX-License-Identifier: MIT
//
// Which word was meant by one that is misspelt.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace internode {

/// The candidate closest to `word` in edits (insert, delete, replace, swap neighbours), if near enough to be meant.
/// Near is at most a third of its length, at least 1, or the same but for case. Empty otherwise. The first of equals.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

} // namespace internode
