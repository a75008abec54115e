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

std::vector<double> projected(std::span<const double> rows, std::size_t width) {
    if (width < 2 || rows.size() % width != 0) throw std::invalid_argument("whole rows of points and weights");
    std::vector<double> result(rows.begin(), rows.end());
    for (std::size_t row = 0; row < rows.size(); row += width) {
        const double weight = rows[row + width - 1];
        if (!(weight > 0)) throw std::invalid_argument("a weight that is not positive");
        for (std::size_t c = 0; c + 1 < width; ++c) result[row + c] /= weight;
    }
    return result;
}

std::vector<double> projected_points(std::span<const double> rows, std::size_t width) {
    std::vector<double> result = projected(rows, width);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < result.size(); ++i)
        if ((i + 1) % width != 0) result[kept++] = result[i];
    result.resize(kept);
    return result;
}

} // namespace internode
