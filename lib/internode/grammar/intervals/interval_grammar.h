// SPDX-License-Identifier: MIT
//
// An interval grammar: what an `intervals` text says, before anything is decided about it.
//
// Every symbol has exactly one rule with at least one letter; symbols stand in the order of their rules.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/word/morphism.h"

#include <optional>
#include <string>
#include <vector>

namespace internode {

/// The initial configuration α: the word of all N + d intervals of an open polygon, or N of a closed one.
struct Axiom {
    Word word; ///< at least one letter; may contain `0`
    Ends ends = Ends::Open;
    friend bool operator==(const Axiom&, const Axiom&) = default;
};

/// `length L = 3/2`.
struct LengthDeclaration {
    Symbol symbol{};
    Rational length; ///< > 0
    friend bool operator==(const LengthDeclaration&, const LengthDeclaration&) = default;
};

struct IntervalGrammar {
    std::string name; ///< without control characters; empty when the text gives none
    Alphabet alphabet;
    Morphism rules; ///< one image per symbol of the alphabet
    std::optional<Axiom> axiom;
    std::vector<LengthDeclaration> lengths;
    friend bool operator==(const IntervalGrammar&, const IntervalGrammar&) = default;
};

} // namespace internode
