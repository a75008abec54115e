// SPDX-License-Identifier: MIT
//
// From grammar to text: the normal form of its kind. parse(print(g)) == g for every grammar that was read.

#pragma once

#include "internode/grammar/grammar.h"

#include <string>

namespace internode {

/// One statement a line, ASCII only, ends with a newline.
[[nodiscard]] std::string print(const Grammar& grammar);

} // namespace internode
