// SPDX-License-Identifier: MIT
//
// Algorithm A5.4, RefineKnotVectCurve, of Piegl and Tiller, The NURBS Book, for cubics with points in space: what one
// writes by hand from the book.

#pragma once

#include <span>

namespace internode::bench {

struct A54Output {
    std::span<double> knots;  ///< coarse and inserted ones together
    std::span<double> points; ///< 3 coordinates each
};

/// `knots` are clamped and ascending, `inserted` ascending and inside. Writes every knot and every point of `out`.
void refine_a54(std::span<const double> knots, std::span<const double> points, std::span<const double> inserted,
                const A54Output& out);

} // namespace internode::bench
