// SPDX-License-Identifier: MIT

#include "internode/algebra/logarithm.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace internode {

double decimal_logarithm(double value) {
    assert(value > 0 && std::isfinite(value));
    int exponent = 0;
    double mantissa = std::frexp(value, &exponent); // exact
    if (mantissa < std::numbers::sqrt2 / 2) {
        mantissa *= 2;
        --exponent;
    }
    const double ratio = (mantissa - 1) / (mantissa + 1); // ln m = 2 artanh(ratio), |ratio| < 0.172
    const double square = ratio * ratio;
    double series = 0;
    for (int term = 12; term >= 0; --term) series = series * square + 1.0 / (2 * term + 1);
    const double natural = 2 * ratio * series;
    return natural * std::numbers::log10e + exponent * (std::numbers::ln2 * std::numbers::log10e);
}

} // namespace internode
