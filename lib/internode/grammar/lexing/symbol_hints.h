// SPDX-License-Identifier: MIT
//
// Remedies for a name that is no symbol: the other case, a zero joined to a symbol (`L0` for `L 0`), a near name.

#pragma once

#include "internode/word/symbol.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace internode {

class SymbolHints {
public:
    /// The alphabet must outlive the hints and not change.
    explicit SymbolHints(const Alphabet& alphabet)
        : alphabet_(alphabet) {}

    /// A remedy for a name used in a word of a given alphabet; may be empty.
    [[nodiscard]] std::string in_word(std::string_view name);
    /// The same inside a grammar, where a rule for the name is a remedy too.
    [[nodiscard]] std::string in_grammar(std::string_view name);

private:
    [[nodiscard]] std::string near_name(std::string_view name);
    [[nodiscard]] std::string zeros_apart(std::string_view name) const;

    const Alphabet& alphabet_;
    std::size_t searches_ = 0;
};

} // namespace internode
