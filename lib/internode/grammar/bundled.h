// SPDX-License-Identifier: MIT
//
// The grammars that come with the library, compiled in from data/grammars: no file is looked for at run time.

#pragma once

#include "internode/grammar/lexing/grammar_kind.h"

#include <span>
#include <string_view>
#include <vector>

namespace internode {

struct BundledGrammar {
    std::string_view name; ///< the name after the `@`, as in `@fibonacci`, `@s0/13`
    std::string_view text; ///< the .lsys text, its source in the comments
    GrammarKind kind = GrammarKind::Intervals;
};

/// All of them, in the order of their names.
[[nodiscard]] std::span<const BundledGrammar> bundled_grammars();

/// Those of one kind, in the same order.
[[nodiscard]] std::vector<BundledGrammar> bundled_grammars(GrammarKind kind);

/// The grammar of that name, without `@`; null if there is none.
[[nodiscard]] const BundledGrammar* find_bundled_grammar(std::string_view name);

} // namespace internode
