// SPDX-License-Identifier: MIT

#include "internode/grammar/intervals/print.h"

#include "internode/grammar/lexing/name.h"

#include <cassert>

namespace internode {

std::string print(const IntervalGrammar& grammar) {
    assert(grammar.alphabet.size() == grammar.rules.size());
    std::string text = "intervals";
    if (!grammar.name.empty()) text += ' ' + write_grammar_name(grammar.name);
    text += '\n';
    for (std::size_t i = 0; i < grammar.rules.size(); ++i)
        text += grammar.alphabet.names()[i] + " -> " + to_string(grammar.rules.images()[i], grammar.alphabet) + '\n';
    if (grammar.axiom) {
        const std::string word = to_string(grammar.axiom->word, grammar.alphabet);
        text += grammar.axiom->ends == Ends::Circular ? "axiom (" + word + ")\n" : "axiom " + word + '\n';
    }
    for (const LengthDeclaration& declared : grammar.lengths)
        text += "length " + grammar.alphabet.name(declared.symbol) + " = " + to_string(declared.length) + '\n';
    return text;
}

} // namespace internode
