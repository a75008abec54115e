// SPDX-License-Identifier: MIT

#include "internode/curve/gather.h"

#include <algorithm>
#include <cassert>

namespace internode {

const double* Parents::rows(std::ptrdiff_t first) {
    assert(!points_.empty() && points_.size() % dimension_ == 0);
    const auto size = static_cast<std::ptrdiff_t>(points_.size() / dimension_);
    if (first >= 0 && first + static_cast<std::ptrdiff_t>(width_) <= size)
        return points_.data() + static_cast<std::size_t>(first) * dimension_;
    auto parent = static_cast<std::size_t>((first % size + size) % size);
    for (std::size_t k = 0; k < width_; ++k) {
        std::copy_n(points_.data() + parent * dimension_, dimension_, wrapped_.data() + k * dimension_);
        if (++parent == static_cast<std::size_t>(size)) parent = 0;
    }
    return wrapped_.data();
}

void combine(std::span<const double> weights, const double* rows, std::size_t dimension, double* out) {
    assert(!weights.empty());
    for (std::size_t c = 0; c < dimension; ++c) {
        double sum = weights[0] * rows[c];
        for (std::size_t k = 1; k < weights.size(); ++k) sum += weights[k] * rows[k * dimension + c];
        out[c] = sum;
    }
}

} // namespace internode
