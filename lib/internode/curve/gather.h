// SPDX-License-Identifier: MIT
//
// Weighted sums of consecutive control points: what refinement and limits are made of.
//
// A row of d+1 weights starts at a parent index that may be negative or reach past the end of a closed curve. A closed
// word shorter than d+1 wraps more than once, and a parent then occurs several times in one row.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace internode {

/// The control points of a curve, readable as d+1 consecutive rows from any place.
class Parents {
public:
    Parents(std::span<const double> points, std::size_t dimension, std::size_t width)
        : points_(points)
        , dimension_(dimension)
        , width_(width)
        , wrapped_(width * dimension) {}

    /// Rows first … first + width - 1, modulo the number of points; valid until the next call.
    [[nodiscard]] const double* rows(std::ptrdiff_t first);

private:
    std::span<const double> points_;
    std::size_t dimension_;
    std::size_t width_;
    std::vector<double> wrapped_;
};

/// out[c] = ((weights[0] rows[0][c] + weights[1] rows[1][c]) + …): the order of stencil/kernel.h. A row with a single 1
/// copies its parent exactly, but for the sign of a zero.
void combine(std::span<const double> weights, const double* rows, std::size_t dimension, double* out);

} // namespace internode
