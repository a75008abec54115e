// SPDX-License-Identifier: MIT

#include "internode/curve/spans.h"

#include "internode/algebra/powers_of_two.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

int longest_exponent(const std::vector<DoubleDouble>& lengths) {
    double longest = 0;
    for (const DoubleDouble& length : lengths) longest = std::max(longest, length.hi);
    assert(longest > 0);
    return exponent_of(longest);
}

} // namespace

std::vector<DoubleDouble> long_lengths(const Knots& knots, int exponent) {
    std::vector<DoubleDouble> lengths(knots.system().alphabet().size());
    const Number scale = pow(knots.system().ratio(), -knots.step());
    std::vector<bool> known(lengths.size());
    for (const Symbol symbol : knots.word()) {
        if (symbol == zero_interval || known[to_index(symbol)]) continue;
        known[to_index(symbol)] = true;
        const DoubleDouble length = to_double_double(knots.system().length(symbol) * scale);
        lengths[to_index(symbol)] = {times_power_of_two(length.hi, -exponent),
                                     times_power_of_two(length.lo, -exponent)};
    }
    return lengths;
}

Spans::Spans(const Knots& knots)
    : word_(knots.word())
    , degree_(knots.degree())
    , exponent_(longest_exponent(long_lengths(knots, 0)))
    , lengths_(long_lengths(knots, exponent_)) {}

DoubleDouble Spans::operator[](std::ptrdiff_t letter) const {
    const auto size = static_cast<std::ptrdiff_t>(word_.size());
    const Symbol symbol = word_[static_cast<std::size_t>((letter % size + size) % size)];
    return symbol == zero_interval ? DoubleDouble{} : lengths_[to_index(symbol)];
}

DoubleDouble Spans::between(std::ptrdiff_t first, int count) const {
    assert(count >= 0);
    DoubleDouble sum;
    for (std::ptrdiff_t letter = first; letter < first + count; ++letter) sum = sum + (*this)[letter];
    return sum;
}

} // namespace internode
