// SPDX-License-Identifier: MIT
//
// What the targets share that go from the bytes of a file to the refined result. They share which inputs are small
// enough that the mathematics takes no time to speak of, and the last byte as a choice of grammar and options.

#pragma once

#include "internode/grammar/intervals/parse.h"
#include "internode/input/settled_curve.h"
#include "internode/interval/validity.h"
#include "tests/fuzz/require.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace internode::fuzz {

/// The text without its last byte, and what that byte says: files that end with a line feed are seeds as they are.
struct Chosen {
    std::string_view text;
    unsigned choice = 0;
};

inline Chosen chosen(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return {};
    return {{reinterpret_cast<const char*>(data), size - 1}, data[size - 1]};
}

/// Valid systems: any knots, a field of degree 2, several symbols with lengths of their own.
inline const IntervalSystem& system_of(unsigned choice) {
    static const std::vector<IntervalSystem> systems = [] {
        std::vector<IntervalSystem> result;
        for (const char* const rules : {"A->AA", "L->SL, S->L", "A->AAA, B->BBB, length B = 2"})
            result.push_back(*validate(*parse_grammar(rules, "<fuzz>").grammar).system);
        return result;
    }();
    return systems[choice % systems.size()];
}

inline bool is_short(const InputNumber& number) {
    for (const Rational& coefficient : number)
        if (to_string(coefficient).size() > 24) return false;
    return number.size() <= 4;
}

inline bool is_small(const InputPolygon& side) {
    constexpr std::size_t most = 60;
    for (const InputLength& length : side.lengths)
        if (!is_short(length.coefficients)) return false;
    if (side.origin && !is_short(*side.origin)) return false;
    for (const InputNumber& knot : side.knots.value_or(std::vector<InputNumber>{}))
        if (!is_short(knot)) return false;
    const bool small_word = !side.word_letters || side.word_letters->size() <= 2 * most;
    const bool small_text = !side.word_text || side.word_text->text.size() <= 2 * most;
    return side.lengths.size() <= most && small_word && small_text && side.degree.value_or(1) <= 4 &&
           (!side.knots || side.knots->size() <= 2 * most) && side.points.size() <= 3 * most;
}

/// Degree 1 … 4, repeated or not, ends unsaid, closed or clamped.
inline CurveOptions options_of(unsigned choice) {
    CurveOptions options;
    if ((choice & 16U) != 0) options.degree = 1 + static_cast<int>(choice % 4);
    options.repeat = (choice & 8U) != 0;
    options.ends = (choice & 32U) != 0   ? EndsChoice::Closed
                   : (choice & 64U) != 0 ? EndsChoice::Clamped
                                         : EndsChoice::Unsaid;
    options.rational = (choice & 128U) != 0;
    if (options.repeat) options.word = system_of(choice).alphabet().name(to_symbol(0));
    return options;
}

} // namespace internode::fuzz
