// SPDX-License-Identifier: MIT
//
// Whether a double is the nearest one to an exact number, by exact comparison with both neighbours.

#pragma once

#include "internode/algebra/number.h"

#include <cmath>
#include <limits>

namespace internode::reference {

inline bool is_nearest(double value, const Number& exact) {
    const auto distance = [&](double candidate) {
        const Number difference = Number(to_rational(candidate)) - exact;
        return difference.sign() < 0 ? -difference : difference;
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Number own = distance(value);
    return own <= distance(std::nextafter(value, infinity)) && own <= distance(std::nextafter(value, -infinity));
}

} // namespace internode::reference
