// SPDX-License-Identifier: MIT

#include "internode/interval/decomposition_graph.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

/// The rules of the symbols that occur, renumbered: the others have no length and no place in any word.
struct Occurring {
    std::vector<Symbol> symbols; ///< old, by new
    Morphism rules;
};

Occurring restricted(const IntervalSystem& system) {
    Occurring result;
    std::vector<Symbol> renumbered(system.alphabet().size());
    for (std::size_t i = 0; i < renumbered.size(); ++i) {
        if (!system.occurs(to_symbol(i))) continue;
        renumbered[i] = to_symbol(result.symbols.size());
        result.symbols.push_back(to_symbol(i));
    }
    std::vector<Word> images;
    for (const Symbol symbol : result.symbols) {
        Word& image = images.emplace_back();
        for (const Symbol letter : system.rules().image(symbol)) {
            assert(system.occurs(letter));
            image.push_back(renumbered[to_index(letter)]);
        }
    }
    result.rules = Morphism(std::move(images));
    return result;
}

std::vector<Word> named_back(std::vector<Word> words, const std::vector<Symbol>& symbols) {
    for (Word& word : words)
        for (Symbol& letter : word) letter = symbols[to_index(letter)];
    return words;
}

std::vector<Word> axiom_windows(const IntervalSystem& system, std::size_t m) {
    const auto& axiom = system.grammar().axiom;
    if (!axiom) throw std::invalid_argument("words are reachable from an axiom only, and this grammar has none");
    std::vector<Word> words = factors(axiom->word, m, axiom->ends);
    std::erase_if(words, [](const Word& word) {
        return std::ranges::all_of(word, [](Symbol letter) { return letter == zero_interval; });
    });
    return words;
}

} // namespace

FactorGraph word_graph(const IntervalSystem& system, std::size_t m, WordChoice choice, std::size_t limit) {
    if (m == 0) throw std::invalid_argument("a word of a decomposition graph has at least one letter");
    if (choice == WordChoice::Default) choice = system.grammar().axiom ? WordChoice::Reachable : WordChoice::Persistent;
    if (choice == WordChoice::Reachable) return factor_graph(system.rules(), axiom_windows(system, m), limit);
    const Occurring occurring = restricted(system);
    std::vector<Word> words = choice == WordChoice::All ? all_words(occurring.symbols.size(), m, limit)
                                                        : persistent_words(occurring.rules, m, limit);
    return factor_graph(system.rules(), named_back(std::move(words), occurring.symbols), limit);
}

} // namespace internode
