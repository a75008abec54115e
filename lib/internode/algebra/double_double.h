// SPDX-License-Identifier: MIT
//
// Numbers of about 106 bits: the unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi)/2.
//
// For tables that are too large to be derived in the field: a weight that has been through some hundred operations here
// still rounds to the nearest double, but for ties. Sums and products by Knuth's and Dekker's error-free
// transformations (T. J. Dekker, Numer. Math. 18, 1971), without FMA, so that the bytes are the same everywhere.
// Relative error of an operation below 2^-100. Values beyond 2^±960 are the caller's care (Dekker's splitting).

#pragma once

#include "internode/algebra/number.h"

namespace internode {

struct DoubleDouble {
    double hi = 0;
    double lo = 0;
};

/// The nearest pair of doubles.
[[nodiscard]] inline DoubleDouble to_double_double(const Number& value) {
    const double hi = value.to_double();
    return {hi, (value - Number(Rational(hi))).to_double()};
}

[[nodiscard]] inline DoubleDouble two_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

[[nodiscard]] inline DoubleDouble two_product(double a, double b) {
    constexpr double splitter = 134217729; // 2^27 + 1: halves of 26 bits
    const double a_scaled = splitter * a;
    const double b_scaled = splitter * b;
    const double a_hi = a_scaled - (a_scaled - a);
    const double b_hi = b_scaled - (b_scaled - b);
    const double a_lo = a - a_hi;
    const double b_lo = b - b_hi;
    const double product = a * b;
    return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

[[nodiscard]] inline DoubleDouble operator-(DoubleDouble a) {
    return {-a.hi, -a.lo};
}

[[nodiscard]] inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble high = two_sum(a.hi, b.hi);
    const DoubleDouble low = two_sum(a.lo, b.lo);
    const DoubleDouble sum = two_sum(high.hi, high.lo + low.hi);
    return two_sum(sum.hi, sum.lo + low.lo);
}

[[nodiscard]] inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
    return a + -b;
}

[[nodiscard]] inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble product = two_product(a.hi, b.hi);
    return two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// b must not be 0.
[[nodiscard]] inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.hi / b.hi;
    const DoubleDouble rest = a - b * DoubleDouble{first, 0};
    const double second = rest.hi / b.hi;
    const DoubleDouble last = rest - b * DoubleDouble{second, 0};
    return two_sum(first, second) + DoubleDouble{last.hi / b.hi, 0};
}

} // namespace internode
