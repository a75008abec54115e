// SPDX-License-Identifier: MIT
//
// Systems and words for tests, from short texts.

#pragma once

#include "internode/grammar/bundled.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/interval/validity.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace internode::reference {

/// The valid system of a text such as "L->SL, S->L".
inline IntervalSystem system_of(std::string_view text) {
    const ParsedGrammar parsed = parse_grammar(text, "<test>");
    if (!parsed.grammar) throw std::invalid_argument("not a grammar: " + std::string(text));
    const Verdict verdict = validate(*parsed.grammar);
    if (!verdict.system) throw std::invalid_argument("not valid and exact: " + std::string(text));
    return *verdict.system;
}

/// A word of one-letter symbols and `0`.
inline Word word_of(const IntervalSystem& system, std::string_view letters) {
    Word word;
    for (const char letter : letters)
        word.push_back(letter == '0' ? zero_interval : system.alphabet().find(std::string(1, letter)).value());
    return word;
}

/// The valid ones of the grammars that come with the library, by name.
inline std::vector<std::pair<std::string, IntervalSystem>> bundled_systems() {
    std::vector<std::pair<std::string, IntervalSystem>> systems;
    for (const BundledGrammar& bundled : bundled_grammars(GrammarKind::Intervals)) {
        const ParsedGrammar parsed = parse_grammar(bundled.text, bundled.name);
        if (!parsed.grammar) throw std::invalid_argument("not a grammar: " + std::string(bundled.name));
        const Verdict verdict = validate(*parsed.grammar);
        if (verdict.system) systems.emplace_back(bundled.name, *verdict.system);
    }
    return systems;
}

/// Systems of many shapes: substitutions of S4 and classical ones; primitive, imprimitive, reducible and several
/// final classes; fields of degree 1 to 4.
inline const std::vector<std::pair<std::string, std::string>>& sample_systems() {
    static const std::vector<std::pair<std::string, std::string>> systems{
        {"fibonacci", "L->SL, S->L"},
        {"bisection", "A->AA"},
        {"sederberg", "A->AA, B->BB"},
        {"trisection", "A->AAA"},
        {"not constant", "A->AB, B->BBB"},
        {"tribonacci", "A->AB, B->AC, C->A"},
        {"silver mean", "A->AAB, B->A"},
        {"plastic", "A->B, B->C, C->AB"},
        {"slow growth 2", "A->BB, B->A"},
        {"slow growth 4", "A->DD, B->A, C->B, D->C"},
        {"period doubling", "A->AB, B->AA"},
        {"mirrored", "L->LS, S->L"},
        {"quartic", "A->AB, B->AC, C->AD, D->A"},
    };
    return systems;
}

/// All (base)^m words of letters 0 … base-1, the last of which may stand for `0`.
inline std::vector<Word> words_with_zeros(std::size_t symbols, std::size_t m) {
    std::vector<Word> words{Word{}};
    for (std::size_t i = 0; i < m; ++i) {
        std::vector<Word> longer;
        for (const Word& word : words) {
            for (std::size_t letter = 0; letter <= symbols; ++letter) {
                longer.push_back(word);
                longer.back().push_back(letter < symbols ? to_symbol(letter) : zero_interval);
            }
        }
        words = std::move(longer);
    }
    return words;
}

} // namespace internode::reference
