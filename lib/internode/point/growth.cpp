// SPDX-License-Identifier: MIT
//
// The images of the letters under a table are a sparse matrix; a step multiplies the counts of the letters by it. It is
// possible where letters alone decide what a module becomes; each visit of a letter is counted against a bound.

#include "internode/point/growth.h"

#include "internode/point/rule_programs.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace internode {

namespace {

/// Visits of letters that a prediction may cost: less than a second.
constexpr std::uint64_t max_visits = 20'000'000;

/// The letters that one module becomes, with how often.
using Image = std::vector<std::pair<std::uint32_t, std::uint64_t>>;

Image image_of(const PointRule& rule) {
    std::vector<std::uint32_t> letters;
    for (const ModuleTemplate& one : rule.successor) letters.push_back(static_cast<std::uint32_t>(one.letter));
    std::ranges::sort(letters);
    Image image;
    for (const std::uint32_t letter : letters) {
        if (image.empty() || image.back().first != letter) image.emplace_back(letter, 0);
        ++image.back().second;
    }
    return image;
}

/// The images of the letters under each table, made when they are asked for.
class GrowthMatrix {
public:
    explicit GrowthMatrix(const PointSystem& system)
        : system_(system)
        , images_(system.programs().sets.front().by_letter.size()) {
        const auto known = [](const auto& parameters) { return parameters.has_value(); };
        fits_everywhere_ = system.grammar().ring && std::ranges::count_if(system.layout(), known) == 1;
    }

    /// None for a letter whose growth depends on more than itself.
    const std::vector<std::optional<Image>>& images(std::size_t table) {
        std::vector<std::optional<Image>>& images = images_[table];
        if (images.empty())
            for (std::uint32_t i = 0; i < system_.grammar().letters.size(); ++i) images.push_back(image(table, i));
        return images;
    }

    /// Whether modules are rewritten together, so that letters do not grow one by one.
    [[nodiscard]] bool joins_modules(std::size_t table) const {
        const std::vector<bool>& begins = system_.programs().sets.front().begins_several[table];
        return std::ranges::find(begins, true) != begins.end();
    }

private:
    [[nodiscard]] std::optional<Image> image(std::size_t table, std::uint32_t letter) const {
        const Image itself{{letter, 1}};
        std::optional<Image> common;
        bool always = false;
        for (const std::uint32_t index : system_.programs().sets.front().by_letter[table][letter]) {
            const PointRule& rule = system_.grammar().rules[index];
            Image one = image_of(rule);
            if (common && *common != one) return std::nullopt;
            common = std::move(one);
            always = always || always_applies(rule);
            // Only other rules with weights are drawn beside a rule that always applies.
            if (always && !rule.weight) break;
        }
        if (always) return common;
        return !common || *common == itself ? std::optional(itself) : std::nullopt;
    }

    /// In a ring of one letter every context without a condition fits.
    [[nodiscard]] bool always_applies(const PointRule& rule) const {
        return !rule.condition && (fits_everywhere_ || (rule.left.empty() && rule.right.empty()));
    }

    const PointSystem& system_;
    bool fits_everywhere_ = false;
    std::vector<std::vector<std::optional<Image>>> images_;
};

/// Counts of letters, none above the cap.
class LetterCounting {
public:
    LetterCounting(const PointSystem& system, const ModuleWord& word, std::uint64_t cap)
        : matrix_(system)
        , cap_(cap)
        , counts_(system.grammar().letters.size(), 0) {
        for (const Symbol letter : word.letters()) add(counts_[to_index(letter)], 1);
    }

    /// False when the growth is not context-free, or the visits are used up.
    bool step(std::size_t table) {
        if (matrix_.joins_modules(table)) return false;
        const std::vector<std::optional<Image>>& images = matrix_.images(table);
        assert(images.size() == counts_.size());
        std::vector<std::uint64_t> next(counts_.size(), 0);
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            if (counts_[i] == 0) continue;
            if (!images[i]) return false;
            for (const auto& [letter, count] : *images[i]) add(next[letter], product(counts_[i], count));
            visits_ += images[i]->size();
        }
        counts_ = std::move(next);
        visits_ += counts_.size();
        return visits_ <= max_visits;
    }

    [[nodiscard]] const std::vector<std::uint64_t>& counts() const { return counts_; }
    [[nodiscard]] std::uint64_t total() const {
        std::uint64_t sum = 0;
        for (const std::uint64_t count : counts_) add(sum, count);
        return sum;
    }

private:
    void add(std::uint64_t& sum, std::uint64_t more) const { sum = more > cap_ - sum ? cap_ : sum + more; }
    [[nodiscard]] std::uint64_t product(std::uint64_t a, std::uint64_t b) const {
        assert(b > 0 && "an image counts the letters it has");
        return a > cap_ / b ? cap_ : a * b;
    }

    GrowthMatrix matrix_;
    std::uint64_t cap_;
    std::uint64_t visits_ = 0;
    std::vector<std::uint64_t> counts_;
};

} // namespace

std::optional<std::uint64_t> predicted_length(const PointSystem& system, const ModuleWord& word, std::uint64_t cycles,
                                              std::uint64_t limit) {
    LetterCounting counting(system, word, std::max(limit, limit + 1)); // the largest limit has no successor
    for (std::uint64_t cycle = 0; cycle < cycles; ++cycle) {
        const std::vector<std::uint64_t> before = counting.counts();
        for (const std::optional<std::uint32_t>& table : system.cycle())
            if (!counting.step(table.value_or(0))) return std::nullopt;
        // What a cycle leaves as it is, all others leave too.
        if (counting.counts() == before) break;
    }
    return counting.total();
}

} // namespace internode
