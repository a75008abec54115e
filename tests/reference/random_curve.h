// SPDX-License-Identifier: MIT
//
// Random valid systems and curves, the same ones on every machine.

#pragma once

#include "internode/curve/curve.h"
#include "internode/interval/validity.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace internode::reference {

class Random {
public:
    explicit Random(std::uint32_t seed)
        : engine_(seed) {}
    /// 0 … count - 1.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_()) % count; }
    /// In [-1, 1).
    double coordinate() { return static_cast<double>(engine_()) * 0x1p-31 - 1; }

private:
    std::mt19937 engine_;
};

/// A grammar with symbols A, B, … and the given images.
inline IntervalGrammar grammar_of(const Morphism& rules) {
    IntervalGrammar grammar;
    for (std::size_t i = 0; i < rules.size(); ++i)
        (void)grammar.alphabet.add(std::string(1, static_cast<char>('A' + i)));
    grammar.rules = rules;
    return grammar;
}

/// The valid system of rules written with letters 'A' + i: {"AB", "A"}.
inline IntervalSystem system_with(const std::vector<std::string>& images) {
    std::vector<Word> words;
    for (const std::string& image : images) {
        words.emplace_back();
        for (const char letter : image) words.back().push_back(to_symbol(static_cast<std::size_t>(letter - 'A')));
    }
    const Verdict verdict = validate(grammar_of(Morphism(words)));
    if (!verdict.system) throw std::invalid_argument("not a valid system");
    return *verdict.system;
}

/// L = A -> BA, S = B -> A.
inline IntervalSystem fibonacci() {
    return system_with({"BA", "A"});
}

/// The curve of data that fit.
inline Curve curve_of(const IntervalSystem& system, CurveData data) {
    CheckedCurve checked = make_curve(system, std::move(data));
    if (!checked.curve) throw std::logic_error("the curve does not fit: " + checked.problems.front());
    return *checked.curve;
}

/// A valid system of 1 to 3 symbols with rules of 1 to 3 letters.
inline IntervalSystem random_system(Random& random) {
    while (true) {
        const std::size_t symbols = 1 + random.below(3);
        std::vector<Word> images(symbols);
        for (Word& image : images) {
            image.resize(1 + random.below(3));
            for (Symbol& letter : image) letter = to_symbol(random.below(symbols));
        }
        const Verdict verdict = validate(grammar_of(Morphism(images)));
        if (verdict.system) return *verdict.system;
    }
}

enum class Shape { Open, Closed, Clamped, OpenWithZeros, ClosedWithZeros, ClampedWithZeros };
inline constexpr Shape all_shapes[] = {Shape::Open,          Shape::Closed,          Shape::Clamped,
                                       Shape::OpenWithZeros, Shape::ClosedWithZeros, Shape::ClampedWithZeros};

inline bool is_closed(Shape shape) {
    return shape == Shape::Closed || shape == Shape::ClosedWithZeros;
}

/// Letters with runs of 1 … d zeros between some of them.
inline Word random_word(Random& random, std::size_t symbols, std::size_t letters, std::size_t longest_run) {
    Word word;
    for (std::size_t i = 0; i < letters; ++i) {
        word.push_back(to_symbol(random.below(symbols)));
        if (longest_run > 0 && i + 1 < letters && random.below(3) == 0)
            word.insert(word.end(), 1 + random.below(longest_run), zero_interval);
    }
    return word;
}

/// A curve with a few intervals: `letters` of them with a length in its domain.
inline Curve random_curve(Random& random, const IntervalSystem& system, int degree, Shape shape, std::size_t letters,
                          std::size_t dimension) {
    const std::size_t symbols = system.alphabet().size();
    const auto d = static_cast<std::size_t>(degree);
    const bool with_zeros = shape != Shape::Open && shape != Shape::Closed && shape != Shape::Clamped;
    Word word = random_word(random, symbols, letters, with_zeros ? d : 0);
    CurveData data;
    data.degree = degree;
    data.dimension = dimension;
    if (is_closed(shape)) {
        data.ends = Ends::Circular;
        if (shape == Shape::ClosedWithZeros) word.insert(word.end(), random.below(d + 1), zero_interval);
    } else if (shape == Shape::Clamped || shape == Shape::ClampedWithZeros) {
        word = clamped(word, degree);
    } else {
        Word before = random_word(random, symbols, d, 0);
        Word after = random_word(random, symbols, d, 0);
        if (with_zeros) {
            before[random.below(d)] = zero_interval;
            after[random.below(d)] = zero_interval;
        }
        word.insert(word.begin(), before.begin(), before.end());
        word.insert(word.end(), after.begin(), after.end());
    }
    const std::size_t points = is_closed(shape) ? word.size() : word.size() - d;
    data.word = std::move(word);
    for (std::size_t i = 0; i < points * dimension; ++i) data.points.push_back(random.coordinate());
    return curve_of(system, std::move(data));
}

} // namespace internode::reference
