// SPDX-License-Identifier: MIT

#include "internode/curve/knots.h"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <stdexcept>

namespace internode {

namespace {

/// Whether degree and word go together.
std::vector<std::string> size_problems(const KnotsData& data) {
    if (data.degree < 1 || data.degree > max_degree)
        return {fmt::format("the degree must be between 1 and {}, not {}", max_degree, data.degree)};
    const bool open = data.ends == Ends::Open;
    const std::size_t least = open ? 2 * static_cast<std::size_t>(data.degree) + 1 : 1;
    if (data.word.size() >= least) return {};
    return {fmt::format("{} curve of degree {} needs a word of at least {} letter{}, not {}",
                        open ? "an open" : "a closed", data.degree, least, least == 1 ? "" : "s", data.word.size())};
}

/// The symbols of a word and of everything it can become, each once; those of the word first.
Word reachable_symbols(const Morphism& rules, WordView word) {
    Word symbols;
    std::vector<bool> seen(rules.size());
    const auto visit = [&](Symbol symbol) {
        if (symbol == zero_interval || seen[to_index(symbol)]) return;
        seen[to_index(symbol)] = true;
        symbols.push_back(symbol);
    };
    for (const Symbol symbol : word) visit(symbol);
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        const Symbol symbol = symbols[i];
        for (const Symbol child : rules.image(symbol)) visit(child);
    }
    return symbols;
}

/// Whether each letter has a length, and one that doubles can carry. Each symbol is named once.
std::vector<std::string> letter_problems(const IntervalSystem& system, const KnotsData& data) {
    for (std::size_t i = 0; i < data.word.size(); ++i)
        if (data.word[i] != zero_interval && to_index(data.word[i]) >= system.alphabet().size())
            return {fmt::format("letter {} of the word is not in the grammar's alphabet", i + 1)};
    std::vector<std::string> problems;
    for (const Symbol symbol : reachable_symbols(system.rules(), data.word)) {
        const std::string& name = system.alphabet().name(symbol);
        if (!system.occurs(symbol)) {
            problems.push_back(fmt::format("`{}` has no length: the grammar's axiom never produces it", name));
            continue;
        }
        const double length = system.length(symbol).to_double();
        if (!(length >= smallest_length && length <= largest_length))
            problems.push_back(fmt::format("the length of `{}` is {}: a curve needs lengths between {} and {}", name,
                                           length, smallest_length, largest_length));
    }
    return problems;
}

/// Whether doubles can carry the parameter.
std::vector<std::string> origin_problems(const KnotsData& data) {
    const double origin = data.origin.to_double();
    if (origin >= -largest_origin && origin <= largest_origin) return {};
    return {fmt::format("the parameter begins at {}: it must lie between {} and {}", origin, -largest_origin,
                        largest_origin)};
}

struct ZeroRun {
    std::size_t first = 0; ///< 0-based
    std::size_t length = 0;
};

/// The longest run of `0`; across the seam when circular, where the word is not all zeros.
ZeroRun longest_zero_run(WordView word, Ends ends) {
    const std::size_t size = word.size();
    std::size_t start = 0;
    if (ends == Ends::Circular)
        while (word[start] == zero_interval) ++start;
    ZeroRun longest;
    ZeroRun run;
    for (std::size_t k = 0; k < size; ++k) {
        const std::size_t i = (start + k) % size;
        if (word[i] != zero_interval) {
            run.length = 0;
            continue;
        }
        if (run.length++ == 0) run.first = i;
        if (run.length > longest.length) longest = run;
    }
    return longest;
}

/// Whether the domain has a length, begins and ends with it, and no basis function is empty.
std::vector<std::string> zero_problems(const KnotsData& data) {
    const auto degree = static_cast<std::size_t>(data.degree);
    const auto is_zero = [](Symbol symbol) { return symbol == zero_interval; };
    if (std::ranges::all_of(data.word, is_zero)) return {"the word has no interval with a length: every letter is `0`"};
    std::vector<std::string> problems;
    if (data.ends == Ends::Open) {
        const std::size_t last = data.word.size() - degree - 1;
        if (is_zero(data.word[degree]))
            problems.push_back(fmt::format("the domain must begin with an interval that has a length, but letter {} of "
                                           "the word, its first, is `0`",
                                           degree + 1));
        if (last != degree && is_zero(data.word[last]))
            problems.push_back(fmt::format("the domain must end with an interval that has a length, but letter {} of "
                                           "the word, its last, is `0`",
                                           last + 1));
    }
    const ZeroRun run = longest_zero_run(data.word, data.ends);
    if (run.length > degree)
        problems.push_back(fmt::format("{} zeros in a row from letter {} of the word: at most {} fit a curve of degree "
                                       "{}, and {} already break it",
                                       run.length, run.first + 1, degree, degree, degree));
    return problems;
}

} // namespace

Knots::Knots(IntervalSystem system, KnotsData data)
    : system_(std::move(system))
    , degree_(data.degree)
    , ends_(data.ends)
    , word_(std::move(data.word))
    , origin_(std::move(data.origin)) {
    assert(size() >= 1 && !domain().empty());
}

std::size_t Knots::size() const {
    return ends_ == Ends::Open ? word_.size() - static_cast<std::size_t>(degree_) : word_.size();
}

WordView Knots::domain() const {
    const WordView word(word_);
    if (ends_ == Ends::Circular) return word;
    const auto degree = static_cast<std::size_t>(degree_);
    return word.subspan(degree, word.size() - 2 * degree);
}

CheckedKnots make_knots(const IntervalSystem& system, KnotsData data) {
    CheckedKnots checked;
    checked.problems = size_problems(data);
    if (!checked.problems.empty()) return checked;
    for (const auto& problems : {letter_problems(system, data), zero_problems(data), origin_problems(data)})
        checked.problems.insert(checked.problems.end(), problems.begin(), problems.end());
    if (checked.problems.empty()) checked.knots = Knots(system, std::move(data));
    return checked;
}

Word clamped(WordView domain, int degree) {
    if (degree < 0) throw std::invalid_argument("a negative degree");
    const auto zeros = static_cast<std::size_t>(degree);
    Word word(zeros, zero_interval);
    word.insert(word.end(), domain.begin(), domain.end());
    word.insert(word.end(), zeros, zero_interval);
    return word;
}

Word repeated(WordView word, std::size_t count) {
    if (word.empty()) throw std::invalid_argument("an empty word cannot be repeated");
    Word result(count);
    for (std::size_t i = 0; i < count; ++i) result[i] = word[i % word.size()];
    return result;
}

} // namespace internode
