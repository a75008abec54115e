// SPDX-License-Identifier: MIT

#include "internode/spline/mask.h"

#include "internode/spline/blossom.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <optional>
#include <stdexcept>

namespace internode {

namespace {

/// A word with its refinement, both on the parameter line of the refinement: ρ times a length is the sum of the
/// lengths that replace it, so no number is divided by ρ.
struct RefinedWord {
    Word word;                       ///< σ(w)
    std::vector<Number> knots;       ///< knots of σ(w)
    std::vector<std::size_t> letter; ///< place in w that each letter of σ(w) comes from
    std::vector<Number> coarse;      ///< knots of w, in units of the refinement
};

RefinedWord refine(const IntervalSystem& system, WordView word) {
    RefinedWord result{system.rules()(word), {}, {}, {}};
    result.knots = knots(system, result.word);
    result.coarse.push_back(result.knots.front());
    for (std::size_t p = 0; p < word.size(); ++p) {
        result.letter.insert(result.letter.end(), system.rules().image(word[p]).size(), p);
        result.coarse.push_back(result.knots[result.letter.size()]);
    }
    assert(result.letter.size() == result.word.size());
    return result;
}

/// The piece over letter p of a word. The weight of the word's own control point does not depend on knots outside its
/// support: these are put at its ends.
PolynomialPiece piece(const std::vector<Number>& coarse, std::size_t p) {
    assert(coarse.size() >= 3 && p + 1 < coarse.size());
    const std::size_t d = coarse.size() - 2;
    std::vector<Number> local;
    for (std::size_t i = p + 1; i <= p + 2 * d; ++i) // τ_{i-d}
        local.push_back(coarse[std::clamp(i, d, 2 * d + 1) - d]);
    return PolynomialPiece(std::move(local));
}

} // namespace

Mask mask(const IntervalSystem& system, WordView word) {
    if (word.size() < 2) throw std::invalid_argument("a decomposition has at least two letters");
    const RefinedWord refined = refine(system, word);
    if (refined.knots.back().sign() == 0) throw std::invalid_argument("a decomposition has a length");
    const std::size_t d = word.size() - 1;
    std::vector<std::optional<PolynomialPiece>> pieces(word.size());
    Mask result{{word.begin(), word.end()}, {}};
    for (std::size_t l = 0; l + d < refined.word.size(); ++l) {
        // Any piece that meets the new support will do; at most d letters in a row are empty.
        std::size_t m = l;
        while (refined.word[m] == zero_interval) ++m;
        assert(m <= l + d);
        const std::size_t p = refined.letter[m];
        if (!pieces[p]) pieces[p] = piece(refined.coarse, p);
        const std::span<const Number> arguments(refined.knots.data() + l + 1, d);
        const auto factor = refined.word.begin() + static_cast<std::ptrdiff_t>(l);
        result.entries.push_back(
            {Word(factor, factor + static_cast<std::ptrdiff_t>(d) + 1), pieces[p]->weights(arguments)[d - p]});
    }
    return result;
}

} // namespace internode
