// SPDX-License-Identifier: MIT
//
// Knot insertion the slow way: Boehm's algorithm, one knot at a time (Boehm 1980), on any ordered field.
//
// A spline of degree d with n control points has n + d + 1 knots; point i has the support knots[i] … knots[i+d+1].
// Inserting x into the interval k, d <= k < n: for i = k-d+1 … k the new point is (1 - α) p_{i-1} + α p_i with
// α = (x - t_i) / (t_{i+d} - t_i). Points before stay, points after move one place.

#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace internode::reference {

template<typename Field>
struct Spline {
    std::size_t degree;
    std::vector<Field> knots;
    std::vector<std::vector<Field>> points; ///< any number of coordinates
};

template<typename Field>
void insert_knot(Spline<Field>& spline, const Field& x) {
    const std::size_t d = spline.degree;
    const std::vector<Field>& t = spline.knots;
    const auto after = std::upper_bound(t.begin(), t.end(), x);
    const std::size_t place = static_cast<std::size_t>(after - t.begin());
    if (place < d + 1 || place > spline.points.size()) throw std::invalid_argument("a knot outside the domain");
    const std::size_t k = place - 1;
    std::vector<std::vector<Field>> points(spline.points.begin(),
                                           spline.points.begin() + static_cast<std::ptrdiff_t>(k - d + 1));
    for (std::size_t i = k - d + 1; i <= k; ++i) {
        const Field alpha = (x - t[i]) / (t[i + d] - t[i]);
        std::vector<Field> point;
        for (std::size_t c = 0; c < spline.points[i].size(); ++c) {
            const Field& left = spline.points[i - 1][c];
            const Field& right = spline.points[i][c];
            if (left == Field() && right == Field()) // most of them, when the coordinates are weights
                point.emplace_back();
            else
                point.push_back((Field(1) - alpha) * left + alpha * right);
        }
        points.push_back(std::move(point));
    }
    points.insert(points.end(), spline.points.begin() + static_cast<std::ptrdiff_t>(k), spline.points.end());
    spline.points = std::move(points);
    spline.knots.insert(spline.knots.begin() + static_cast<std::ptrdiff_t>(place), x);
}

/// Inserts the knots that `fine` has and the spline has not, counted with multiplicity. Both ascend.
template<typename Field>
void insert_missing(Spline<Field>& spline, const std::vector<Field>& fine) {
    std::vector<Field> missing;
    std::set_difference(fine.begin(), fine.end(), spline.knots.begin(), spline.knots.end(),
                        std::back_inserter(missing));
    for (const Field& x : missing) insert_knot(spline, x);
}

} // namespace internode::reference
