// SPDX-License-Identifier: MIT

#include "internode/curve/derivatives.h"

#include "internode/algebra/powers_of_two.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

constexpr std::size_t no_letter = ~std::size_t{0};

} // namespace

int safe_exponent(const std::vector<double>& coordinates) {
    // Far from both: a pair of doubles is split exactly below 2^960 and has its lower half above 2^-900. Whoever has
    // both kinds of coordinates in one curve keeps the digits of the middle.
    double largest = 0;
    for (const double x : coordinates) largest = std::max(largest, std::abs(x));
    if (largest > 0x1p600) return 500;
    return largest < 0x1p-600 ? -500 : 0;
}

Derivatives::Derivatives(const Curve& curve)
    : curve_(curve)
    , spans_(curve.knots())
    , exponent_(safe_exponent(curve.points()))
    , letter_(no_letter)
    , value_(curve.dimension()) {}

void Derivatives::append(const KnotPlace& place, std::vector<double>& first, std::vector<double>& second) {
    if (place.letter != letter_) enter(place.letter);
    assert(!pieces_.empty());
    append(pieces_.front(), place.offset, first);
    if (pieces_.size() > 1)
        append(pieces_.back(), place.offset, second);
    else
        second.resize(second.size() + curve_.dimension());
    assert(first.size() == second.size());
}

void Derivatives::enter(std::size_t letter) {
    assert(curve_.word()[letter] != zero_interval);
    letter_ = letter;
    pieces_.clear();
    LongRows points = points_over(letter);
    for (int order = 1; order <= std::min(2, curve_.degree()); ++order) {
        points = differences(spans_, letter, points);
        pieces_.push_back(
            {points, LocalBasis(spans_, letter, curve_.degree() - order), exponent_ - order * spans_.exponent()});
    }
}

/// The control points d places before the letter up to its own, which reach over its interval.
LongRows Derivatives::points_over(std::size_t letter) const {
    const std::size_t dimension = curve_.dimension();
    const auto size = static_cast<std::ptrdiff_t>(curve_.size());
    LongRows rows{dimension, {}};
    for (int back = curve_.degree(); back >= 0; --back) {
        const std::ptrdiff_t point = static_cast<std::ptrdiff_t>(letter) - back;
        const auto row = static_cast<std::size_t>((point % size + size) % size);
        for (std::size_t c = 0; c < dimension; ++c)
            rows.coordinates.push_back({times_power_of_two(curve_.points()[row * dimension + c], -exponent_), 0});
    }
    return rows;
}

void Derivatives::append(Piece& piece, DoubleDouble offset, std::vector<double>& values) {
    combine(piece.basis.at(offset), piece.points, value_.data());
    for (const DoubleDouble& coordinate : value_) values.push_back(times_power_of_two(coordinate.hi, piece.exponent));
}

} // namespace internode
