// SPDX-License-Identifier: MIT
//
// x comes from enclose_radius(), w from Gauss-Seidel sweeps: both in doubles, and both are guesses. They are then taken
// as integers over 2^52, and the least δ that certifies them is found exactly. So rounding can make the bounds wide, or
// there are none, but it never makes them wrong.

#include "internode/interval/enclosed_vector.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

/// Entries visited in the search for w.
constexpr std::size_t work_limit = 20'000'000;

/// The bits after the point that a double of at least 1 can have.
constexpr int fraction_bits = 52;

/// Relative width asked of the radius; rounding keeps it from less.
constexpr double radius_width = 1e-13;

std::size_t entries(const SparseMatrix& matrix) {
    std::size_t count = matrix.size();
    for (const SparseRow& row : matrix) count += row.size();
    return count;
}

/// The slack asked for, relative to x: Gauss–Seidel towards (λI − M') w = x has it after a few sweeps.
constexpr double enough_slack = 0.01;

/// w > 0 with (λI − M') w >= enough_slack x by Gauss–Seidel, or nothing. w_k = 0 stands for the missing column.
std::optional<std::vector<double>> positive_slack(const SparseMatrix& matrix, const std::vector<double>& x,
                                                  std::size_t k, double lambda) {
    assert(x.size() == matrix.size() && k < matrix.size());
    std::vector<double> w = x;
    w[k] = 0;
    const std::size_t sweeps = work_limit / entries(matrix) + 1;
    for (std::size_t sweep = 0; sweep < sweeps; ++sweep) {
        bool enough = true;
        for (std::size_t i = 0; i < w.size(); ++i) {
            if (i == k) continue;
            double others = 0;
            double own = 0;
            for (const auto& [column, entry] : matrix[i]) (column == i ? own : others) += entry * w[column];
            const double diagonal = lambda - own / w[i];
            if (diagonal <= 0 || !std::isfinite(others)) return std::nullopt;
            enough = enough && w[i] * diagonal - others >= enough_slack * x[i];
            w[i] = std::max(w[i], (x[i] + others) / diagonal);
        }
        if (enough) return w;
    }
    return std::nullopt;
}

std::vector<Integer> scaled(const std::vector<double>& values) {
    std::vector<Integer> result;
    for (const double value : values) result.emplace_back(std::ldexp(value, fraction_bits));
    return result;
}

Integer product(const SparseRow& row, const std::vector<Integer>& vector) {
    Integer sum;
    for (const auto& [column, entry] : row) sum += vector[column] * entry;
    return sum;
}

/// The least δ_up, δ_down that make x + δ_up w and x − δ_down w bounds, or nothing where w fails. All exact.
std::optional<std::pair<Rational, Rational>> steps(const SparseMatrix& matrix, const std::vector<Integer>& x,
                                                   const std::vector<Integer>& w, std::size_t k,
                                                   const Enclosure& radius) {
    assert(x.size() == matrix.size() && w.size() == matrix.size() && w[k] == 0);
    const Rational low = to_rational(radius.lower);
    const Rational high = to_rational(radius.upper);
    std::pair<Rational, Rational> result;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i == k) continue;
        const Rational slack = low * w[i] - product(matrix[i], w);
        if (slack <= 0) return std::nullopt;
        const Integer image = product(matrix[i], x);
        const Rational up = (image - low * x[i]) / slack;
        const Rational down = (high * x[i] - image) / slack;
        if (up > result.first) result.first = up;
        if (down > result.second) result.second = down;
    }
    return result;
}

} // namespace

void rescale(std::vector<RationalBounds>& bounds, std::size_t unit, const Rational& value) {
    const RationalBounds divisor = bounds.at(unit);
    assert(value > 0 && divisor.lower > 0 && divisor.lower <= divisor.upper);
    for (RationalBounds& one : bounds) {
        one.lower = one.lower * value / divisor.upper;
        one.upper = one.upper * value / divisor.lower;
    }
    bounds[unit] = {value, value};
}

std::optional<std::vector<RationalBounds>> enclose_vector(const SparseMatrix& matrix,
                                                          const std::vector<std::uint32_t>& final) {
    assert(!final.empty());
    const CertifiedRadius start = enclose_radius(matrix, radius_width);
    // A heavy symbol for k: the heavier, the further ρ(M') lies below ρ.
    const std::size_t k =
        *std::ranges::max_element(final, {}, [&](std::uint32_t symbol) { return start.vector[symbol]; });
    const auto slack = positive_slack(matrix, start.vector, k, start.radius.lower);
    if (!slack || std::ranges::any_of(*slack, [](double value) { return !std::isfinite(std::ldexp(value, 60)); }))
        return std::nullopt;
    const std::vector<Integer> x = scaled(start.vector);
    const std::vector<Integer> w = scaled(*slack);
    const auto deltas = steps(matrix, x, w, k, start.radius);
    if (!deltas) return std::nullopt;
    std::vector<RationalBounds> result;
    for (std::size_t i = 0; i < x.size(); ++i) {
        Rational lower = x[i] - deltas->second * w[i];
        Rational upper = x[i] + deltas->first * w[i];
        if (lower <= 0) return std::nullopt;
        result.push_back({std::move(lower), std::move(upper)});
    }
    const auto least = std::ranges::min_element(start.vector);
    rescale(result, static_cast<std::size_t>(least - start.vector.begin()), 1);
    return result;
}

Enclosure to_enclosure(const RationalBounds& bounds) {
    return {Number(bounds.lower).enclosure().first, Number(bounds.upper).enclosure().second};
}

} // namespace internode
