// SPDX-License-Identifier: MIT
//
// A real number with its certificate: exact in a number field, or between two doubles.

#pragma once

#include "internode/algebra/number.h"
#include "internode/algebra/perron.h"

#include <optional>

namespace internode {

struct Quantity {
    double value = 0;            ///< nearest double when exact, else the midpoint of the bounds
    Enclosure bounds;            ///< certified: bounds.lower <= the number <= bounds.upper
    std::optional<Number> exact; ///< the exact value, when it is known
};

[[nodiscard]] Quantity exact_quantity(const Number& number);
[[nodiscard]] Quantity enclosed_quantity(const Enclosure& bounds);

} // namespace internode
