// SPDX-License-Identifier: MIT
//
// Slow and obvious: graphs by their reachability matrix, persistent words over all n^m words by set iteration, and all
// small systems to try them on.

#pragma once

#include "internode/word/graph.h"
#include "internode/word/morphism.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>
#include <vector>

namespace internode::reference {

/// A word from letters 'a', 'b', …; '0' is the zero interval.
inline Word word(std::string_view letters) {
    Word result;
    for (const char letter : letters)
        result.push_back(letter == '0' ? zero_interval : to_symbol(static_cast<std::size_t>(letter - 'a')));
    return result;
}

inline std::vector<Word> words(const std::vector<std::string_view>& texts) {
    std::vector<Word> result;
    for (const std::string_view text : texts) result.push_back(word(text));
    return result;
}

inline Morphism morphism(const std::vector<std::string_view>& images) {
    return Morphism(words(images));
}

/// reach[i][j]: a walk of one arc or more leads from i to j (Warshall).
inline std::vector<std::vector<bool>> walks(const Graph& graph) {
    const std::size_t n = graph.size();
    std::vector<std::vector<bool>> reach(n, std::vector<bool>(n, false));
    for (std::size_t i = 0; i < n; ++i)
        for (const std::uint32_t j : graph[i]) reach[i][j] = true;
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                if (reach[i][k] && reach[k][j]) reach[i][j] = true;
    return reach;
}

/// The words of m letters that are left of all n^m words after image upon image: a decreasing sequence of sets, whose
/// limit holds exactly the words with arbitrarily long pasts.
inline std::vector<Word> persistent_words(const Morphism& system, std::size_t m) {
    std::set<Word> current{Word{}};
    for (std::size_t i = 0; i < m; ++i) {
        std::set<Word> longer;
        for (const Word& start : current)
            for (std::size_t letter = 0; letter < system.size(); ++letter) {
                Word next = start;
                next.push_back(to_symbol(letter));
                longer.insert(next);
            }
        current = longer;
    }
    for (;;) {
        std::set<Word> next;
        for (const Word& start : current) {
            const Word image = system(start);
            for (std::size_t i = 0; i + m <= image.size(); ++i)
                next.emplace(image.begin() + static_cast<std::ptrdiff_t>(i),
                             image.begin() + static_cast<std::ptrdiff_t>(i + m));
        }
        if (next == current) return {current.begin(), current.end()};
        current = next;
    }
}

/// |σ^k(a)| > size for every letter a, k = n·size: whoever has not split so often by then never will again.
inline bool every_letter_grows(const Morphism& system, std::size_t size = 12) {
    for (std::size_t letter = 0; letter < system.size(); ++letter)
        if (!letter_counts(system, Word{to_symbol(letter)}, system.size() * size, size).saturated) return false;
    return true;
}

/// All systems of n letters with rules of 1 … longest letters.
inline std::vector<Morphism> all_systems(std::size_t n, std::size_t longest) {
    std::vector<Word> rules;
    std::vector<Word> front{Word{}};
    for (std::size_t size = 1; size <= longest; ++size) {
        std::vector<Word> longer;
        for (const Word& start : front)
            for (std::size_t letter = 0; letter < n; ++letter) {
                longer.push_back(start);
                longer.back().push_back(to_symbol(letter));
            }
        front = longer;
        rules.insert(rules.end(), front.begin(), front.end());
    }
    std::vector<std::vector<Word>> choices{{}};
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<std::vector<Word>> more;
        for (const auto& choice : choices)
            for (const Word& rule : rules) {
                more.push_back(choice);
                more.back().push_back(rule);
            }
        choices = more;
    }
    std::vector<Morphism> result;
    for (auto& choice : choices) result.emplace_back(std::move(choice));
    return result;
}

} // namespace internode::reference
