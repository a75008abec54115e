// SPDX-License-Identifier: MIT
//
// A piece of a spline and its derivatives in pairs of doubles, for values that are rounded once.
//
//     (p_k - p_{k-1}) m / (t_{k+m} - t_k)     control points of the derivative of a spline of degree m
//     N_{j-m}(x) … N_j(x)                     the basis over the interval j = [t_j, t_{j+1}), Cox and de Boor
//
// Only knot differences that contain the interval j are asked for: they are positive, whatever multiplicities surround
// it. Relative error of a sum below 2^-95 of its largest term: a derivative is as good as its differences.

#pragma once

#include "internode/curve/spans.h"

#include <cstddef>
#include <span>
#include <vector>

namespace internode {

/// Rows of `dimension` coordinates.
struct LongRows {
    std::size_t dimension = 0;
    std::vector<DoubleDouble> coordinates;
    [[nodiscard]] std::size_t size() const { return coordinates.size() / dimension; }
};

/// The control points of the derivative over the non-empty interval of letter j, of a spline of degree m >= 1 whose
/// control points j-m … j are `points`: m rows.
[[nodiscard]] LongRows differences(const Spans& spans, std::size_t letter, const LongRows& points);

/// Basis functions of degree m over one non-empty interval; their divisions are done once.
class LocalBasis {
public:
    /// 0 <= m <= 12.
    LocalBasis(const Spans& spans, std::size_t letter, int degree);
    /// N_{j-m} … N_j where `offset` lies behind the interval's begin, both ends included: >= 0, of sum 1, and exactly 0
    /// where a basis function ends. Valid until the next call.
    [[nodiscard]] std::span<const DoubleDouble> at(DoubleDouble offset);

private:
    std::size_t degree_;
    DoubleDouble length_;
    std::vector<DoubleDouble> left_;        ///< t_j - t_{j-i}, i = 0 … m - 1
    std::vector<DoubleDouble> right_;       ///< t_{j+1+i} - t_{j+1}, i = 0 … m - 1
    std::vector<DoubleDouble> reciprocals_; ///< 1 / (t_{j+i+1} - t_{j+i+1-r}) for r = 1 … m, i = 0 … r - 1
    std::vector<DoubleDouble> weights_;
};

/// Σ weights[k] · row k, as many rows as weights, added to nothing from left to right.
void combine(std::span<const DoubleDouble> weights, const LongRows& rows, DoubleDouble* out);

} // namespace internode
