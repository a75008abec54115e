// SPDX-License-Identifier: MIT
//
// Numbers of about 106 bits: the unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi)/2. Or several numbers side by
// side, when Real is a vector of doubles: each lane has the bytes that it would have alone.
//
// For tables that are too large to be derived in the field: a weight that has been through some hundred operations here
// still rounds to the nearest double, but for ties. Sums and products by Knuth's and Dekker's error-free
// transformations (T. J. Dekker, Numer. Math. 18, 1971), without FMA, so that the bytes are the same everywhere.
// Relative error of an operation below 2^-100. Values beyond 2^±960 are the caller's care (Dekker's splitting).

#pragma once

#include "internode/algebra/number.h"

namespace internode {

template<typename Real>
struct PairOf {
    Real hi{};
    Real lo{};
};
using DoubleDouble = PairOf<double>;

/// The nearest pair of doubles.
[[nodiscard]] inline DoubleDouble to_double_double(const Number& value) {
    const double hi = value.to_double();
    return {hi, (value - Number(Rational(hi))).to_double()};
}

template<typename Real>
[[nodiscard]] PairOf<Real> two_sum(Real a, Real b) {
    const Real sum = a + b;
    const Real b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// The same where |a| >= |b|, or a is 0 (Dekker).
template<typename Real>
[[nodiscard]] PairOf<Real> quick_two_sum(Real a, Real b) {
    const Real sum = a + b;
    return {sum, b - (sum - a)};
}

template<typename Real>
[[nodiscard]] PairOf<Real> two_product(Real a, Real b) {
    constexpr double splitter = 134217729; // 2^27 + 1: halves of 26 bits
    const Real a_scaled = splitter * a;
    const Real b_scaled = splitter * b;
    const Real a_hi = a_scaled - (a_scaled - a);
    const Real b_hi = b_scaled - (b_scaled - b);
    const Real a_lo = a - a_hi;
    const Real b_lo = b - b_hi;
    const Real product = a * b;
    return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

template<typename Real>
[[nodiscard]] PairOf<Real> operator-(PairOf<Real> a) {
    return {-a.hi, -a.lo};
}

template<typename Real>
[[nodiscard]] PairOf<Real> operator+(PairOf<Real> a, PairOf<Real> b) {
    const PairOf<Real> high = two_sum(a.hi, b.hi);
    const PairOf<Real> low = two_sum(a.lo, b.lo);
    const PairOf<Real> sum = two_sum(high.hi, high.lo + low.hi);
    return two_sum(sum.hi, sum.lo + low.lo);
}

template<typename Real>
[[nodiscard]] PairOf<Real> operator-(PairOf<Real> a, PairOf<Real> b) {
    return a + -b;
}

template<typename Real>
[[nodiscard]] PairOf<Real> operator*(PairOf<Real> a, PairOf<Real> b) {
    const PairOf<Real> product = two_product(a.hi, b.hi);
    return quick_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// a + b in half the operations: the error is below 2^-100 of |a| + |b|, not of the sum.
template<typename Real>
[[nodiscard]] PairOf<Real> quick_sum(PairOf<Real> a, PairOf<Real> b) {
    const PairOf<Real> high = two_sum(a.hi, b.hi);
    return quick_two_sum(high.hi, high.lo + (a.lo + b.lo));
}

/// b must not be 0.
template<typename Real>
[[nodiscard]] PairOf<Real> operator/(PairOf<Real> a, PairOf<Real> b) {
    const Real first = a.hi / b.hi;
    const PairOf<Real> rest = a - b * PairOf<Real>{first, Real{}};
    const Real second = rest.hi / b.hi;
    const PairOf<Real> last = rest - b * PairOf<Real>{second, Real{}};
    return two_sum(first, second) + PairOf<Real>{last.hi / b.hi, Real{}};
}

} // namespace internode
