// SPDX-License-Identifier: MIT
//
// analyse() steps down from the fine polygon and synthesise() up from the coarse one, both over one Hierarchy of words
// and states. Compression only chooses places: the details there are copied as they are.

#include "internode/curve/reverse/pyramid.h"

#include "internode/curve/refinement.h"
#include "internode/curve/reverse/reverse_step.h"
#include "internode/stencil/parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>
#include <utility>

namespace internode {

namespace {

/// The middle of the box around points, per coordinate.
std::vector<double> middle_of(std::span<const double> points, std::size_t dimension) {
    assert(dimension > 0 && points.size() >= dimension);
    std::vector<double> least(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(dimension));
    std::vector<double> most = least;
    for (std::size_t i = 0; i < points.size(); ++i) {
        least[i % dimension] = std::min(least[i % dimension], points[i]);
        most[i % dimension] = std::max(most[i % dimension], points[i]);
    }
    for (std::size_t c = 0; c < dimension; ++c) least[c] = least[c] / 2 + most[c] / 2;
    return least;
}

double extent(std::span<const double> points, const std::vector<double>& middle) {
    double most = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        most = std::max(most, std::abs(points[i] - middle[i % middle.size()]));
    return most;
}

/// G of every polygon; 1 where the fine one is a single point.
std::vector<double> noise_gains(const std::vector<std::vector<double>>& polygons, std::size_t dimension) {
    const std::vector<double> middle = middle_of(polygons.back(), dimension);
    const double fine = extent(polygons.back(), middle);
    std::vector<double> gains;
    for (const std::vector<double>& polygon : polygons) gains.push_back(fine > 0 ? extent(polygon, middle) / fine : 1);
    return gains;
}

void require_moderate(std::span<const double> fine) {
    for (const double coordinate : fine)
        if (!(std::abs(coordinate) <= largest_coordinate))
            throw std::invalid_argument("a coordinate beyond 1e150, or none");
}

/// The places of all details, longest first.
struct Ranked {
    double length = 0;
    std::size_t level = 0;
    std::size_t place = 0;
};

std::vector<Ranked> ranked_details(const Pyramid& pyramid) {
    std::vector<Ranked> ranked;
    for (std::size_t level = 0; level < pyramid.levels.size(); ++level) {
        const std::vector<double> lengths = lengths_of(pyramid.levels[level].details, pyramid.coarse.dimension());
        for (std::size_t i = 0; i < lengths.size(); ++i) ranked.push_back({lengths[i], level, i});
    }
    std::ranges::stable_sort(ranked, std::greater<>(), &Ranked::length);
    return ranked;
}

/// The pyramid with the details at these places, per level.
Pyramid chosen(const Pyramid& pyramid, const std::vector<std::vector<bool>>& keep) {
    assert(keep.size() == pyramid.levels.size());
    const std::size_t dimension = pyramid.coarse.dimension();
    Pyramid result{pyramid.coarse, pyramid.options, {}};
    for (std::size_t level = 0; level < pyramid.levels.size(); ++level) {
        const PyramidLevel& from = pyramid.levels[level];
        PyramidLevel& to = result.levels.emplace_back();
        to.points = from.points;
        to.inserted = from.inserted;
        for (std::size_t i = 0; i < from.details.points.size(); ++i) {
            if (!keep[level][i]) continue;
            to.details.points.push_back(from.details.points[i]);
            const auto vector = from.details.vectors.begin() + static_cast<std::ptrdiff_t>(i * dimension);
            to.details.vectors.insert(to.details.vectors.end(), vector,
                                      vector + static_cast<std::ptrdiff_t>(dimension));
        }
    }
    return result;
}

std::vector<std::vector<bool>> none_kept(const Pyramid& pyramid) {
    std::vector<std::vector<bool>> keep;
    for (const PyramidLevel& level : pyramid.levels) keep.emplace_back(level.details.points.size());
    return keep;
}

/// What is wrong with one level; `points` are those of its finer polygon, `before` of its coarser.
std::string level_problem(const PyramidLevel& level, std::size_t points, std::size_t before, std::size_t dimension) {
    if (level.points != points) return fmt::format("has {} points where the word gives {}", level.points, points);
    assert(points >= before && "no step takes points away");
    if (level.inserted != points - before)
        return fmt::format("says {} inserted points where {} knots are inserted", level.inserted, points - before);
    const Details& details = level.details;
    if (details.points.size() > level.inserted)
        return fmt::format("has {} details for {} inserted points", details.points.size(), level.inserted);
    if (details.vectors.size() != details.points.size() * dimension)
        return fmt::format("has {} coordinates of details where {} points need {}", details.vectors.size(),
                           details.points.size(), details.points.size() * dimension);
    for (std::size_t i = 0; i < details.points.size(); ++i) {
        if (details.points[i] >= points)
            return fmt::format("has a detail at point {} of {}", details.points[i], points);
        if (i > 0 && details.points[i] <= details.points[i - 1])
            return fmt::format("has its details out of order at point {}", details.points[i]);
    }
    const auto moderate = [](double number) { return std::abs(number) <= largest_coordinate; };
    if (!std::ranges::all_of(details.vectors, moderate)) return "has a detail beyond 1e150";
    return {};
}

} // namespace

Analysis analyse(const Knots& coarse, int levels, std::size_t dimension, std::span<const double> fine,
                 const ReverseOptions& options, int threads) {
    const Hierarchy hierarchy(coarse, levels);
    if (dimension == 0 || fine.size() != hierarchy.size(levels) * dimension)
        throw std::invalid_argument(fmt::format("{} coordinates are not {} points of dimension {}", fine.size(),
                                                hierarchy.size(levels), dimension));
    require_moderate(fine);
    std::vector<std::vector<double>> polygons(static_cast<std::size_t>(levels) + 1);
    std::vector<PyramidLevel> details(static_cast<std::size_t>(levels));
    polygons.back().assign(fine.begin(), fine.end());
    std::optional<ReverseStep> step;
    std::optional<ReverseStep> next;
    const auto prepare = [&](int level) {
        next.emplace(hierarchy, level, options);
        next->prepare_details();
    };
    const auto take = [&](std::size_t level) {
        polygons[level] = step->coarse(polygons[level + 1], dimension);
        PyramidLevel& written = details[level];
        written.points = step->fine_size();
        written.inserted = step->fine_size() - step->coarse_size();
        written.details = step->details(polygons[level + 1], polygons[level], dimension);
    };
    if (levels > 0) prepare(levels - 1);
    for (int level = levels - 1; level >= 0; --level) {
        step = std::exchange(next, std::nullopt);
        for_each_task(level > 0 ? 2 : 1, threads, [&](std::size_t task) {
            task == 0 ? take(static_cast<std::size_t>(level)) : prepare(level - 1);
        });
    }
    CheckedCurve curve = make_curve(coarse, dimension, polygons.front());
    if (!curve.curve) throw std::range_error("a coarse point beyond the range of doubles");
    std::vector<double> gains = noise_gains(polygons, dimension);
    return {{*std::move(curve.curve), options, std::move(details)}, std::move(polygons), std::move(gains)};
}

std::vector<std::vector<double>> synthesise(const Pyramid& pyramid) {
    const auto levels = static_cast<int>(pyramid.levels.size());
    const std::size_t dimension = pyramid.coarse.dimension();
    const Hierarchy hierarchy(pyramid.coarse.knots(), levels);
    std::vector<std::vector<double>> polygons{pyramid.coarse.points()};
    for (int level = 0; level < levels; ++level) {
        const Details& details = pyramid.levels[static_cast<std::size_t>(level)].details;
        // Without details a step forwards needs no left inverse.
        polygons.push_back(
            details.points.empty()
                ? product(hierarchy.matrix(level), polygons.back(), dimension)
                : ReverseStep(hierarchy, level, pyramid.options).fine(polygons.back(), details, dimension));
    }
    return polygons;
}

std::vector<double> lengths_of(const Details& details, std::size_t dimension) {
    assert(details.vectors.size() == details.points.size() * dimension);
    std::vector<double> lengths;
    lengths.reserve(details.points.size());
    for (std::size_t i = 0; i < details.points.size(); ++i) {
        double square = 0;
        for (std::size_t c = 0; c < dimension; ++c) {
            const double number = details.vectors[i * dimension + c];
            square += number * number;
        }
        lengths.push_back(std::sqrt(square));
    }
    return lengths;
}

Pyramid thresholded(const Pyramid& pyramid, double least_length) {
    std::vector<std::vector<bool>> keep = none_kept(pyramid);
    for (std::size_t level = 0; level < keep.size(); ++level) {
        const std::vector<double> lengths = lengths_of(pyramid.levels[level].details, pyramid.coarse.dimension());
        for (std::size_t i = 0; i < lengths.size(); ++i) keep[level][i] = lengths[i] >= least_length;
    }
    return chosen(pyramid, keep);
}

Pyramid with_longest(const Pyramid& pyramid, std::size_t count) {
    std::vector<std::vector<bool>> keep = none_kept(pyramid);
    const std::vector<Ranked> ranked = ranked_details(pyramid);
    for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) keep[ranked[i].level][ranked[i].place] = true;
    return chosen(pyramid, keep);
}

std::size_t detail_count(const Pyramid& pyramid) {
    std::size_t count = 0;
    for (const PyramidLevel& level : pyramid.levels) count += level.details.points.size();
    return count;
}

PolygonError polygon_error(std::span<const double> a, std::span<const double> b, std::size_t dimension) {
    if (dimension == 0 || a.size() != b.size() || a.size() % dimension != 0)
        throw std::invalid_argument("two polygons of different size");
    double largest = 0;
    double sum = 0;
    for (std::size_t row = 0; row < a.size(); row += dimension) {
        double square = 0;
        for (std::size_t c = row; c < row + dimension; ++c) square += (a[c] - b[c]) * (a[c] - b[c]);
        largest = std::max(largest, square);
        sum += square;
    }
    const std::size_t points = a.size() / dimension;
    return {std::sqrt(largest), points > 0 ? std::sqrt(sum / static_cast<double>(points)) : 0};
}

bool has_loose_ends(const Knots& knots) {
    if (knots.ends() == Ends::Circular) return false;
    const auto d = static_cast<std::size_t>(knots.degree());
    const WordView word(knots.word());
    const auto is_zero = [](Symbol symbol) { return symbol == zero_interval; };
    return !std::ranges::all_of(word.first(d), is_zero) || !std::ranges::all_of(word.last(d), is_zero);
}

CheckedPyramid make_pyramid(Curve coarse, const ReverseOptions& options, std::vector<PyramidLevel> levels) {
    CheckedPyramid checked;
    if (options.window < 1) checked.problems.emplace_back("a window of no interval");
    std::size_t before = coarse.size();
    for (std::size_t level = 0; level < levels.size() && checked.problems.empty(); ++level) {
        const RefinementSize size = refined_size(coarse.knots(), coarse.dimension(), level + 1, levels[level].points);
        const auto points = static_cast<std::size_t>(size.points);
        const std::string problem = size.exceeded
                                        ? fmt::format("has {} points where the word gives more", levels[level].points)
                                        : level_problem(levels[level], points, before, coarse.dimension());
        if (!problem.empty()) checked.problems.push_back(fmt::format("level {} {}", level + 1, problem));
        before = points;
    }
    if (checked.problems.empty()) checked.pyramid = Pyramid{std::move(coarse), options, std::move(levels)};
    return checked;
}

} // namespace internode
