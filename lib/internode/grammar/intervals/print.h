// SPDX-License-Identifier: MIT
//
// From grammar to text: the normal form of the language. parse_grammar(print(g)) == g for every grammar.

#pragma once

#include "internode/grammar/intervals/interval_grammar.h"

#include <string>

namespace internode {

/// One statement a line: kind and name, rules, axiom, lengths; ASCII only, ends with a newline.
[[nodiscard]] std::string print(const IntervalGrammar& grammar);

} // namespace internode
