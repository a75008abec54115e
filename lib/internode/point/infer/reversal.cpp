// SPDX-License-Identifier: MIT
//
// Coarse points are sums with the weights of the rule, each rounded once. P c is not kept: each of its points is made,
// compared with its fine point and forgotten.

#include "internode/point/infer/reversal.h"

#include "internode/point/infer/floor_division.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace internode {

namespace {

/// Rows of coordinates round a ring.
class Ring {
public:
    Ring(std::span<const double> points, std::size_t dimension)
        : points_(points)
        , dimension_(dimension) {}

    [[nodiscard]] std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(points_.size() / dimension_); }
    [[nodiscard]] std::span<const double> operator[](std::ptrdiff_t i) const {
        const std::ptrdiff_t within = floor_division(i, size()).remainder;
        return points_.subspan(static_cast<std::size_t>(within) * dimension_, dimension_);
    }

private:
    std::span<const double> points_;
    std::size_t dimension_;
};

/// One weight rounded once.
struct Term {
    std::ptrdiff_t offset = 0;
    double weight = 0;
};

void add(std::span<double> sum, const Ring& ring, std::ptrdiff_t at, const std::vector<Term>& terms) {
    for (const Term& term : terms) {
        const std::span<const double> point = ring[at + term.offset];
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += term.weight * point[i];
    }
}

std::vector<Term> window_terms(const ReverseRule& rule) {
    std::vector<Term> terms;
    for (std::size_t k = 0; k < rule.weights.size(); ++k)
        if (rule.weights[k] != 0)
            terms.push_back({rule.first + static_cast<std::ptrdiff_t>(k), to_double(rule.weights[k])});
    return terms;
}

/// The stencil of each of the m new points of an old one: new point r depends on old point q by a_{r - mq}.
std::vector<std::vector<Term>> stencil_terms(const UniformMask& mask) {
    const auto arity = static_cast<std::ptrdiff_t>(mask.arity);
    std::vector<std::vector<Term>> stencils(mask.arity);
    for (std::size_t i = mask.coefficients.size(); i-- > 0;) {
        if (mask.coefficients[i] == 0) continue;
        const Division place = floor_division(mask.first + static_cast<std::ptrdiff_t>(i), arity);
        stencils[static_cast<std::size_t>(place.remainder)].push_back(
            {-place.quotient, to_double(mask.coefficients[i])});
    }
    return stencils;
}

struct Terms {
    std::ptrdiff_t arity = 0;
    std::vector<Term> window;
    std::vector<std::vector<Term>> stencils;
};

ReversedLevel one_level(const Terms& terms, std::span<const double> fine, std::size_t dimension, std::ptrdiff_t phase) {
    const Ring ring(fine, dimension);
    assert(ring.size() > 0 && ring.size() % terms.arity == 0 && "check() has seen to it");
    const std::ptrdiff_t count = ring.size() / terms.arity;
    ReversedLevel level;
    level.points.assign(static_cast<std::size_t>(count) * dimension, 0);
    for (std::ptrdiff_t j = 0; j < count; ++j)
        add(std::span(level.points).subspan(static_cast<std::size_t>(j) * dimension, dimension), ring,
            phase + terms.arity * j, terms.window);
    const Ring coarse(level.points, dimension);
    std::vector<double> made(dimension);
    double squares = 0;
    for (std::ptrdiff_t k = 0; k < ring.size(); ++k) {
        std::ranges::fill(made, 0);
        add(made, coarse, k / terms.arity, terms.stencils[static_cast<std::size_t>(k % terms.arity)]);
        double square = 0;
        const std::span<const double> point = ring[phase + k];
        for (std::size_t i = 0; i < dimension; ++i) square += (point[i] - made[i]) * (point[i] - made[i]);
        level.largest_error = std::max(level.largest_error, std::sqrt(square));
        squares += square;
    }
    level.rms_error = std::sqrt(squares / static_cast<double>(ring.size()));
    return level;
}

void check(const UniformMask& mask, const ReverseRule& rule, std::span<const double> points,
           const ReversalOptions& options) {
    if (mask.arity != rule.arity) throw std::invalid_argument("reversed: a rule of another arity");
    if (options.dimension == 0 || points.empty() || points.size() % options.dimension != 0)
        throw std::invalid_argument("reversed: the rows of coordinates are not whole");
    const auto factor = points_per_coarse_point(mask.arity, options.levels);
    if (!factor || (points.size() / options.dimension) % *factor != 0)
        throw std::invalid_argument("reversed: the number of points cannot be divided so often");
}

} // namespace

std::vector<ReversedLevel> reversed(const UniformMask& mask, const ReverseRule& rule, std::span<const double> points,
                                    const ReversalOptions& options) {
    check(mask, rule, points, options);
    const Terms terms{static_cast<std::ptrdiff_t>(mask.arity), window_terms(rule), stencil_terms(mask)};
    std::vector<ReversedLevel> levels;
    for (std::uint64_t level = 0; level < options.levels; ++level) {
        const std::span<const double> fine = level == 0 ? points : std::span<const double>(levels.back().points);
        const std::uint64_t phase = options.phase % (fine.size() / options.dimension);
        levels.push_back(one_level(terms, fine, options.dimension, static_cast<std::ptrdiff_t>(phase)));
    }
    return levels;
}

std::optional<std::uint64_t> points_per_coarse_point(std::size_t arity, std::uint64_t levels) {
    constexpr std::uint64_t most = std::uint64_t{1} << 62U;
    std::uint64_t factor = 1;
    for (std::uint64_t level = 0; level < levels && arity > 1; ++level) {
        if (factor > most / arity) return std::nullopt;
        factor *= arity;
    }
    return factor;
}

std::uint64_t RingSizes::nearest() const {
    assert(below <= measured && (above == 0 || measured <= above));
    return below != 0 && (above == 0 || measured - below <= above - measured) ? below : above;
}

RingSizes ring_sizes(std::uint64_t measured, std::size_t arity, std::uint64_t levels) {
    const std::optional<std::uint64_t> factor = points_per_coarse_point(arity, levels);
    if (!factor) return {measured, 0, 0};
    assert(*factor > 0);
    const std::uint64_t below = measured / *factor * *factor;
    return {measured, below, below + *factor};
}

} // namespace internode
