// SPDX-License-Identifier: MIT
//
// N points of one dimension, row after row, as every writer of points takes them.

#pragma once

#include <cstddef>
#include <span>

namespace internode {

struct PointsView {
    std::size_t dimension = 1;             ///< >= 1
    std::span<const double> coordinates{}; ///< N rows of `dimension`

    [[nodiscard]] std::size_t size() const { return coordinates.size() / dimension; }
    [[nodiscard]] std::span<const double> operator[](std::size_t row) const {
        return coordinates.subspan(row * dimension, dimension);
    }
};

/// Checks that the view has whole rows. \throw std::invalid_argument otherwise, and for dimension 0
void require_whole_rows(const PointsView& points);

} // namespace internode
