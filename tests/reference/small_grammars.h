// SPDX-License-Identifier: MIT
//
// All interval grammars of n symbols with rules of 1 … r letters, and a choice of one out of every family that differs
// only by the names of the symbols and by reading from right to left.

#pragma once

#include "internode/grammar/intervals/interval_grammar.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace internode::reference {

/// The words of 1 … length letters over n symbols.
inline std::vector<Word> short_words(std::size_t n, std::size_t length) {
    std::vector<Word> words;
    std::vector<Word> longest{Word{}};
    for (std::size_t m = 1; m <= length; ++m) {
        std::vector<Word> longer;
        for (const Word& word : longest) {
            for (std::size_t letter = 0; letter < n; ++letter) {
                longer.push_back(word);
                longer.back().push_back(to_symbol(letter));
            }
        }
        longest = std::move(longer);
        words.insert(words.end(), longest.begin(), longest.end());
    }
    return words;
}

/// Whether no renaming or mirror image of the rules comes before them.
inline bool is_smallest_variant(const std::vector<Word>& rules) {
    std::vector<std::size_t> names(rules.size());
    std::iota(names.begin(), names.end(), std::size_t{0});
    do {
        std::vector<Word> renamed(rules.size());
        for (std::size_t i = 0; i < rules.size(); ++i)
            for (const Symbol letter : rules[i]) renamed[names[i]].push_back(to_symbol(names[to_index(letter)]));
        std::vector<Word> mirrored = renamed;
        for (Word& word : mirrored) std::ranges::reverse(word);
        if (renamed < rules || mirrored < rules) return false;
    } while (std::ranges::next_permutation(names).found);
    return true;
}

/// One grammar of every family with at most `symbols` symbols and rules of at most `length` letters.
inline std::vector<IntervalGrammar> small_grammars(std::size_t symbols, std::size_t length) {
    std::vector<IntervalGrammar> grammars;
    for (std::size_t n = 1; n <= symbols; ++n) {
        const std::vector<Word> words = short_words(n, length);
        Alphabet alphabet;
        for (std::size_t i = 0; i < n; ++i) alphabet.add(std::string(1, static_cast<char>('A' + i)));
        std::vector<std::size_t> choice(n, 0);
        for (bool more = true; more;) {
            std::vector<Word> rules;
            for (const std::size_t i : choice) rules.push_back(words[i]);
            if (is_smallest_variant(rules)) grammars.push_back({"", alphabet, Morphism(rules), {}, {}});
            std::size_t digit = 0;
            while (digit < n && ++choice[digit] == words.size()) choice[digit++] = 0;
            more = digit < n;
        }
    }
    return grammars;
}

} // namespace internode::reference
