// SPDX-License-Identifier: MIT
//
// The first statement of a grammar: `intervals NAME` or `points NAME`. A text whose first statement has an arrow is
// `intervals`.

#pragma once

#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/grammar_kind.h"
#include "internode/grammar/lexing/statement.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace internode {

struct Opening {
    std::string name;      ///< name of the grammar; may be empty
    std::size_t first = 0; ///< index of the first statement after it
    bool readable = true;  ///< whether the rest is worth reading as a grammar of the wanted kind
};

/// The opening of a text that is read as a grammar of that kind.
[[nodiscard]] Opening read_opening(const Statements& split, std::string_view text, GrammarKind kind,
                                   Complaints& complaints);

/// The kind that the first token names which is no line end, `,` or `;`; Intervals when it names none.
[[nodiscard]] GrammarKind kind_of(std::span<const Token> tokens, std::string_view text);

/// intervals, points, patches, mesh.
[[nodiscard]] bool is_kind(std::string_view word);

} // namespace internode
