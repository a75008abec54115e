// SPDX-License-Identifier: MIT
//
// b is the least-norm solution of M b = e: row t of M is a_{k-mt} for the fine points k of the window, and e is 1 in
// row 0, 0 elsewhere. It is M' y with (M M') y = e, solved exactly; both systems have solutions or neither has.

#include "internode/point/infer/reverse_rules.h"

#include "internode/point/infer/floor_division.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

struct Window {
    std::ptrdiff_t first = 0;
    std::ptrdiff_t last = 0;
};

Rational coefficient(const UniformMask& mask, std::ptrdiff_t k) {
    const std::ptrdiff_t index = k - mask.first;
    const bool inside = index >= 0 && index < static_cast<std::ptrdiff_t>(mask.coefficients.size());
    return inside ? mask.coefficients[static_cast<std::size_t>(index)] : Rational(0);
}

using Matrix = std::vector<std::vector<Rational>>;

/// M, and which of its rows belongs to the coarse point itself.
struct Conditions {
    Matrix rows;
    std::size_t own = 0;
};

/// Row t for every coarse point t that a fine point of the window depends on.
Conditions conditions(const UniformMask& mask, const Window& window) {
    assert(mask.arity > 0 && window.first <= window.last);
    const auto arity = static_cast<std::ptrdiff_t>(mask.arity);
    const std::ptrdiff_t mask_last = mask.first + static_cast<std::ptrdiff_t>(mask.coefficients.size()) - 1;
    const std::ptrdiff_t from = -floor_division(mask_last - window.first, arity).quotient;
    const std::ptrdiff_t to = floor_division(window.last - mask.first, arity).quotient;
    Conditions result;
    for (std::ptrdiff_t t = std::min<std::ptrdiff_t>(from, 0); t <= std::max<std::ptrdiff_t>(to, 0); ++t) {
        if (t == 0) result.own = result.rows.size();
        std::vector<Rational>& row = result.rows.emplace_back();
        for (std::ptrdiff_t k = window.first; k <= window.last; ++k) row.push_back(coefficient(mask, k - arity * t));
    }
    return result;
}

/// M M' with e beside it.
Matrix normal_equations(const Conditions& conditions) {
    Matrix system(conditions.rows.size());
    for (std::size_t i = 0; i < system.size(); ++i) {
        for (const std::vector<Rational>& other : conditions.rows) {
            Rational product = 0;
            for (std::size_t k = 0; k < other.size(); ++k) product += conditions.rows[i][k] * other[k];
            system[i].push_back(product);
        }
        system[i].emplace_back(i == conditions.own ? 1 : 0);
    }
    return system;
}

void subtract_multiple(std::vector<Rational>& row, const std::vector<Rational>& pivot, std::size_t column) {
    assert(row.size() == pivot.size() && pivot[column] != 0);
    if (row[column] == 0) return;
    const Rational factor = row[column] / pivot[column];
    for (std::size_t i = column; i < row.size(); ++i) row[i] -= factor * pivot[i];
}

/// A solution of the system, its last column the right side; free unknowns are 0. None when it has none.
std::optional<std::vector<Rational>> solution(Matrix system) {
    const std::size_t unknowns = system.size();
    assert(std::ranges::all_of(system, [&](const auto& row) { return row.size() == unknowns + 1; }));
    std::vector<std::size_t> pivot_columns;
    for (std::size_t column = 0; column < unknowns; ++column) {
        const std::size_t rank = pivot_columns.size();
        std::size_t pivot = rank;
        while (pivot < system.size() && system[pivot][column] == 0) ++pivot;
        if (pivot == system.size()) continue;
        std::swap(system[rank], system[pivot]);
        for (std::size_t row = 0; row < system.size(); ++row)
            if (row != rank) subtract_multiple(system[row], system[rank], column);
        pivot_columns.push_back(column);
    }
    for (std::size_t row = pivot_columns.size(); row < system.size(); ++row)
        if (system[row][unknowns] != 0) return std::nullopt;
    std::vector<Rational> values(unknowns);
    for (std::size_t row = 0; row < pivot_columns.size(); ++row)
        values[pivot_columns[row]] = system[row][unknowns] / system[row][pivot_columns[row]];
    return values;
}

std::optional<std::vector<Rational>> least_norm_weights(const UniformMask& mask, const Window& window) {
    const Conditions needed = conditions(mask, window);
    const std::optional<std::vector<Rational>> multipliers = solution(normal_equations(needed));
    if (!multipliers) return std::nullopt;
    std::vector<Rational> weights(static_cast<std::size_t>(window.last - window.first) + 1);
    for (std::size_t k = 0; k < weights.size(); ++k)
        for (std::size_t t = 0; t < needed.rows.size(); ++t) weights[k] += (*multipliers)[t] * needed.rows[t][k];
    return weights;
}

/// The narrowest window centred on the fine points that depend on coarse point 0: one or two of them.
Window central_window(const UniformMask& mask) {
    const std::ptrdiff_t twice_centre = 2 * mask.first + static_cast<std::ptrdiff_t>(mask.coefficients.size()) - 1;
    const Division half = floor_division(twice_centre, 2);
    return {half.quotient, half.quotient + half.remainder};
}

/// The m parts of the mask, of every m-th coefficient each, have a combination that is 1 iff they have no common root,
/// and then one with no more coefficients than they have themselves (Bézout). A centred window of twice the size holds
/// it.
std::ptrdiff_t widest_window(const UniformMask& mask) {
    const std::size_t enough = 2 * (mask.coefficients.size() + mask.arity + 1);
    return static_cast<std::ptrdiff_t>(std::min(max_reverse_window, enough));
}

std::optional<Window> narrowest_window(const UniformMask& mask) {
    const std::ptrdiff_t widest = widest_window(mask);
    for (Window window = central_window(mask); window.last - window.first < widest; --window.first, ++window.last)
        if (least_norm_weights(mask, window)) return window;
    return std::nullopt;
}

Window widened(const Window& window, std::size_t wider) {
    const auto size = static_cast<std::size_t>(window.last - window.first) + 1;
    const std::size_t room = (max_reverse_window - std::min(max_reverse_window, size)) / 2;
    const auto more = static_cast<std::ptrdiff_t>(std::min(wider, room));
    assert(size + 2 * static_cast<std::size_t>(more) <= std::max(size, max_reverse_window));
    return {window.first - more, window.last + more};
}

} // namespace

std::optional<ReverseRule> reverse_rule(const UniformMask& mask, std::size_t wider) {
    if (mask.arity == 0 || mask.coefficients.empty())
        throw std::invalid_argument("reverse_rule: a mask has an arity and coefficients");
    const std::optional<Window> narrowest = narrowest_window(mask);
    if (!narrowest) return std::nullopt;
    const Window window = widened(*narrowest, wider);
    return ReverseRule{mask.arity, window.first, least_norm_weights(mask, window).value()};
}

std::optional<ReverseRule> reverse_rule_of_window(const UniformMask& mask, std::uint64_t fine_points) {
    std::optional<ReverseRule> narrowest = reverse_rule(mask);
    if (!narrowest || fine_points <= narrowest->weights.size()) return narrowest;
    const std::size_t missing = static_cast<std::size_t>(fine_points) - narrowest->weights.size();
    return reverse_rule(mask, (missing + 1) / 2);
}

Rational gain(const ReverseRule& rule) {
    Rational sum = 0;
    for (const Rational& weight : rule.weights) sum += abs(weight);
    return sum;
}

PointProduction production_of(const ReverseRule& rule) {
    PointStencil stencil;
    for (std::size_t k = 0; k < rule.weights.size(); ++k)
        if (rule.weights[k] != 0) stencil.push_back({rule.first + static_cast<std::ptrdiff_t>(k), rule.weights[k]});
    return with_shortest_contexts(rule.arity, {std::move(stencil)});
}

PointGrammar reverse_grammar(std::string name, const ReverseRule& rule) {
    const PointProduction production = production_of(rule);
    return to_grammar(std::move(name), WordEnds::Ring, std::span(&production, 1));
}

} // namespace internode
