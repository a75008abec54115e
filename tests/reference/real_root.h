// SPDX-License-Identifier: MIT
//
// Slow and obvious: real roots by bisection, values at them by interval arithmetic, in rationals.

#pragma once

#include "internode/algebra/polynomial.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace internode::reference {

using Interval = std::pair<Rational, Rational>;

inline Rational evaluate(const Polynomial& polynomial, const Rational& x) {
    Rational value;
    for (std::size_t i = polynomial.size(); i-- > 0;) value = value * x + polynomial[i];
    return value;
}

/// The root between two points where the polynomial has opposite signs, halved `steps` times.
inline Interval bisect(const Polynomial& polynomial, Interval interval, int steps) {
    const int left = sgn(evaluate(polynomial, interval.first));
    for (int step = 0; step < steps; ++step) {
        const Rational middle = (interval.first + interval.second) / 2;
        (sgn(evaluate(polynomial, middle)) == left ? interval.first : interval.second) = middle;
    }
    return interval;
}

/// An interval around Σ coefficients[i] x^i for x in a positive interval.
inline Interval enclose(const std::vector<Rational>& coefficients, const Interval& x) {
    Interval sum;
    Interval power{1, 1};
    for (const Rational& coefficient : coefficients) {
        sum.first += coefficient * (coefficient < 0 ? power.second : power.first);
        sum.second += coefficient * (coefficient < 0 ? power.first : power.second);
        power.first *= x.first;
        power.second *= x.second;
    }
    return sum;
}

} // namespace internode::reference
