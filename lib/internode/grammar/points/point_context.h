// SPDX-License-Identifier: MIT
//
// What the readers of a point grammar's statements share: the text, the names and letters so far, the limits used.

#pragma once

#include "internode/grammar/expressions/expression_reader.h"
#include "internode/grammar/expressions/name_scope.h"
#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/points/letter_table.h"

#include <cstddef>
#include <string_view>

namespace internode {

struct PointContext {
    std::string_view text;
    Complaints& complaints;
    LetterTable letters;
    DefinitionTable definitions;
    PointBudget budget;
    std::size_t searches = 0; ///< searches for names that could be meant
    bool repeated = false;    ///< a power was written out
    std::size_t repeated_instructions = 0;

    PointContext(std::string_view whole_text, Complaints& all_complaints)
        : text(whole_text)
        , complaints(all_complaints)
        , letters(all_complaints) {}

    [[nodiscard]] ExpressionContext expressions(NameScope& scope) {
        return {text, scope, budget, complaints, searches, 0};
    }
};

/// Whether a run may name a formal, a constant, a function, a table or a rule; complains if not.
[[nodiscard]] bool check_name(std::string_view run, Complaints::Place place, Complaints& complaints);

} // namespace internode
