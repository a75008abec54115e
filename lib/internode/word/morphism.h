// SPDX-License-Identifier: MIT
//
// Morphisms σ of words: every letter A_i is replaced by a word of r_i >= 1 letters, all at once; `0` stays `0`.
//
// The incidence matrix M = [m_ij], n x n, counts the letters A_j in the rule of A_i (Nivoliers et al. 2012, eq. 4).
// Because no letter vanishes, counts never decrease, and a saturated count stays saturated.

#pragma once

#include "internode/word/symbol.h"

#include <cstdint>
#include <vector>

namespace internode {

class Morphism {
public:
    Morphism() = default;
    /// images[i] = the word of A_i. \throw std::invalid_argument if an image is empty, or has a letter that is
    /// not among the images.size() symbols (the reserved letter `0` included).
    explicit Morphism(std::vector<Word> images);

    /// n, the number of symbols.
    [[nodiscard]] std::size_t size() const { return images_.size(); }
    /// The word of a letter; `0` for `0`.
    [[nodiscard]] WordView image(Symbol symbol) const;
    /// σ(word).
    [[nodiscard]] Word operator()(WordView word) const;
    [[nodiscard]] const std::vector<Word>& images() const { return images_; }
    friend bool operator==(const Morphism&, const Morphism&) = default;

private:
    std::vector<Word> images_;
};

/// σ^power; power >= 1. The images grow like ρ^power: sizes are the caller's care. \throw std::invalid_argument
[[nodiscard]] Morphism power(const Morphism& morphism, int power);

/// σ^steps(word), steps >= 0, in few passes: each applies a power whose rules fit a cache. The size is the caller's
/// care. \throw std::invalid_argument
[[nodiscard]] Word rewritten(const Morphism& morphism, WordView word, int steps);

/// σ^steps(word), letter counts only: how often each symbol occurs, and how often `0`.
struct LetterCounts {
    std::vector<std::uint64_t> symbols; ///< n counts
    std::uint64_t zeros = 0;
    std::uint64_t total = 0; ///< all letters, zeros included
    bool saturated = false;  ///< the total went past the cap: counts are then lower bounds
};

/// The counts of word.
[[nodiscard]] LetterCounts letter_counts(const Morphism& morphism, WordView word);

/// The counts of σ^steps(word), without the word. Stops as soon as the total exceeds `cap` (then `saturated`).
/// Cost: the number of letters in all rules, times the steps taken.
[[nodiscard]] LetterCounts letter_counts(const Morphism& morphism, WordView word, std::uint64_t steps,
                                         std::uint64_t cap = std::uint64_t{1} << 62);

} // namespace internode
