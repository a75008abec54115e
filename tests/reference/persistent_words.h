// SPDX-License-Identifier: MIT
//
// Slow and obvious: graphs by their reachability matrix, persistent words over all n^m words by set iteration.

#pragma once

#include "internode/word/graph.h"
#include "internode/word/morphism.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace internode::reference {

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

} // namespace internode::reference
