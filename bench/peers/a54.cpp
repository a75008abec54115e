// SPDX-License-Identifier: MIT

#include "bench/peers/a54.h"

#include <algorithm>
#include <cstddef>

namespace internode::bench {
namespace {

constexpr std::ptrdiff_t p = 3;

std::ptrdiff_t find_span(std::span<const double> knots, double at) {
    return std::upper_bound(knots.begin(), knots.end() - p - 1, at) - knots.begin() - 1;
}

/// to = share · to + (1 - share) · other.
void blend(double* to, const double* other, double share) {
    for (int c = 0; c < 3; ++c) to[c] = share * to[c] + (1 - share) * other[c];
}

} // namespace

void refine_a54(std::span<const double> knots, std::span<const double> points, std::span<const double> inserted,
                const A54Output& out) {
    const double* const U = knots.data();
    const double* const X = inserted.data();
    double* const V = out.knots.data();
    double* const Q = out.points.data();
    const auto r = static_cast<std::ptrdiff_t>(inserted.size()) - 1;
    const std::ptrdiff_t a = find_span(knots, X[0]);
    const std::ptrdiff_t b = find_span(knots, X[r]) + 1;
    std::copy_n(points.data(), 3 * (a - p + 1), Q);
    std::copy(points.begin() + 3 * (b - 1), points.end(), Q + 3 * (b + r));
    std::copy_n(U, a + 1, V);
    std::copy(knots.begin() + b + p, knots.end(), V + b + p + r + 1);
    std::ptrdiff_t i = b + p - 1;
    std::ptrdiff_t k = b + p + r;
    for (std::ptrdiff_t j = r; j >= 0; --j) {
        for (; X[j] <= U[i] && i > a; --i, --k) {
            std::copy_n(points.data() + 3 * (i - p - 1), 3, Q + 3 * (k - p - 1));
            V[k] = U[i];
        }
        std::copy_n(Q + 3 * (k - p), 3, Q + 3 * (k - p - 1));
        for (std::ptrdiff_t l = 1; l <= p; ++l) {
            double* const to = Q + 3 * (k - p + l - 1);
            const double above = V[k + l] - X[j];
            blend(to, to + 3, above == 0 ? 0 : above / (V[k + l] - U[i - p + l]));
        }
        V[k--] = X[j];
    }
}

} // namespace internode::bench
