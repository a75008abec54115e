// SPDX-License-Identifier: MIT

#include "internode/curve/reverse/resampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace internode {

namespace {

void require_points(std::span<const double> points, std::size_t dimension, std::size_t count) {
    if (dimension == 0 || points.empty() || points.size() % dimension != 0)
        throw std::invalid_argument("no whole points to resample");
    if (count == 0) throw std::invalid_argument("a polygon of no points");
}

/// Distance without overflow of the squares.
double chord(std::span<const double> a, std::span<const double> b) {
    assert(a.size() == b.size());
    double most = 0;
    for (std::size_t c = 0; c < a.size(); ++c) most = std::max(most, std::abs(a[c] - b[c]));
    if (most == 0) return 0;
    double sum = 0;
    for (std::size_t c = 0; c < a.size(); ++c) sum += ((a[c] - b[c]) / most) * ((a[c] - b[c]) / most);
    return most * std::sqrt(sum);
}

/// The parameter of every point, and of the return to the first one when closed.
std::vector<double> parameters(std::span<const double> points, std::size_t dimension, Ends ends, Spacing spacing) {
    const std::size_t n = points.size() / dimension;
    const std::size_t edges = ends == Ends::Circular ? n : n - 1;
    std::vector<double> at{0};
    for (std::size_t i = 0; i < edges; ++i) {
        const auto from = points.subspan(i * dimension, dimension);
        const auto to = points.subspan((i + 1) % n * dimension, dimension);
        at.push_back(at.back() + (spacing == Spacing::Index ? 1 : chord(from, to)));
    }
    return at;
}

} // namespace

ResampledPolygon resampled(std::span<const double> points, std::size_t dimension, Ends ends, std::size_t count) {
    require_points(points, dimension, count);
    const std::size_t n = points.size() / dimension;
    ResampledPolygon result;
    if (dimension == 1) result.spacing = Spacing::Index;
    std::vector<double> at = parameters(points, dimension, ends, result.spacing);
    if (!(at.back() > 0 && std::isfinite(at.back()))) {
        result.spacing = Spacing::Index;
        at = parameters(points, dimension, ends, result.spacing);
    }
    const std::size_t steps = ends == Ends::Circular ? count : std::max<std::size_t>(count, 2) - 1;
    result.points.reserve(count * dimension);
    std::size_t edge = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double wanted =
            i == steps ? at.back() : at.back() * (static_cast<double>(i) / static_cast<double>(steps));
        while (edge + 1 < at.size() && at[edge + 1] <= wanted) ++edge;
        const bool at_point = edge + 1 == at.size();
        const double part = at_point ? 0 : (wanted - at[edge]) / (at[edge + 1] - at[edge]);
        for (std::size_t c = 0; c < dimension; ++c) {
            const double from = points[edge % n * dimension + c];
            const double to = points[(edge + 1) % n * dimension + c];
            result.points.push_back(part == 0 ? from : (1 - part) * from + part * to);
        }
    }
    return result;
}

std::vector<double> cut(std::span<const double> points, std::size_t dimension, std::size_t count) {
    require_points(points, dimension, count);
    if (count > points.size() / dimension) throw std::invalid_argument("more points than there are");
    return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count * dimension)};
}

FittedPolygon fitted(std::span<const double> points, std::size_t dimension, Ends ends, Fit fit, std::size_t count) {
    require_points(points, dimension, count);
    const std::size_t measured = points.size() / dimension;
    Fitting fitting{.fit = count == measured ? Fit::AsMeasured : fit, .measured = measured, .points = count};
    if (fitting.fit == Fit::AsMeasured) return {{points.begin(), points.end()}, fitting};
    if (fit == Fit::Cut) return {cut(points, dimension, count), fitting};
    ResampledPolygon result = resampled(points, dimension, ends, count);
    fitting.spacing = result.spacing;
    return {std::move(result.points), fitting};
}

std::string to_string(const Fitting& fitting) {
    std::string text = std::to_string(fitting.measured) + (fitting.measured == 1 ? " point" : " points");
    if (fitting.fit == Fit::AsMeasured)
        text += ", as measured";
    else if (fitting.fit == Fit::Cut)
        text += ", the last " + std::to_string(fitting.measured - fitting.points) +
                " cut off: " + std::to_string(fitting.points);
    else
        text += ", resampled to " + std::to_string(fitting.points) + " at equal steps of " +
                (fitting.spacing == Spacing::Index ? "the index" : "chord length");
    if (fitting.clamped) text += "; the ends of the curve clamped";
    return text;
}

} // namespace internode
