// SPDX-License-Identifier: MIT
//
// The grammars that come with the library, compiled in from data/grammars: no file is looked for at run time.

#pragma once

#include <span>
#include <string_view>

namespace internode {

struct BundledGrammar {
    std::string_view name; ///< as in `@fibonacci`
    std::string_view text; ///< the .lsys text, its source in the comments
};

/// All of them, in the order of their names.
[[nodiscard]] std::span<const BundledGrammar> bundled_grammars();

/// The grammar of that name, without `@`; null if there is none.
[[nodiscard]] const BundledGrammar* find_bundled_grammar(std::string_view name);

} // namespace internode
