// SPDX-License-Identifier: MIT
//
// Integer division towards minus infinity: a row m q + r belongs to old point q, also before the first.

#pragma once

#include <cstddef>

namespace internode {

struct Division {
    std::ptrdiff_t quotient = 0;
    std::ptrdiff_t remainder = 0; ///< 0 … divisor - 1
};

/// divisor > 0.
[[nodiscard]] constexpr Division floor_division(std::ptrdiff_t dividend, std::ptrdiff_t divisor) {
    const std::ptrdiff_t remainder = (dividend % divisor + divisor) % divisor;
    return {(dividend - remainder) / divisor, remainder};
}

} // namespace internode
