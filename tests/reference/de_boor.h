// SPDX-License-Identifier: MIT
//
// B-spline curves the slow way: de Boor's recursion as it is written in textbooks, on knots added up letter by letter,
// in long double or exactly. Closed curves are unrolled to open ones. Shares nothing with the library but word,
// lengths, ratio and, where exact, its numbers.

#pragma once

#include "internode/curve/curve.h"

#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace internode::reference {

using Real = long double;

/// An open curve with knots t_0 … t_{n+d} for n points; the domain is t_d … t_n.
template<typename Scalar>
struct BasicDeBoorCurve {
    std::size_t degree = 1;
    std::vector<Scalar> knots;
    std::vector<std::vector<Scalar>> points;
    [[nodiscard]] Scalar begin() const { return knots[degree]; }
    [[nodiscard]] Scalar end() const { return knots[points.size()]; }
};
using DeBoorCurve = BasicDeBoorCurve<Real>;
using ExactCurve = BasicDeBoorCurve<Number>;

/// The domain starts at 0. Of a closed curve point m of the result is point m - d of the curve. `length` and
/// `coordinate` make scalars of exact lengths and of doubles.
template<typename Scalar, typename Length, typename Coordinate>
BasicDeBoorCurve<Scalar> unrolled(const Curve& curve, Length length_of, Coordinate coordinate_of) {
    const auto d = static_cast<std::size_t>(curve.degree());
    const bool closed = curve.ends() == Ends::Circular;
    const std::size_t size = curve.size();
    const std::size_t shift = closed ? d * size - d : 0;
    const std::size_t count = closed ? size + d : size;
    const Number scale = pow(curve.system().ratio(), -curve.step());

    BasicDeBoorCurve<Scalar> result;
    result.degree = d;
    for (std::size_t m = 0; m < count; ++m) {
        std::vector<Scalar>& point = result.points.emplace_back();
        for (std::size_t c = 0; c < curve.dimension(); ++c)
            point.push_back(coordinate_of(curve.points()[(m + shift) % size * curve.dimension() + c]));
    }
    result.knots.assign(count + d + 1, Scalar(0));
    const auto length = [&](std::size_t m) {
        const Symbol symbol = curve.word()[(m + shift) % curve.word().size()];
        return length_of(curve.system().length(symbol) * scale);
    };
    for (std::size_t i = d; i > 0; --i) result.knots[i - 1] = result.knots[i] - length(i - 1);
    for (std::size_t i = d; i < count + d; ++i) result.knots[i + 1] = result.knots[i] + length(i);
    return result;
}

/// In long double, every length the nearest double.
inline DeBoorCurve de_boor_curve(const Curve& curve) {
    return unrolled<Real>(
        curve, [](const Number& length) { return static_cast<Real>(length.to_double()); },
        [](double x) { return static_cast<Real>(x); });
}

/// Nothing rounded.
inline ExactCurve exact_curve(const Curve& curve) {
    return unrolled<Number>(
        curve, [](const Number& length) { return length; }, [](double x) { return Number(Rational(x)); });
}

/// Point i of level r of de Boor's triangle at x.
template<typename Scalar>
Scalar de_boor_value(const BasicDeBoorCurve<Scalar>& curve, std::size_t i, std::size_t r,
                     const std::type_identity_t<Scalar>& x, std::size_t c) {
    if (r == 0) return curve.points[i][c];
    const Scalar low = curve.knots[i];
    const Scalar high = curve.knots[i + curve.degree + 1 - r];
    const Scalar alpha = (x - low) / (high - low);
    return (Scalar(1) - alpha) * de_boor_value(curve, i - 1, r - 1, x, c) +
           alpha * de_boor_value(curve, i, r - 1, x, c);
}

/// The curve at x, taking the piece over [t_j, t_{j+1}], which must not be empty.
template<typename Scalar>
std::vector<Scalar> de_boor_piece(const BasicDeBoorCurve<Scalar>& curve, std::size_t j,
                                  const std::type_identity_t<Scalar>& x) {
    std::vector<Scalar> point;
    for (std::size_t c = 0; c < curve.points.front().size(); ++c)
        point.push_back(de_boor_value(curve, j, curve.degree, x, c));
    return point;
}

/// The curve at x in its domain; at a knot the piece on its right, at the end the piece on its left.
inline std::vector<Real> de_boor(const DeBoorCurve& curve, Real x) {
    std::size_t found = 0;
    for (std::size_t j = curve.degree; j < curve.points.size(); ++j)
        if (curve.knots[j] < curve.knots[j + 1] && (found == 0 || curve.knots[j] <= x)) found = j;
    if (found == 0) throw std::invalid_argument("the domain is empty");
    return de_boor_piece(curve, found, x);
}

/// The derivative, a curve of one degree less: piece j of the curve is piece j - 1 of it. Of degree 0 it has none.
template<typename Scalar>
BasicDeBoorCurve<Scalar> derivative(const BasicDeBoorCurve<Scalar>& curve) {
    if (curve.degree == 0) throw std::invalid_argument("a curve of degree 0 has no derivative curve");
    BasicDeBoorCurve<Scalar> result;
    result.degree = curve.degree - 1;
    result.knots.assign(curve.knots.begin() + 1, curve.knots.end() - 1);
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
        const Scalar span = curve.knots[i + curve.degree + 1] - curve.knots[i + 1];
        const Scalar degree(static_cast<int>(curve.degree));
        result.points.push_back(curve.points[i]);
        // Without a span the curve breaks there, and no piece has this point.
        for (std::size_t c = 0; c < curve.points[i].size(); ++c)
            result.points[i][c] =
                span == Scalar(0) ? Scalar(0) : degree * (curve.points[i + 1][c] - curve.points[i][c]) / span;
    }
    return result;
}

} // namespace internode::reference
