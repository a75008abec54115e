// SPDX-License-Identifier: MIT

#include "internode/grammar/bundled.h"

#include <algorithm>

namespace internode {

std::vector<BundledGrammar> bundled_grammars(GrammarKind kind) {
    std::vector<BundledGrammar> found;
    for (const BundledGrammar& grammar : bundled_grammars())
        if (grammar.kind == kind) found.push_back(grammar);
    return found;
}

const BundledGrammar* find_bundled_grammar(std::string_view name) {
    const std::span<const BundledGrammar> all = bundled_grammars();
    const auto found = std::ranges::find(all, name, &BundledGrammar::name);
    return found == all.end() ? nullptr : &*found;
}

} // namespace internode
