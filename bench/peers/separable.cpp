// SPDX-License-Identifier: MIT

#include "bench/peers/separable.h"

namespace internode::bench {
namespace {

void refine_row(const CubicRows& masks, const double* points, double* out) {
    for (std::size_t j = 0; j < masks.first.size(); ++j) {
        const double* const w = &masks.weights[4 * j];
        const double* const p = points + 3 * masks.first[j];
        for (std::size_t c = 0; c < 3; ++c)
            out[3 * j + c] = w[0] * p[c] + w[1] * p[3 + c] + w[2] * p[6 + c] + w[3] * p[9 + c];
    }
}

void combine_rows(const double* w, const double* rows, std::size_t length, double* __restrict out) {
    for (std::size_t c = 0; c < length; ++c)
        out[c] = w[0] * rows[c] + w[1] * rows[length + c] + w[2] * rows[2 * length + c] + w[3] * rows[3 * length + c];
}

} // namespace

void refine_separable(const CubicRows& u, const CubicRows& v, std::span<const double> points, std::span<double> between,
                      std::span<double> out) {
    const std::size_t length = 3 * v.first.size();
    const std::size_t rows = between.size() / length;
    const std::size_t coarse_length = points.size() / rows;
    for (std::size_t i = 0; i < rows; ++i) refine_row(v, &points[i * coarse_length], &between[i * length]);
    for (std::size_t i = 0; i < u.first.size(); ++i)
        combine_rows(&u.weights[4 * i], &between[u.first[i] * length], length, &out[i * length]);
}

} // namespace internode::bench
