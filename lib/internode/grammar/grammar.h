// SPDX-License-Identifier: MIT
//
// A grammar of any kind that this version reads. Whoever works with one kind visits the variant: a new kind is a new
// alternative, which the compiler then asks every visitor for.

#pragma once

#include "internode/grammar/intervals/interval_grammar.h"
#include "internode/grammar/lexing/grammar_kind.h"
#include "internode/grammar/points/point_grammar.h"

#include <string>
#include <variant>

namespace internode {

using Grammar = std::variant<IntervalGrammar, PointGrammar>;

[[nodiscard]] GrammarKind kind_of(const Grammar& grammar);

/// The name that the text gives; may be empty.
[[nodiscard]] const std::string& name_of(const Grammar& grammar);

} // namespace internode
