// SPDX-License-Identifier: MIT

#include "internode/curve/homogeneous.h"

#include <stdexcept>

namespace internode {

std::optional<std::size_t> first_bad_weight(std::span<const double> weights) {
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (!(weights[i] >= smallest_weight && weights[i] <= largest_weight)) return i;
    return std::nullopt;
}

std::vector<double> homogeneous(std::span<const double> points, std::size_t dimension,
                                std::span<const double> weights) {
    if (dimension == 0 || points.size() != weights.size() * dimension)
        throw std::invalid_argument("a weight per point is meant");
    if (first_bad_weight(weights)) throw std::invalid_argument("a weight is out of range");
    std::vector<double> rows;
    rows.reserve(points.size() + weights.size());
    for (std::size_t k = 0; k < weights.size(); ++k) {
        for (std::size_t c = 0; c < dimension; ++c) rows.push_back(weights[k] * points[k * dimension + c]);
        rows.push_back(weights[k]);
    }
    return rows;
}

WeightedPoints projected(std::span<const double> rows, std::size_t dimension) {
    const std::size_t width = dimension + 1;
    if (dimension == 0 || rows.size() % width != 0) throw std::invalid_argument("whole rows of points and weights");
    WeightedPoints result;
    result.points.reserve(rows.size() / width * dimension);
    result.weights.reserve(rows.size() / width);
    for (std::size_t row = 0; row < rows.size(); row += width) {
        const double weight = rows[row + dimension];
        if (!(weight > 0)) throw std::invalid_argument("a weight that is not positive");
        for (std::size_t c = 0; c < dimension; ++c) result.points.push_back(rows[row + c] / weight);
        result.weights.push_back(weight);
    }
    return result;
}

} // namespace internode
