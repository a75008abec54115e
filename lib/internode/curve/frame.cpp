// SPDX-License-Identifier: MIT

#include "internode/curve/frame.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace internode {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The largest coordinate without its sign.
double size_of(std::span<const double> vector) {
    double largest = 0;
    for (const double x : vector) largest = std::max(largest, std::abs(x));
    return largest;
}

/// |vector / size|, between 1 and the root of the dimension.
double relative_length(std::span<const double> vector, double size) {
    assert(size > 0);
    double sum = 0;
    for (const double x : vector) sum += (x / size) * (x / size);
    return std::sqrt(sum);
}

} // namespace

void unit_tangent(std::span<const double> first, std::span<double> unit) {
    assert(first.size() == unit.size());
    const double size = size_of(first);
    const double length = size > 0 ? relative_length(first, size) : none;
    for (std::size_t i = 0; i < first.size(); ++i) unit[i] = size > 0 ? first[i] / size / length : none;
}

double curvature(std::span<const double> first, std::span<const double> second) {
    assert(first.size() == second.size());
    const double speed = size_of(first);
    if (!(speed > 0)) return none;
    const double bend = size_of(second);
    if (bend == 0 || first.size() < 2) return 0;
    const auto cross = [&](std::size_t i, std::size_t j) {
        return (first[i] / speed) * (second[j] / bend) - (first[j] / speed) * (second[i] / bend);
    };
    double area = 0;
    if (first.size() == 2) {
        area = cross(0, 1);
    } else {
        for (std::size_t i = 0; i < first.size(); ++i)
            for (std::size_t j = i + 1; j < first.size(); ++j) area += cross(i, j) * cross(i, j);
        area = std::sqrt(area);
    }
    const double length = relative_length(first, speed);
    // On a line `area` is a difference of zeros, -0 for some signs of theirs: + 0 makes that 0 and changes nothing
    // else.
    return area / (length * length * length) * (bend / speed) / speed + 0.0;
}

} // namespace internode
