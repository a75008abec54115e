// SPDX-License-Identifier: MIT
//
// Grammars written as a person would: make_grammar({{"L", "S L"}, {"S", "L"}}), names apart by blanks, in the order of
// the rules.

#pragma once

#include "internode/grammar/intervals/interval_grammar.h"

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace internode {

inline Word make_word(const IntervalGrammar& grammar, const std::string& text) {
    std::istringstream stream(text);
    Word word;
    for (std::string name; stream >> name;)
        word.push_back(name == "0" ? zero_interval : grammar.alphabet.find(name).value());
    return word;
}

inline IntervalGrammar make_grammar(const std::vector<std::pair<std::string, std::string>>& rules) {
    IntervalGrammar grammar;
    for (const auto& rule : rules) grammar.alphabet.add(rule.first);
    std::vector<Word> images;
    for (const auto& rule : rules) images.push_back(make_word(grammar, rule.second));
    grammar.rules = Morphism(std::move(images));
    return grammar;
}

inline IntervalGrammar with_axiom(IntervalGrammar grammar, const std::string& word, Ends ends = Ends::Open) {
    grammar.axiom = Axiom{make_word(grammar, word), ends};
    return grammar;
}

inline IntervalGrammar with_length(IntervalGrammar grammar, const std::string& name, const Rational& length) {
    grammar.lengths.push_back({grammar.alphabet.find(name).value(), length});
    return grammar;
}

/// A_1 -> A_n A_n, A_i -> A_(i-1) (Nivoliers et al. 2012, 3.4).
inline IntervalGrammar slow_growth(std::size_t n) {
    IntervalGrammar grammar;
    std::vector<Word> images;
    for (std::size_t i = 0; i < n; ++i) {
        grammar.alphabet.add(std::string("A").append(std::to_string(i + 1)));
        images.push_back(i == 0 ? Word{to_symbol(n - 1), to_symbol(n - 1)} : Word{to_symbol(i - 1)});
    }
    grammar.rules = Morphism(std::move(images));
    return grammar;
}

} // namespace internode
