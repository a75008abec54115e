// SPDX-License-Identifier: MIT
//
// Which symbol may begin at a letter is found from the right end, so that no choice is taken back.

#include "internode/input/coarse_word.h"

#include "internode/curve/refinement.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

constexpr Symbol zero_image[] = {zero_interval};

WordView image_of(const Morphism& rules, Symbol symbol) {
    return symbol == zero_interval ? WordView(zero_image) : rules.image(symbol);
}

/// `0`, and the symbols in their order.
Word candidates(const Morphism& rules) {
    Word symbols{zero_interval};
    for (std::size_t i = 0; i < rules.size(); ++i) symbols.push_back(to_symbol(i));
    return symbols;
}

/// The word w with σ(w) = fine.
std::optional<Word> preimage(const Morphism& rules, WordView fine) {
    const Word symbols = candidates(rules);
    std::vector<std::optional<Symbol>> begins(fine.size() + 1);
    const auto ends_well = [&](std::size_t place) { return place == fine.size() || begins[place].has_value(); };
    for (std::size_t place = fine.size(); place-- > 0;) {
        for (const Symbol symbol : symbols) {
            const WordView image = image_of(rules, symbol);
            if (image.size() > fine.size() - place || !ends_well(place + image.size())) continue;
            if (!std::ranges::equal(image, fine.subspan(place, image.size()))) continue;
            begins[place] = symbol;
            break;
        }
    }
    Word word;
    for (std::size_t place = 0; place < fine.size(); place += image_of(rules, word.back()).size()) {
        if (!begins[place]) return std::nullopt;
        word.push_back(*begins[place]);
    }
    return word;
}

/// `count` letters w whose σ(w) begins with `fine`, as refinement leaves them right of a domain.
std::optional<Word> cut_prefix(const Morphism& rules, WordView fine, std::size_t count) {
    assert(!fine.empty() && count > 0);
    const Word symbols = candidates(rules);
    Word word;
    for (std::size_t place = 0; place < fine.size();) {
        const auto fits = [&](Symbol symbol) {
            const WordView image = image_of(rules, symbol);
            const std::size_t shown = std::min(image.size(), fine.size() - place);
            return std::ranges::equal(image.first(shown), fine.subspan(place, shown));
        };
        const auto found = std::ranges::find_if(symbols, fits);
        if (found == symbols.end() || word.size() == count) return std::nullopt;
        word.push_back(*found);
        place += image_of(rules, *found).size();
    }
    word.resize(count, word.back());
    return word;
}

/// Every image read backwards.
Morphism mirrored(const Morphism& rules) {
    std::vector<Word> images;
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const WordView image = rules.image(to_symbol(i));
        images.emplace_back(image.rbegin(), image.rend());
    }
    return Morphism(std::move(images));
}

std::optional<Word> open_word(const Morphism& rules, WordView fine, std::size_t d) {
    const std::optional<Word> domain = preimage(rules, fine.subspan(d, fine.size() - 2 * d));
    Word before(fine.begin(), fine.begin() + static_cast<std::ptrdiff_t>(d));
    std::ranges::reverse(before);
    std::optional<Word> left = cut_prefix(mirrored(rules), before, d);
    const std::optional<Word> right = cut_prefix(rules, fine.last(d), d);
    if (!domain || !left || !right) return std::nullopt;
    std::ranges::reverse(*left);
    left->insert(left->end(), domain->begin(), domain->end());
    left->insert(left->end(), right->begin(), right->end());
    return left;
}

} // namespace

std::optional<Word> coarser_word(const Morphism& rules, WordView fine, int degree, Ends ends) {
    assert(degree >= 1);
    const auto d = static_cast<std::size_t>(degree);
    if (ends == Ends::Circular) return preimage(rules, fine);
    assert(fine.size() > 2 * d);
    std::optional<Word> word = open_word(rules, fine, d);
    if (word && !std::ranges::equal(refined_word(rules, *word, degree, ends), fine)) return std::nullopt;
    return word;
}

} // namespace internode
