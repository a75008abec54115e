// SPDX-License-Identifier: MIT

#include "internode/interval/quantity.h"

#include <cassert>

namespace internode {

Quantity exact_quantity(const Number& number) {
    const auto [lower, upper] = number.enclosure();
    return {number.to_double(), {lower, upper}, number};
}

Quantity enclosed_quantity(const Enclosure& bounds) {
    assert(bounds.lower <= bounds.upper);
    return {bounds.lower + (bounds.upper - bounds.lower) / 2, bounds, std::nullopt};
}

} // namespace internode
