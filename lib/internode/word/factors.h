// SPDX-License-Identifier: MIT
//
// Factors (consecutive subwords) of iterated words, and the decomposition graph of Nivoliers et al. 2012, 2.2.2.
//
// Graph of length m: a vertex per word w of m letters, an arc w -> w' when w' is a factor of σ(w). A vertex is
// *persistent* when it lies on a cycle or can be reached from one: these words, and only they, occur after arbitrarily
// many steps. Without an axiom all n^m words count, but they are never enumerated. Let P2 be the eventual image of all
// n^2 pairs under "two-letter factors of σ", and K such that every |σ^K(a)| >= m-1. Then the persistent words are the
// length-m factors of σ^K(u), u in P2. This needs every letter to grow, as it does in a valid system.

#pragma once

#include "internode/text/limits.h"
#include "internode/word/morphism.h"

#include <cstdint>
#include <vector>

namespace internode {

/// All m-letter windows of a word by position, left to right: size - m + 1 when open (none if shorter), size when
/// circular (a word shorter than m wraps more than once). Repetitions are kept.
[[nodiscard]] std::vector<Word> windows(WordView word, std::size_t m, Ends ends);

/// The same, each word once, in order of first appearance.
[[nodiscard]] std::vector<Word> factors(WordView word, std::size_t m, Ends ends);

struct FactorGraph {
    std::vector<Word> words;                      ///< vertices, breadth first from the start words
    std::vector<std::vector<std::uint32_t>> arcs; ///< arcs[v] = vertices of the factors of σ(words[v]), by position
    std::vector<bool> persistent;                 ///< whether each vertex occurs after arbitrarily many steps
};

/// More words than the caller allows.
class TooManyWords : public LimitExceeded {
public:
    using LimitExceeded::LimitExceeded;
};

/// The graph closed under images from `start` (words of equal length m >= 1). \throw TooManyWords beyond `limit`
[[nodiscard]] FactorGraph factor_graph(const Morphism& morphism, const std::vector<Word>& start, std::size_t limit);

/// The persistent words of length m >= 1 over all axioms, sorted. \throw TooManyWords beyond `limit`, and
/// std::invalid_argument when some letter does not grow.
[[nodiscard]] std::vector<Word> persistent_words(const Morphism& morphism, std::size_t m, std::size_t limit);

/// All n^m words, sorted. \throw TooManyWords beyond `limit`
[[nodiscard]] std::vector<Word> all_words(std::size_t n, std::size_t m, std::size_t limit);

} // namespace internode
