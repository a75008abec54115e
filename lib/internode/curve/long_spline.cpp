// SPDX-License-Identifier: MIT
//
// The triangle of Cox and de Boor with both shares of a basis function taken from sums of lengths. Neither is what a
// difference leaves over, and both are exactly 0 at the knot where they should be. The divisions do not depend on x and
// are done once for each interval.

#include "internode/curve/long_spline.h"

#include <cassert>

namespace internode {

LongRows differences(const Spans& spans, std::size_t letter, const LongRows& points) {
    assert(points.size() >= 2);
    const std::size_t dimension = points.dimension;
    const auto degree = static_cast<int>(points.size()) - 1;
    LongRows result{dimension, std::vector<DoubleDouble>(points.coordinates.size() - dimension)};
    for (int r = 0; r < degree; ++r) {
        const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(letter) - degree + 1 + r;
        const DoubleDouble span = spans.between(k, degree);
        assert(span.hi > 0);
        const DoubleDouble factor = DoubleDouble{static_cast<double>(degree), 0} / span;
        const std::size_t at = static_cast<std::size_t>(r) * dimension;
        for (std::size_t c = at; c < at + dimension; ++c)
            result.coordinates[c] = (points.coordinates[c + dimension] - points.coordinates[c]) * factor;
    }
    return result;
}

LocalBasis::LocalBasis(const Spans& spans, std::size_t letter, int degree)
    : degree_(static_cast<std::size_t>(degree))
    , length_(spans[static_cast<std::ptrdiff_t>(letter)])
    , weights_(degree_ + 1) {
    assert(degree >= 0 && degree <= max_degree);
    assert(length_.hi > 0);
    const auto j = static_cast<std::ptrdiff_t>(letter);
    for (int i = 0; i < degree; ++i) {
        left_.push_back(spans.between(j - i, i));
        right_.push_back(spans.between(j + 1, i));
    }
    for (int r = 1; r <= degree; ++r)
        for (int i = 0; i < r; ++i) reciprocals_.push_back(DoubleDouble{1, 0} / spans.between(j + i + 1 - r, r));
}

std::span<const DoubleDouble> LocalBasis::at(DoubleDouble offset) {
    assert(offset.hi >= 0 && offset.hi <= length_.hi);
    const DoubleDouble rest = length_ - offset;
    weights_[0] = {1, 0};
    auto reciprocal = reciprocals_.begin();
    for (std::size_t r = 1; r <= degree_; ++r) {
        DoubleDouble saved;
        for (std::size_t i = 0; i < r; ++i, ++reciprocal) {
            const DoubleDouble share = weights_[i] * *reciprocal;
            weights_[i] = saved + (rest + right_[i]) * share;
            saved = (offset + left_[r - 1 - i]) * share;
        }
        weights_[r] = saved;
    }
    return weights_;
}

void combine(std::span<const DoubleDouble> weights, const LongRows& rows, DoubleDouble* out) {
    assert(rows.size() == weights.size());
    const DoubleDouble* const first = rows.coordinates.data();
    for (std::size_t c = 0; c < rows.dimension; ++c) {
        DoubleDouble sum = weights[0] * first[c];
        for (std::size_t k = 1; k < weights.size(); ++k) sum = sum + weights[k] * first[k * rows.dimension + c];
        out[c] = sum;
    }
}

} // namespace internode
