// SPDX-License-Identifier: MIT

#include "internode/interval/interval_system.h"

#include "internode/interval/length_scales.h"
#include "internode/interval/system_maker.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>

namespace internode {

namespace {

bool declares(const std::vector<LengthDeclaration>& declarations, Symbol symbol) {
    return std::ranges::any_of(declarations, [&](const LengthDeclaration& one) { return one.symbol == symbol; });
}

/// The rational lengths given, then the declarations that still hold: the grammar prints as the system it stands for.
std::vector<LengthDeclaration> merged(const std::vector<LengthDeclaration>& old, const std::vector<FixedLength>& given,
                                      const NumberField& field, const std::vector<Number>& lengths) {
    std::vector<LengthDeclaration> result;
    for (const FixedLength& one : given)
        if (one.length.is_rational() && !declares(result, one.symbol))
            result.push_back({one.symbol, one.length.coefficients(field).front()});
    for (const LengthDeclaration& one : old)
        if (!declares(result, one.symbol) && lengths[to_index(one.symbol)] == Number(one.length)) result.push_back(one);
    return result;
}

} // namespace

const Number& IntervalSystem::length(Symbol symbol) const {
    static const Number zero;
    return symbol == zero_interval ? zero : impl_->lengths.at(to_index(symbol));
}

bool IntervalSystem::occurs(Symbol symbol) const {
    return length(symbol).sign() != 0;
}

std::string SystemMaker::generator_name(const NumberField& field) {
    return field.minimal_polynomial() == std::vector<Integer>{-1, -1, 1} ? "φ" : "ρ";
}

IntervalSystem SystemMaker::make(IntervalGrammar grammar, NumberField field, Number ratio, std::vector<Number> lengths,
                                 std::size_t period) {
    assert(lengths.size() == grammar.alphabet.size() && grammar.rules.size() == grammar.alphabet.size());
    assert(ratio > 1 && period >= 1);
    std::string name = generator_name(field);
    return IntervalSystem(
        {std::move(grammar), std::move(field), std::move(ratio), std::move(name), std::move(lengths), period});
}

IntervalSystem bisection(const IntervalSystem& system) {
    IntervalGrammar grammar = system.grammar();
    std::vector<Word> images;
    for (std::size_t i = 0; i < grammar.alphabet.size(); ++i) images.push_back({to_symbol(i), to_symbol(i)});
    grammar.rules = Morphism(std::move(images));
    return SystemMaker::make(std::move(grammar), system.field(), Number(2), system.lengths(), 1);
}

IntervalSystem power(const IntervalSystem& system, int steps) {
    if (steps < 1) throw std::invalid_argument("the power of a system must be at least 1");
    IntervalGrammar grammar = system.grammar();
    Word alphabet;
    for (std::size_t i = 0; i < grammar.alphabet.size(); ++i) alphabet.push_back(to_symbol(i));
    if (letter_counts(grammar.rules, alphabet, static_cast<std::uint64_t>(steps), max_power_letters).saturated)
        throw std::length_error("the rules of " + std::to_string(steps) + " steps at once have more than " +
                                std::to_string(max_power_letters) + " letters");
    grammar.rules = power(grammar.rules, steps);
    if (!grammar.name.empty() && steps > 1) grammar.name += "^" + std::to_string(steps);
    // A class of period p falls into gcd(p, k) classes of period p / gcd(p, k).
    const std::size_t period = system.period() / std::gcd(system.period(), static_cast<std::size_t>(steps));
    return SystemMaker::make(std::move(grammar), system.field(), pow(system.ratio(), steps), system.lengths(), period);
}

IntervalSystem one_symbol_a_length(const IntervalSystem& system, const std::vector<std::string>& names,
                                   const std::vector<Rational>& lengths) {
    if (system.alphabet().size() != 1) throw std::invalid_argument("a grammar of one symbol is meant");
    if (names.empty() || names.size() != lengths.size()) throw std::invalid_argument("a name and a length per symbol");
    const std::size_t letters = system.rules().image(to_symbol(0)).size();
    IntervalGrammar grammar;
    grammar.name = system.grammar().name;
    std::vector<Word> images;
    std::vector<Number> numbers;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (grammar.alphabet.add(names[i]) != to_symbol(i)) throw std::invalid_argument("a name twice");
        if (sgn(lengths[i]) <= 0) throw std::invalid_argument("a length must be positive");
        images.emplace_back(letters, to_symbol(i));
        grammar.lengths.push_back({to_symbol(i), lengths[i]});
        numbers.emplace_back(lengths[i]);
    }
    grammar.rules = Morphism(std::move(images));
    return SystemMaker::make(std::move(grammar), system.field(), system.ratio(), std::move(numbers), 1);
}

FixedLengths with_lengths(const IntervalSystem& system, const std::vector<FixedLength>& lengths) {
    const ClassGraph graph = class_graph(system.grammar());
    const auto is_shared = [](const IntervalClass& one) { return one.home == no_class; };
    if (system.ratio() != system.field().generator() && std::ranges::any_of(graph.classes, is_shared))
        throw std::invalid_argument("lengths are given before a power is taken");
    ScaledLengths scaled =
        scale_lengths({graph, system.field()}, system.lengths(), lengths, system.alphabet(), system.ratio_name());
    if (!scaled.conflicts.empty()) return {std::nullopt, std::move(scaled.conflicts)};
    IntervalGrammar grammar = system.grammar();
    grammar.lengths = merged(grammar.lengths, lengths, system.field(), scaled.lengths);
    return {SystemMaker::make(std::move(grammar), system.field(), system.ratio(), std::move(scaled.lengths),
                              system.period()),
            {}};
}

} // namespace internode
