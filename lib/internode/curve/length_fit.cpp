// SPDX-License-Identifier: MIT
//
// Intervals that have no length of a settled class must have one of the open class. The shortest of them over each
// length of that class is a scale to try; it fits when all of them, divided by it, are lengths of the class. Equality
// is exact, so that sets of numbers decide.

#include "internode/curve/length_fit.h"

#include "internode/interval/class_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>

namespace internode {

namespace {

constexpr std::size_t listed_symbols = 8; // symbols named in a message
constexpr std::size_t longest_text = 40;  // of an exact number in a message

using Classes = std::set<std::uint32_t>;

/// The final classes that a class leads to.
void collect_finals(const ClassGraph& graph, std::uint32_t index, std::vector<bool>& seen, Classes& finals) {
    std::vector<std::uint32_t> open{index};
    while (!open.empty()) {
        const std::uint32_t next = open.back();
        open.pop_back();
        if (seen[next]) continue;
        seen[next] = true;
        if (graph.classes[next].final) finals.insert(next);
        const auto& successors = graph.classes[next].successors;
        open.insert(open.end(), successors.begin(), successors.end());
    }
}

/// The final classes whose scale nobody said.
Classes open_classes(const IntervalSystem& system, const ClassGraph& graph, const std::vector<Symbol>& fixed) {
    Classes said;
    std::vector<bool> seen(graph.classes.size());
    const auto settle = [&](Symbol symbol) {
        const std::uint32_t index = graph.class_of.at(to_index(symbol));
        if (index != no_class) collect_finals(graph, index, seen, said);
    };
    for (const LengthDeclaration& declaration : system.grammar().lengths) settle(declaration.symbol);
    for (const Symbol symbol : fixed) settle(symbol);
    Classes open;
    for (std::uint32_t index = 0; index < graph.classes.size(); ++index)
        if (graph.classes[index].final && !said.contains(index)) open.insert(index);
    return open;
}

std::string length_text(const IntervalSystem& system, Symbol symbol, const Number& length) {
    return fmt::format("{} = {}", system.alphabet().name(symbol), exact_text(length, system));
}

std::string lengths_text(const IntervalSystem& system) {
    std::vector<std::string> texts;
    std::size_t count = 0;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i)
        if (system.occurs(to_symbol(i)) && ++count <= listed_symbols)
            texts.push_back(length_text(system, to_symbol(i), system.lengths()[i]));
    if (count > listed_symbols) texts.emplace_back("…");
    return fmt::format("{}", fmt::join(texts, ", "));
}

/// The one class whose scale is open: its symbols, and the intervals that only they can have.
struct OpenScale {
    std::vector<Symbol> symbols;
    std::set<Number> lengths;   ///< lengths of the symbols, at the scale that the system has
    std::vector<Number> wanted; ///< distinct, ascending
};

OpenScale open_scale(const IntervalSystem& system, const ClassGraph& graph, std::uint32_t open,
                     const std::vector<Number>& intervals) {
    OpenScale result;
    std::set<Number> settled;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) {
        const std::uint32_t index = graph.class_of[i];
        if (index == no_class) continue;
        if (graph.classes[index].home == open) {
            result.symbols.push_back(to_symbol(i));
            result.lengths.insert(system.lengths()[i]);
        } else if (graph.classes[index].home != no_class) {
            settled.insert(system.lengths()[i]);
        }
    }
    std::set<Number> wanted;
    for (const Number& length : intervals)
        if (length.sign() != 0 && !settled.contains(length)) wanted.insert(length);
    result.wanted.assign(wanted.begin(), wanted.end());
    return result;
}

/// Every scale at which each wanted interval is the length of a symbol, ascending.
std::vector<Number> fitting_scales(const OpenScale& scale) {
    assert(!scale.wanted.empty() && !scale.lengths.empty());
    std::vector<Number> fitting;
    for (auto length = scale.lengths.rbegin(); length != scale.lengths.rend(); ++length) {
        const Number factor = scale.wanted.front() / *length;
        const Number inverse = Number(1) / factor;
        if (std::ranges::all_of(scale.wanted, [&](const Number& one) { return scale.lengths.contains(one * inverse); }))
            fitting.push_back(factor);
    }
    return fitting;
}

std::string unfit(const IntervalSystem& system, const OpenScale& scale) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < std::min(listed_symbols, scale.wanted.size()); ++i)
        texts.push_back(exact_text(scale.wanted[i], system));
    if (scale.wanted.size() > listed_symbols) texts.emplace_back("…");
    return fmt::format("the intervals {} are not lengths of the grammar at any scale: {}", fmt::join(texts, ", "),
                       lengths_text(system));
}

std::string ambiguous(const IntervalSystem& system, const OpenScale& scale, const std::vector<Number>& fitting) {
    const Symbol symbol = scale.symbols.front();
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < std::min(listed_symbols, fitting.size()); ++i)
        texts.push_back(length_text(system, symbol, system.length(symbol) * fitting[i]));
    return fmt::format("the intervals fit the grammar at {} scales ({}): say a length", fitting.size(),
                       fmt::join(texts, ", or "));
}

} // namespace

std::string exact_text(const Number& number, const IntervalSystem& system) {
    std::string text = number.to_string(system.field(), system.ratio_name());
    if (text.size() > longest_text) return fmt::format("{:.10g}", number.to_double());
    return number.is_rational() ? text : fmt::format("{} ≈ {:.10g}", text, number.to_double());
}

ScaledSystem fit_scale(const IntervalSystem& system, const std::vector<Number>& intervals,
                       const std::vector<Symbol>& fixed) {
    const ClassGraph graph = class_graph(system.grammar());
    const Classes open = open_classes(system, graph, fixed);
    if (open.empty()) return {system, {}};
    if (open.size() > 1) {
        std::vector<std::string> names;
        for (const std::uint32_t index : open)
            if (names.size() < listed_symbols)
                names.push_back(system.alphabet().name(to_symbol(graph.classes[index].members.front())));
        return {std::nullopt, fmt::format("the lengths of {} are free of each other: say all of them but one",
                                          fmt::join(names, ", "))};
    }
    const OpenScale scale = open_scale(system, graph, *open.begin(), intervals);
    if (scale.wanted.empty()) return {system, {}};
    const std::vector<Number> fitting = fitting_scales(scale);
    if (fitting.empty()) return {std::nullopt, unfit(system, scale)};
    if (fitting.size() > 1) return {std::nullopt, ambiguous(system, scale, fitting)};
    const Symbol symbol = scale.symbols.front();
    return {with_lengths(system, {{symbol, system.length(symbol) * fitting.front()}}).system, {}};
}

LengthTable::LengthTable(const IntervalSystem& system)
    : system_(system) {
    symbols_[Number()] = {zero_interval};
    for (std::size_t i = 0; i < system.alphabet().size(); ++i)
        if (system.occurs(to_symbol(i))) symbols_[system.lengths()[i]].push_back(to_symbol(i));
}

const std::vector<Symbol>& LengthTable::symbols(const Number& length) const {
    static const std::vector<Symbol> none;
    const auto found = symbols_.find(length);
    return found == symbols_.end() ? none : found->second;
}

std::string LengthTable::complaint(const Number& length) const {
    const std::vector<Symbol>& found = symbols(length);
    assert(found.size() != 1 && "a length of one symbol is no complaint");
    if (found.empty()) return fmt::format("no symbol has that length ({})", lengths_text(system_));
    return fmt::format("both {} and {} have that length", system_.alphabet().name(found[0]),
                       system_.alphabet().name(found[1]));
}

} // namespace internode
