// SPDX-License-Identifier: MIT
//
// Which kind of grammar a text is, by its first statement.

#pragma once

#include <string_view>

namespace internode {

enum class GrammarKind { Intervals, Points };

/// The kind that the first statement names: Points for `points`, Intervals for everything else, errors included.
/// Cost: linear in the text; whoever reads it anyway asks the grammar that parse() returns.
[[nodiscard]] GrammarKind kind_of(std::string_view text);

} // namespace internode
