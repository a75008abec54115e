// SPDX-License-Identifier: MIT

#include "internode/point/compile/interval_twin.h"

#include "internode/interval/validity.h"
#include "internode/mask/mask_properties.h"
#include "internode/point/compile/grammar_mask.h"
#include "internode/stencil/automaton.h"

#include <cassert>

namespace internode {

namespace {

constexpr std::size_t max_degree = 12; // of an automaton of intervals
constexpr std::size_t max_arity = 16;

NormalForm interval_form(std::size_t arity, int degree) {
    assert(arity >= 2 && degree >= 1 && static_cast<std::size_t>(degree) <= max_degree);
    IntervalGrammar grammar;
    const Symbol letter = grammar.alphabet.add("A");
    grammar.rules = Morphism({Word(arity, letter)});
    const IntervalSystem system = validate(grammar).system.value();
    const CellState state{.window = Word(2 * static_cast<std::size_t>(degree) - 1, letter), .lead = 0};
    const StencilAutomaton automaton = make_automaton(system, degree, {state}, 1);
    const std::uint32_t start[] = {automaton.find(state)};
    return normal_form(rules_of(automaton), start);
}

/// One state with m children: child c is p'_c = Σ_j a_{c-mj} p_j.
NormalForm mask_form(const UniformMask& mask) {
    const auto m = static_cast<std::ptrdiff_t>(mask.arity);
    const auto size = static_cast<std::ptrdiff_t>(mask.coefficients.size());
    std::vector<CellChild> children;
    for (std::ptrdiff_t c = 0; c < m; ++c) {
        // c - m j >= first for the largest j, c - m j < first + size for the smallest.
        CellRow row{.first = -size - std::abs(mask.first) - 1, .weights = {}};
        for (std::ptrdiff_t j = row.first; j <= -row.first; ++j) {
            const std::ptrdiff_t k = c - m * j - mask.first;
            row.weights.push_back(k >= 0 && k < size ? Number(mask.coefficients[static_cast<std::size_t>(k)])
                                                     : Number());
        }
        children.push_back({.state = 0, .row = trimmed(std::move(row))});
    }
    const std::uint32_t start[] = {0};
    return normal_form({std::move(children)}, start);
}

} // namespace

std::optional<IntervalTwin> interval_twin(const CompiledGrammar& compiled) {
    const auto mask = uniform_mask(compiled);
    if (!mask || mask->arity < 2 || mask->arity > max_arity) return std::nullopt;
    if (mask->coefficients.size() > (max_degree + 1) * mask->arity) return std::nullopt;
    const MaskProperties properties = mask_properties(*mask);
    const std::size_t power = properties.factor_power;
    if (properties.quotient.size() != 1 || power < 2 || power > max_degree + 1) return std::nullopt;
    IntervalTwin twin{.arity = mask->arity, .degree = static_cast<int>(power) - 1, .moved = 0};
    const NormalForm wanted = interval_form(twin.arity, twin.degree);
    const std::uint32_t interior[] = {compiled.interior().value()};
    if (normal_form(compiled.rules(), interior) == wanted) return twin;
    for (twin.moved = 1; twin.moved < twin.arity; ++twin.moved) {
        UniformMask shifted = *mask;
        shifted.first += static_cast<std::ptrdiff_t>(twin.moved);
        if (mask_form(shifted) == wanted) return twin;
    }
    return std::nullopt;
}

} // namespace internode
