// SPDX-License-Identifier: MIT

#include "internode/input/plain_polygon.h"

#include "internode/curve/homogeneous.h"
#include "internode/input/refuse.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode {

Settled<InputPolygon> with_weights(InputPolygon polygon) {
    assert(polygon.dimension >= 1);
    return settled([&] {
        if (!polygon.weights.empty())
            refuse(fmt::format("{} has weights of its own: leave --rational out", polygon.source));
        if (polygon.dimension < 2)
            refuse(fmt::format("--rational needs a coordinate and a weight, but the points of {} have one number",
                               polygon.source));
        std::vector<double> points;
        for (std::size_t i = 0; i < polygon.points.size(); ++i)
            ((i + 1) % polygon.dimension == 0 ? polygon.weights : points).push_back(polygon.points[i]);
        polygon.points = std::move(points);
        --polygon.dimension;
        if (polygon.columns.size() > 1) polygon.columns.pop_back();
        if (const auto bad = first_bad_weight(polygon.weights))
            refuse(fmt::format("the weight of point {} of {} is {}: weights go from {} to {}", *bad + 1, polygon.source,
                               polygon.weights[*bad], smallest_weight, largest_weight));
        return std::move(polygon);
    });
}

Refusal repeated_point(const InputPolygon& polygon) {
    const std::size_t n = polygon.size();
    if (n < 2) return {};
    const auto first = polygon.points.begin();
    const auto last = first + static_cast<std::ptrdiff_t>((n - 1) * polygon.dimension);
    if (!std::equal(last, polygon.points.end(), first)) return {};
    Diagnostic diagnostic;
    diagnostic.message = fmt::format("the last of the {} points of {} repeats the first", n, polygon.source);
    diagnostic.hint = "a closed polygon joins them by itself: drop the last point";
    return {{std::move(diagnostic)}, false};
}

std::string base_name(const std::string& source) {
    const auto slash = source.find_last_of('/');
    return slash == std::string::npos ? source : source.substr(slash + 1);
}

} // namespace internode
