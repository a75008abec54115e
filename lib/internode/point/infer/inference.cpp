// SPDX-License-Identifier: MIT
//
// Shifts and their productions: what closed and open curves have in common.

#include "internode/point/infer/inference.h"

#include "internode/point/infer/floor_division.h"

#include <algorithm>
#include <cstdlib>

namespace internode {

namespace {

/// Weight of the strict predecessor in the new points of a shift, one by one.
std::vector<Rational> own_weights(const RowPattern& pattern, std::ptrdiff_t shift) {
    const auto arity = static_cast<std::ptrdiff_t>(pattern.arity());
    std::vector<Rational> weights;
    for (std::ptrdiff_t t = 0; t < arity; ++t) {
        const Division row = floor_division(shift + t, arity);
        const PointStencil& stencil = pattern.stencils[static_cast<std::size_t>(row.remainder)];
        const auto own = std::ranges::lower_bound(stencil, -row.quotient, {}, &StencilTerm::offset);
        weights.push_back(own != stencil.end() && own->offset == -row.quotient ? own->weight : Rational(0));
    }
    return weights;
}

/// Offsets that any stencil has, or 0 … 0.
struct Reach {
    std::ptrdiff_t first = 0;
    std::ptrdiff_t last = 0;
};

Reach reach_of(const RowPattern& pattern) {
    std::optional<Reach> reach;
    for (const PointStencil& stencil : pattern.stencils) {
        if (stencil.empty()) continue;
        if (!reach) reach = Reach{stencil.front().offset, stencil.back().offset};
        reach->first = std::min(reach->first, stencil.front().offset);
        reach->last = std::max(reach->last, stencil.back().offset);
    }
    return reach.value_or(Reach{});
}

/// What is compared of two shifts.
struct Merit {
    std::ptrdiff_t shift = 0;
    Rational own_weight; ///< of the strict predecessor in all its new points: large when they lie near
    std::size_t contexts = 0;
    std::size_t end_rules = 0;
    std::vector<Rational> weights;
};

std::size_t context_modules(const RowPattern& pattern, std::ptrdiff_t shift) {
    const auto arity = static_cast<std::ptrdiff_t>(pattern.arity());
    std::ptrdiff_t first = 0;
    std::ptrdiff_t last = 0;
    for (std::ptrdiff_t t = 0; t < arity; ++t) {
        const Division row = floor_division(shift + t, arity);
        const PointStencil& stencil = pattern.stencils[static_cast<std::size_t>(row.remainder)];
        if (stencil.empty()) continue;
        first = std::min(first, stencil.front().offset + row.quotient);
        last = std::max(last, stencil.back().offset + row.quotient);
    }
    return static_cast<std::size_t>(last - first);
}

Merit merit_of(const RowPattern& pattern, std::ptrdiff_t shift, std::size_t end_rules) {
    Merit merit{shift, 0, context_modules(pattern, shift), end_rules, own_weights(pattern, shift)};
    for (const Rational& weight : merit.weights) merit.own_weight += weight;
    return merit;
}

bool is_better(const Merit& a, const Merit& b) {
    if (a.own_weight != b.own_weight) return a.own_weight > b.own_weight;
    if (a.contexts != b.contexts) return a.contexts < b.contexts;
    if (a.end_rules != b.end_rules) return a.end_rules < b.end_rules;
    if (a.weights != b.weights) return std::ranges::lexicographical_compare(b.weights, a.weights);
    return std::abs(a.shift) < std::abs(b.shift);
}

/// All shifts with a weight on the strict predecessor; shift 0 when there is none.
std::vector<std::ptrdiff_t> own_shifts(const RowPattern& pattern) {
    const auto arity = static_cast<std::ptrdiff_t>(pattern.arity());
    const Reach reach = reach_of(pattern);
    std::vector<std::ptrdiff_t> shifts;
    for (std::ptrdiff_t shift = -arity * (reach.last + 1); shift <= arity * (1 - reach.first); ++shift)
        if (std::ranges::any_of(own_weights(pattern, shift), [](const Rational& weight) { return weight != 0; }))
            shifts.push_back(shift);
    if (shifts.empty()) shifts.push_back(0);
    return shifts;
}

ShiftList best_of(const std::vector<Merit>& merits) {
    ShiftList list;
    if (merits.empty()) return list;
    const auto best = std::ranges::min_element(merits, is_better);
    const auto index = static_cast<std::size_t>(best - merits.begin());
    list.recommended = best->shift;
    const std::size_t before = std::min(index, max_listed_shifts / 2);
    const std::size_t end = std::min(merits.size(), index - before + max_listed_shifts);
    for (std::size_t i = index - before; i < end; ++i) list.shifts.push_back(merits[i].shift);
    return list;
}

} // namespace

ShiftedProduction production_of(const RowPattern& pattern, std::ptrdiff_t shift) {
    const auto arity = static_cast<std::ptrdiff_t>(pattern.arity());
    ShiftedProduction result;
    result.shift = shift;
    std::vector<PointStencil> successor;
    for (std::ptrdiff_t t = 0; t < arity; ++t) {
        const Division row = floor_division(shift + t, arity);
        PointStencil stencil = pattern.stencils[static_cast<std::size_t>(row.remainder)];
        for (StencilTerm& term : stencil) term.offset += row.quotient;
        successor.push_back(std::move(stencil));
    }
    result.production = with_shortest_contexts(1, std::move(successor));
    return result;
}

ShiftList sensible_shifts(const RowPattern& pattern) {
    std::vector<Merit> merits;
    for (const std::ptrdiff_t shift : own_shifts(pattern)) merits.push_back(merit_of(pattern, shift, 0));
    return best_of(merits);
}

ShiftList sensible_open_shifts(const OpenPattern& pattern) {
    std::vector<Merit> merits;
    for (const std::ptrdiff_t shift : sensible_shifts(pattern.pattern).shifts) {
        const InferredOpenProductions inferred = open_productions(pattern, shift);
        if (!inferred.productions) continue;
        const std::size_t end_rules = inferred.productions->first.size() + inferred.productions->last.size();
        merits.push_back(merit_of(pattern.pattern, shift, end_rules));
    }
    return best_of(merits);
}

PointGrammar closed_grammar(std::string name, const ShiftedProduction& production) {
    return to_grammar(std::move(name), WordEnds::Ring, std::span(&production.production, 1));
}

} // namespace internode
