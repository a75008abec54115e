// SPDX-License-Identifier: MIT

#include "internode/curve/curve.h"

#include <cassert>
#include <cmath>
#include <fmt/format.h>

namespace internode {

namespace {

std::string counted(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Whether the coordinates make whole points.
std::vector<std::string> row_problems(std::size_t dimension, std::size_t coordinates) {
    if (dimension == 0) return {"a point needs at least one coordinate"};
    if (coordinates % dimension == 0) return {};
    return {fmt::format("{} do not make whole points of {}", counted(coordinates, "coordinate"),
                        counted(dimension, "coordinate"))};
}

/// Whether points and word have the sizes that degree, 1 … 12, and ends ask for.
std::vector<std::string> count_problems(int degree, Ends ends, std::size_t letters, std::size_t points) {
    assert(degree >= 1 && degree <= max_degree);
    const bool open = ends == Ends::Open;
    const std::string curve = fmt::format("{} curve of degree {}", open ? "an open" : "a closed", degree);
    const std::size_t extra = open ? static_cast<std::size_t>(degree) : 0;
    const std::size_t least = extra + 1;
    if (points < least) return {fmt::format("{} needs at least {}, not {}", curve, counted(least, "point"), points)};
    if (letters == points + extra) return {};
    return {fmt::format("{} with {} needs a word of {}, not {}", curve, counted(points, "point"),
                        counted(points + extra, "letter"), letters)};
}

std::vector<std::string> coordinate_problems(std::size_t dimension, const std::vector<double>& points) {
    constexpr std::size_t listed = 5; // enough to see a pattern
    std::vector<std::string> problems;
    std::size_t found = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i])) continue;
        if (++found <= listed)
            problems.push_back(fmt::format("row {}, column {} is {}: every coordinate must be a finite number",
                                           i / dimension + 1, i % dimension + 1, points[i]));
    }
    if (found > listed) problems.push_back(fmt::format("and {} more coordinates are not finite", found - listed));
    return problems;
}

} // namespace

Curve::Curve(Knots knots, std::size_t dimension, std::vector<double> points)
    : knots_(std::move(knots))
    , dimension_(dimension)
    , points_(std::move(points)) {
    assert(dimension_ > 0);
    assert(points_.size() == knots_.size() * dimension_);
}

CheckedCurve make_curve(Knots knots, std::size_t dimension, std::vector<double> points) {
    CheckedCurve checked;
    checked.problems = row_problems(dimension, points.size());
    if (checked.problems.empty())
        checked.problems = count_problems(knots.degree(), knots.ends(), knots.word().size(), points.size() / dimension);
    if (checked.problems.empty()) checked.problems = coordinate_problems(dimension, points);
    if (checked.problems.empty()) checked.curve = Curve(std::move(knots), dimension, std::move(points));
    return checked;
}

CheckedCurve make_curve(const IntervalSystem& system, CurveData data) {
    CheckedCurve checked;
    checked.problems = row_problems(data.dimension, data.points.size());
    if (!checked.problems.empty()) return checked;
    if (data.degree >= 1 && data.degree <= max_degree) // other degrees are for make_knots
        checked.problems =
            count_problems(data.degree, data.ends, data.word.size(), data.points.size() / data.dimension);
    if (!checked.problems.empty()) return checked;
    CheckedKnots knots = make_knots(system, {data.degree, data.ends, std::move(data.word), std::move(data.origin)});
    checked.problems = std::move(knots.problems);
    for (std::string& problem : coordinate_problems(data.dimension, data.points))
        checked.problems.push_back(std::move(problem));
    if (checked.problems.empty())
        checked.curve = Curve(*std::move(knots.knots), data.dimension, std::move(data.points));
    return checked;
}

} // namespace internode
