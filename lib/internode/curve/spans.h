// SPDX-License-Identifier: MIT
//
// The knot differences of one direction in pairs of doubles (algebra/double_double.h).
//
// t_{k+m} - t_k is a sum of lengths, each rounded once from its exact value, so that knots which differ in their last
// digit keep their distance. Lengths are scaled by a power of two, which changes no digit, so that quotients by them
// stay far from the ends of the range.

#pragma once

#include "internode/algebra/double_double.h"
#include "internode/curve/knots.h"

#include <cstddef>
#include <vector>

namespace internode {

class Spans {
public:
    explicit Spans(const Knots& knots);

    [[nodiscard]] int degree() const { return degree_; }
    /// Lengths are in units of 2^exponent(): the longest one of the word lies between 1 and 2.
    [[nodiscard]] int exponent() const { return exponent_; }
    /// The length of a letter of the word; of closed knots modulo their number.
    [[nodiscard]] DoubleDouble operator[](std::ptrdiff_t letter) const;
    /// t_{first+count} - t_first.
    [[nodiscard]] DoubleDouble between(std::ptrdiff_t first, int count) const;

private:
    Word word_;
    int degree_;
    int exponent_ = 0;
    std::vector<DoubleDouble> lengths_; ///< lengths by symbol, in units of 2^exponent_
};

/// The lengths of the symbols that occur in the word of these knots, times 2^-exponent; 0 for all others.
[[nodiscard]] std::vector<DoubleDouble> long_lengths(const Knots& knots, int exponent);

} // namespace internode
