// SPDX-License-Identifier: MIT
//
// A point grammar: what a `points` text says, before anything is decided about it. Parametric context-sensitive
// L-systems with affine geometry: Prusinkiewicz, Samavati, Smith, Karwowski 2003 (S0), sections 3 to 7;
// Prusinkiewicz, Shirmohammadi, Samavati 2010 (S1), equation 1.
//
//     label : left < predecessor > right : condition -> successor : weight
//
// A module is a letter with parameters. `#`, `[` and `]` are letters without parameters; the name of a query module
// begins with `?`. Modules match when letters and numbers of parameters agree, and S1 (2) has both B(x, y) and B(x).
// Such a letter is several symbols, each with one number of parameters; `B/1` is the name of the second.

#pragma once

#include "internode/expression/definition.h"
#include "internode/word/symbol.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

/// `P(1/4 u + 3/4 v)` in an axiom, an input or a successor.
struct ModuleTemplate {
    Symbol letter{};
    std::vector<Expression> arguments; ///< one argument for each parameter of the letter
    IncidentalPlace place;
    friend bool operator==(const ModuleTemplate&, const ModuleTemplate&) = default;
};

struct PointRule {
    std::string label; ///< may be empty
    std::vector<Symbol> left;
    std::vector<Symbol> predecessor; ///< at least one letter; more than one makes a pseudo-L-system
    std::vector<Symbol> right;
    /// All formals of left, predecessor and right, module by module, in the order of the text; all different.
    std::vector<std::string> formals;
    std::optional<Expression> condition; ///< a truth
    std::vector<ModuleTemplate> successor;
    std::optional<Expression> weight;   ///< weight of a stochastic rule: a number > 0
    std::optional<std::uint32_t> table; ///< none: in every table
    IncidentalPlace place;              ///< place of the whole rule
    friend bool operator==(const PointRule&, const PointRule&) = default;
};

/// What the points of a polygon become: `input P(v, 2) E | P(v, 0) E | P(v, 2)` for the first, each inner and the last.
/// With one part only, each point becomes that part (first and last are empty); `input # P(v) #` is short for
/// `input # P(v) | P(v) | P(v) #`, which is what it is read as.
struct PointInput {
    std::string formal; ///< the point
    std::vector<ModuleTemplate> first;
    std::vector<ModuleTemplate> each;
    std::vector<ModuleTemplate> last;
    bool has_ends = false; ///< three parts were given
    IncidentalPlace place;
    friend bool operator==(const PointInput&, const PointInput&) = default;
};

/// `q^n` in `cycle p q^n`.
struct CycleItem {
    std::uint32_t table = 0;
    std::optional<Expression> count; ///< how often, of constants; none: once
    IncidentalPlace place;
    friend bool operator==(const CycleItem&, const CycleItem&) = default;
};

struct PointGrammar {
    std::string name; ///< without control characters; empty when the text gives none
    bool ring = false;
    Alphabet letters;                    ///< the letters in the order of their first appearance in the normal form
    std::vector<std::uint32_t> arity;    ///< parameters of each letter
    std::vector<Definition> definitions; ///< constants and functions, in the order of the text
    std::vector<std::string> tables;     ///< names of the tables, in the order of the text
    std::vector<PointRule> rules;        ///< rules in the order of the text; the first that matches wins
    std::vector<CycleItem> cycle;        ///< not empty iff tables is not
    std::vector<std::vector<PointRule>> interpretations; ///< passes after the derivation, one after the other
    std::optional<PointInput> input;                     ///< none: `P(v)`
    std::optional<std::vector<ModuleTemplate>> axiom;
    friend bool operator==(const PointGrammar&, const PointGrammar&) = default;
};

/// A letter as the text has it: its name without `/1`.
[[nodiscard]] inline std::string_view letter_text(const PointGrammar& grammar, Symbol letter) {
    const std::string_view name = grammar.letters.name(letter);
    return name.substr(0, name.find('/'));
}

/// The symbol of a letter with so many parameters.
[[nodiscard]] std::optional<Symbol> find_letter(const PointGrammar& grammar, std::string_view text,
                                                std::size_t parameters);

/// The reserved letters, where the grammar uses them.
[[nodiscard]] inline std::optional<Symbol> end_marker(const PointGrammar& grammar) {
    return grammar.letters.find("#");
}
[[nodiscard]] inline std::optional<Symbol> branch_open(const PointGrammar& grammar) {
    return grammar.letters.find("[");
}
[[nodiscard]] inline std::optional<Symbol> branch_close(const PointGrammar& grammar) {
    return grammar.letters.find("]");
}

} // namespace internode
