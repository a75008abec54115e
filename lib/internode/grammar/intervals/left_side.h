// SPDX-License-Identifier: MIT
//
// The left sides of all rules, read before anything else because a rule may use a symbol before that symbol's own
// rule. They make the alphabet: symbols stand in the order of their rules.

#pragma once

#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/statement.h"
#include "internode/word/symbol.h"

#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace internode {

struct LeftSides {
    Alphabet alphabet;
    std::vector<std::optional<Symbol>>
        symbols; ///< symbol before the arrow of each statement; none when it has no good one
    std::unordered_set<std::string> excused; ///< names in left sides that could not be read: they may have a rule
    bool readable = true;                    ///< false when there are more symbols than max_symbols
};

/// Reads the statements from number `first` on. Cost: linear in the statements.
[[nodiscard]] LeftSides read_left_sides(const Statements& split, std::size_t first, std::string_view text,
                                        Complaints& complaints);

} // namespace internode
