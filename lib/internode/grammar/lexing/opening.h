// SPDX-License-Identifier: MIT
//
// The first statement of a grammar: `intervals NAME` or `points NAME`. A text whose first statement has an arrow is
// `intervals`.

#pragma once

#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/statement.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace internode {

struct Opening {
    std::string name;      ///< of the grammar; may be empty
    std::size_t first = 0; ///< index of the first statement after it
    bool readable = true;  ///< whether the rest is worth reading as a grammar of the wanted kind
};

/// Of a text that is read as an interval grammar.
[[nodiscard]] Opening read_opening(const Statements& split, std::string_view text, Complaints& complaints);

/// Of a text that is read as a point grammar.
[[nodiscard]] Opening read_points_opening(const Statements& split, std::string_view text, Complaints& complaints);

/// intervals, points, patches, mesh.
[[nodiscard]] bool is_kind(std::string_view word);

} // namespace internode
