// SPDX-License-Identifier: MIT
//
// What `internode validate` says about a point grammar, for a person at a terminal.

#pragma once

#include "internode/grammar/points/point_grammar.h"
#include "internode/point/check/point_validation.h"

#include <string>
#include <string_view>

namespace internode {

/// The text that a grammar was read from, for the lines of its rules.
struct GrammarSourceText {
    std::string_view text;
    std::string_view source; ///< file name as the user gave it
};

[[nodiscard]] std::string point_validation_text(const PointValidation& validation, const PointGrammar& grammar,
                                                const GrammarSourceText& source);

/// "rule 2 (`p1`), module 3", "the axiom, module 1", "interpretation 1, rule 2, module 1": where an argument stands.
[[nodiscard]] std::string place_text(const PointGrammar& grammar, const ArgumentPlace& where);

/// "the coefficients sum to 5/4, not to 1"; empty for an affine combination.
[[nodiscard]] std::string finding_text(const AffineFinding& finding);

/// "`P` between `P P` and the end of the word stays (no rule fits)", with the table and the first example.
[[nodiscard]] std::string staying_text(const StayingContext& context, const PointGrammar& grammar);

} // namespace internode
