// SPDX-License-Identifier: MIT
//
// Where a surface is measured in one direction: the distinct knots of the domain, with the weights that give the
// position there from d+1 consecutive control points.

#pragma once

#include "internode/curve/knots.h"
#include "internode/surface/sheet.h"

#include <cstddef>
#include <span>
#include <vector>

namespace internode {

struct Stop {
    double parameter;
    std::ptrdiff_t first; ///< control point of the first weight; of closed knots modulo their number
    std::size_t row;      ///< row of the weights in Stops::positions
    bool from_left;       ///< limits from the left: at the end of open knots, and before a break
    bool after_break;     ///< the stop before it has the same parameter and is the limit from the left
};

struct Stops {
    std::vector<Stop> stops;
    std::size_t width = 0;         ///< d + 1
    std::vector<double> positions; ///< rows of `width` weights
    std::vector<Join> joins;

    [[nodiscard]] std::span<const double> position(const Stop& stop) const {
        return {positions.data() + stop.row * width, width};
    }
};

/// The stops of the domain in ascending order.
[[nodiscard]] Stops make_stops(const Knots& knots);

} // namespace internode
