// SPDX-License-Identifier: MIT

#include "internode/point/infer/production.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

constexpr std::size_t most_repeated = 3;  ///< vl, vll, vlll as the papers write, then vl4
constexpr std::size_t most_lettered = 11; ///< va … vk; the next would be vl

std::string context_name(char side, std::size_t distance) {
    assert(distance > 0);
    if (distance <= most_repeated) return "v_" + std::string(distance, side);
    return std::string{'v', '_', side} + std::to_string(distance);
}

/// All formals in the order of the text.
std::vector<std::string> formals_of(const PointProduction& production) {
    std::vector<std::string> formals;
    for (std::size_t i = production.left; i > 0; --i) formals.push_back(context_name('l', i));
    for (std::size_t i = 0; i < production.strict; ++i) {
        const bool lettered = production.strict <= most_lettered;
        if (production.strict == 1)
            formals.emplace_back("v");
        else if (lettered)
            formals.push_back(std::string{'v', '_', static_cast<char>('a' + i)});
        else
            formals.push_back("v_" + std::to_string(i + 1));
    }
    for (std::size_t i = 1; i <= production.right; ++i) formals.push_back(context_name('r', i));
    return formals;
}

/// Appends `weight formal`, without the weight when it is 1 or -1.
void append_term(Expression& sum, const Rational& weight, std::uint32_t formal) {
    if (abs(weight) != 1) {
        sum.code.push_back({Operation::Number, static_cast<std::uint32_t>(sum.numbers.size())});
        sum.numbers.push_back(weight);
    }
    sum.code.push_back({Operation::Formal, formal});
    if (abs(weight) != 1) sum.code.push_back({Operation::Multiply, 0});
    if (weight == -1) sum.code.push_back({Operation::Negate, 0});
}

/// Σ weight formal, as the language reads it: `-1/16 v_l + 9/16 v - 1/16 v_r`. An empty sum is `0 v`.
Expression sum_of(const PointStencil& stencil, std::size_t left, std::size_t formals) {
    Expression sum;
    if (stencil.empty()) append_term(sum, 0, static_cast<std::uint32_t>(left));
    for (const StencilTerm& term : stencil) {
        const std::ptrdiff_t formal = term.offset + static_cast<std::ptrdiff_t>(left);
        if (formal < 0 || formal >= static_cast<std::ptrdiff_t>(formals))
            throw std::invalid_argument("to_grammar: a stencil reaches beyond the contexts of its production");
        const bool first = sum.code.empty();
        append_term(sum, first ? term.weight : Rational(abs(term.weight)), static_cast<std::uint32_t>(formal));
        if (!first) sum.code.push_back({term.weight < 0 ? Operation::Subtract : Operation::Add, 0});
    }
    return sum;
}

PointRule rule_of(const PointProduction& production, Symbol point, std::optional<Symbol> marker) {
    if ((production.after_marker || production.before_marker) && !marker)
        throw std::invalid_argument("to_grammar: a ring has no end markers");
    PointRule rule;
    if (production.after_marker) rule.left.push_back(*marker);
    rule.left.insert(rule.left.end(), production.left, point);
    rule.predecessor.assign(production.strict, point);
    rule.right.assign(production.right, point);
    if (production.before_marker) rule.right.push_back(*marker);
    rule.formals = formals_of(production);
    for (const PointStencil& stencil : production.successor) {
        ModuleTemplate module;
        module.letter = point;
        module.arguments.push_back(sum_of(stencil, production.left, rule.formals.size()));
        rule.successor.push_back(std::move(module));
    }
    return rule;
}

/// `# P(v) | P(v) | P(v) #`.
PointInput marked_input(Symbol point, Symbol marker) {
    ModuleTemplate module;
    module.letter = point;
    module.arguments.push_back(sum_of({{0, 1}}, 0, 1));
    ModuleTemplate end;
    end.letter = marker;
    PointInput input;
    input.formal = "v";
    input.first = {end, module};
    input.each = {module};
    input.last = {module, end};
    input.has_ends = true;
    return input;
}

} // namespace

PointProduction with_shortest_contexts(std::size_t strict, std::vector<PointStencil> successor) {
    assert(strict > 0);
    std::ptrdiff_t first = 0;
    std::ptrdiff_t last = static_cast<std::ptrdiff_t>(strict) - 1;
    for (const PointStencil& stencil : successor) {
        if (stencil.empty()) continue;
        first = std::min(first, stencil.front().offset);
        last = std::max(last, stencil.back().offset);
    }
    PointProduction production;
    production.left = static_cast<std::size_t>(-first);
    production.strict = strict;
    production.right = static_cast<std::size_t>(last) + 1 - strict;
    production.successor = std::move(successor);
    return production;
}

bool is_identity(const PointProduction& production) {
    return production.strict == 1 && production.successor == std::vector<PointStencil>{{{0, 1}}};
}

PointGrammar to_grammar(std::string name, WordEnds ends, std::span<const PointProduction> productions) {
    PointGrammar grammar;
    grammar.name = std::move(name);
    grammar.ring = ends == WordEnds::Ring;
    std::optional<Symbol> marker;
    if (!grammar.ring) marker = grammar.letters.add("#");
    const Symbol point = grammar.letters.add("P");
    grammar.arity.assign(grammar.letters.size(), 0);
    grammar.arity[to_index(point)] = 1;
    if (marker) grammar.input = marked_input(point, *marker);
    for (const PointProduction& production : productions) grammar.rules.push_back(rule_of(production, point, marker));
    if (ends == WordEnds::KeptMarkers) {
        PointRule kept;
        kept.predecessor = {*marker};
        ModuleTemplate end;
        end.letter = *marker;
        kept.successor.push_back(std::move(end));
        grammar.rules.push_back(std::move(kept));
    }
    return grammar;
}

} // namespace internode
