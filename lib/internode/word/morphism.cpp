// SPDX-License-Identifier: MIT

#include "internode/word/morphism.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {
namespace {

/// An image as long is copied by a call.
constexpr std::size_t letters_by_call = 16;
/// The rules of a power that a word is rewritten by: 64 KiB of letters.
constexpr std::size_t letters_of_power = std::size_t{1} << 14;

/// First the one, then the other.
Morphism composed(const Morphism& first, const Morphism& then) {
    std::vector<Word> images;
    images.reserve(first.size());
    for (const Word& image : first.images()) images.push_back(then(image));
    return Morphism(std::move(images));
}

std::size_t letters_in(const Morphism& morphism) {
    std::size_t letters = 0;
    for (const Word& image : morphism.images()) letters += image.size();
    return letters;
}

} // namespace

Morphism::Morphism(std::vector<Word> images)
    : images_(std::move(images)) {
    for (const Word& image : images_) {
        if (image.empty()) throw std::invalid_argument("a rule with an empty successor");
        const auto foreign = [this](Symbol symbol) { return to_index(symbol) >= images_.size(); };
        if (std::ranges::any_of(image, foreign)) throw std::invalid_argument("a rule with a symbol that has no rule");
    }
}

WordView Morphism::image(Symbol symbol) const {
    static const Word zero{zero_interval};
    return symbol == zero_interval ? WordView(zero) : WordView(images_.at(to_index(symbol)));
}

Word Morphism::operator()(WordView word) const {
    std::size_t size = 0;
    for (const Symbol symbol : word) size += symbol == zero_interval ? 1 : images_.at(to_index(symbol)).size();
    Word result(size);
    auto place = result.begin();
    for (const Symbol symbol : word) {
        if (symbol == zero_interval) {
            *place++ = symbol;
            continue;
        }
        const Word& image = images_[to_index(symbol)];
        if (image.size() < letters_by_call)
            for (const Symbol letter : image) *place++ = letter;
        else
            place = std::ranges::copy(image, place).out;
    }
    assert(place == result.end());
    return result;
}

Morphism power(const Morphism& morphism, int power) {
    if (power < 1) throw std::invalid_argument("the power of a morphism must be at least 1");
    Morphism result = morphism;
    for (int step = 1; step < power; ++step) result = composed(result, morphism);
    return result;
}

Word rewritten(const Morphism& morphism, WordView word, int steps) {
    if (steps < 0) throw std::invalid_argument("a word cannot be rewritten fewer than 0 times");
    if (steps == 0) return {word.begin(), word.end()};
    // The rules of a power are worth making while they are shorter than the word that they serve.
    const std::size_t most_letters = std::min(letters_of_power, word.size());
    Morphism rules = morphism;
    int power = 1;
    while (power < steps) {
        Morphism longer = composed(rules, morphism);
        if (letters_in(longer) > most_letters) break;
        rules = std::move(longer);
        ++power;
    }
    // What the power leaves over comes first: the last pass, the longest, is then a whole one.
    const int first = steps % power;
    Word result = first == 0 ? rules(word) : internode::power(morphism, first)(word);
    for (int step = first == 0 ? power : first; step < steps; step += power) result = rules(result);
    return result;
}

LetterCounts letter_counts(const Morphism& morphism, WordView word) {
    LetterCounts counts;
    counts.symbols.resize(morphism.size());
    counts.total = word.size();
    for (const Symbol symbol : word) {
        if (symbol == zero_interval)
            ++counts.zeros;
        else
            ++counts.symbols.at(to_index(symbol));
    }
    return counts;
}

LetterCounts letter_counts(const Morphism& morphism, WordView word, std::uint64_t steps, std::uint64_t cap) {
    // A count is at most the total, the total at most cap, a rule has fewer than 2^32 letters and cap < 2^63:
    // what could overflow is caught before it is added.
    LetterCounts counts = letter_counts(morphism, word);
    counts.saturated = counts.total > cap;
    for (std::uint64_t step = 0; step < steps && !counts.saturated; ++step) {
        std::vector<std::uint64_t> next(morphism.size());
        std::uint64_t total = counts.zeros;
        for (std::size_t i = 0; i < morphism.size() && total <= cap; ++i) {
            if (counts.symbols[i] == 0) continue;
            const Word& image = morphism.images()[i];
            if (image.size() > (cap - total) / counts.symbols[i]) {
                total = cap + 1;
                break;
            }
            total += image.size() * counts.symbols[i];
            for (const Symbol symbol : image) next[to_index(symbol)] += counts.symbols[i];
        }
        assert(total >= counts.total);
        counts.saturated = total > cap;
        if (counts.saturated) break;
        if (next == counts.symbols) break; // a fixed point: every further step is the same
        counts.symbols = std::move(next);
        counts.total = total;
    }
    return counts;
}

} // namespace internode
