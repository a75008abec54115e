// SPDX-License-Identifier: MIT
//
// Of a given word the levels are tried in turn, until the points are reached. Of a pattern it is counted once how much
// each letter grows in so many levels; the domain then gets longer letter by letter.

#include "internode/curve/reverse/possible_size.h"

#include "internode/curve/knots.h"

#include <algorithm>
#include <stdexcept>

namespace internode {

namespace {

constexpr std::uint64_t countless = std::uint64_t{1} << 62;

/// Letters outside the domain at each end, and points that the ends add.
std::size_t margin_of(const CoarseWord& coarse) {
    return coarse.ends == PolygonEnds::Open ? static_cast<std::size_t>(coarse.degree) : 0;
}
std::uint64_t extra_points(const CoarseWord& coarse) {
    return coarse.ends == PolygonEnds::Closed ? 0 : static_cast<std::uint64_t>(coarse.degree);
}

/// The whole word whose domain has that many letters of the pattern.
Word word_with(const CoarseWord& coarse, std::size_t domain) {
    const Word word = repeated(coarse.letters, domain + 2 * margin_of(coarse));
    return coarse.ends == PolygonEnds::Clamped ? clamped(word, coarse.degree) : word;
}

void note(PossibleSizes& sizes, PossibleSize size, std::uint64_t points) {
    if (size.points <= points) sizes.below = size;
    if (size.points >= points && !sizes.above) sizes.above = std::move(size);
}

/// A given word, after some levels or any.
PossibleSizes sizes_of_word(const Morphism& rules, const CoarseWord& coarse, std::optional<int> levels,
                            std::uint64_t points) {
    PossibleSizes sizes;
    const std::size_t margin = margin_of(coarse);
    if (coarse.letters.size() <= 2 * margin) return sizes;
    const WordView domain = WordView(coarse.letters).subspan(margin, coarse.letters.size() - 2 * margin);
    const Word word = word_with(coarse, domain.size());
    constexpr int most_levels = 100'000; // a valid system grows long before
    for (int level = levels.value_or(0); level <= levels.value_or(most_levels); ++level) {
        const LetterCounts counts = letter_counts(rules, domain, static_cast<std::uint64_t>(level), countless);
        const std::uint64_t size = counts.total + extra_points(coarse);
        if (sizes.below && sizes.below->points == size) continue; // nothing split
        note(sizes, {size, level, word}, points);
        if (size >= points) break;
    }
    return sizes;
}

/// A pattern, repeated until it gives the points.
PossibleSizes sizes_of_pattern(const Morphism& rules, const CoarseWord& coarse, int levels, std::uint64_t points) {
    std::vector<std::uint64_t> grown(rules.size());
    for (std::size_t i = 0; i < grown.size(); ++i)
        grown[i] = letter_counts(rules, Word{to_symbol(i)}, static_cast<std::uint64_t>(levels), countless).total;
    const std::size_t period = coarse.letters.size();
    const auto letter = [&](std::size_t place) { return coarse.letters[(margin_of(coarse) + place) % period]; };
    const bool open = coarse.ends != PolygonEnds::Closed;
    PossibleSizes sizes;
    if (open && letter(0) == zero_interval) return sizes; // a domain begins with a length
    std::uint64_t count = extra_points(coarse);
    std::size_t below = 0;
    std::uint64_t points_below = 0;
    bool has_length = false;
    for (std::size_t domain = 1; domain <= points + period && !sizes.above; ++domain) {
        const Symbol last = letter(domain - 1);
        has_length = has_length || last != zero_interval;
        count += last == zero_interval ? 1 : std::min(grown[to_index(last)], countless - count);
        if (!has_length || (open && last == zero_interval)) continue;
        if (count <= points) {
            below = domain;
            points_below = count;
        }
        if (count >= points) sizes.above = PossibleSize{count, levels, word_with(coarse, domain)};
    }
    if (below > 0) sizes.below = PossibleSize{points_below, levels, word_with(coarse, below)};
    return sizes;
}

} // namespace

PossibleSizes possible_sizes(const Morphism& rules, const CoarseWord& coarse, std::optional<int> levels,
                             std::uint64_t points) {
    if (coarse.letters.empty()) throw std::invalid_argument("an empty coarse word");
    if (levels && *levels < 0) throw std::invalid_argument("a negative number of levels");
    if (!coarse.repeat) return sizes_of_word(rules, coarse, levels, points);
    if (!levels) throw std::invalid_argument("a pattern and no number of levels");
    return sizes_of_pattern(rules, coarse, *levels, points);
}

} // namespace internode
