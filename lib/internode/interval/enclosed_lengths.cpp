// SPDX-License-Identifier: MIT
//
// The symbols that occur are numbered anew and the vector of their matrix is enclosed. The first declared length scales
// it, and each later one must lie within the bounds. A frequency is x / (x + rest), which rises with x and falls with
// the rest: its bounds are those of opposite ends.

#include "internode/interval/enclosed_lengths.h"

#include "internode/interval/enclosed_vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>

namespace internode {

namespace {

/// The final class, if there is only one.
const IntervalClass* only_final(const ClassGraph& graph) {
    const IntervalClass* result = nullptr;
    for (const IntervalClass& one : graph.classes) {
        if (one.final && result != nullptr) return nullptr;
        if (one.final) result = &one;
    }
    return result;
}

/// The symbols that occur, and the matrix on them alone.
struct Compressed {
    std::vector<std::uint32_t> symbols;
    SparseMatrix matrix;
    std::vector<std::uint32_t> final; ///< the members of the final class, by their new numbers
};

Compressed compressed(const ClassGraph& graph, const IntervalClass& final) {
    Compressed result;
    std::vector<std::uint32_t> place(graph.matrix.size());
    for (std::uint32_t i = 0; i < graph.matrix.size(); ++i) {
        if (graph.class_of[i] == no_class) continue;
        place[i] = static_cast<std::uint32_t>(result.symbols.size());
        result.symbols.push_back(i);
    }
    for (const std::uint32_t symbol : result.symbols) {
        SparseRow& row = result.matrix.emplace_back(graph.matrix[symbol]);
        for (auto& entry : row) entry.first = place[entry.first];
    }
    for (const std::uint32_t member : final.members) result.final.push_back(place[member]);
    return result;
}

std::vector<Quantity> spread(const std::vector<RationalBounds>& bounds, const std::vector<std::uint32_t>& symbols,
                             std::size_t n) {
    assert(bounds.size() == symbols.size());
    std::vector<Quantity> result(n, exact_quantity(Number(0)));
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        const bool point = bounds[i].lower == bounds[i].upper;
        result[symbols[i]] =
            point ? exact_quantity(Number(bounds[i].lower)) : enclosed_quantity(to_enclosure(bounds[i]));
    }
    return result;
}

std::optional<EnclosedConflict> conflict(const LengthDeclaration& declaration, const RationalBounds& bounds,
                                         const Alphabet& names) {
    assert(bounds.lower <= bounds.upper);
    if (bounds.lower == bounds.upper && declaration.length == bounds.lower) return std::nullopt;
    const bool certain = declaration.length < bounds.lower || declaration.length > bounds.upper;
    const Enclosure around = to_enclosure(bounds);
    const std::string& name = names.name(declaration.symbol);
    const char* verb = certain ? "disagrees" : "cannot be confirmed";
    return EnclosedConflict{declaration.symbol, certain,
                            fmt::format("length {} = {} {}: with the first declared length, {} has a length between {} "
                                        "and {}",
                                        name, to_string(declaration.length), verb, name, around.lower, around.upper)};
}

} // namespace

EnclosedLengths enclosed_lengths(const ClassGraph& graph, const IntervalGrammar& grammar) {
    EnclosedLengths result;
    const IntervalClass* final = only_final(graph);
    if (final == nullptr) return result;
    const Compressed system = compressed(graph, *final);
    std::optional<std::vector<RationalBounds>> bounds = enclose_vector(system.matrix, system.final);
    if (!bounds) return result;
    bool scaled = false;
    for (const LengthDeclaration& declaration : grammar.lengths) {
        const auto symbol = static_cast<std::uint32_t>(to_index(declaration.symbol));
        const auto place = std::ranges::lower_bound(system.symbols, symbol);
        if (place == system.symbols.end() || *place != symbol) continue;
        const auto index = static_cast<std::size_t>(place - system.symbols.begin());
        if (!scaled)
            rescale(*bounds, index, declaration.length);
        else if (auto problem = conflict(declaration, (*bounds)[index], grammar.alphabet))
            result.conflicts.push_back(std::move(*problem));
        scaled = true;
    }
    result.lengths = spread(*bounds, system.symbols, graph.matrix.size());
    return result;
}

std::vector<Quantity> enclosed_frequencies(const ClassGraph& graph) {
    const IntervalClass* final = only_final(graph);
    if (final == nullptr) return {};
    std::vector<std::uint32_t> everything(final->members.size());
    std::iota(everything.begin(), everything.end(), 0U);
    std::optional<std::vector<RationalBounds>> bounds = enclose_vector(transposed(final->block), everything);
    if (!bounds) return {};
    RationalBounds sum;
    for (const RationalBounds& one : *bounds) {
        sum.lower += one.lower;
        sum.upper += one.upper;
    }
    for (RationalBounds& one : *bounds) {
        assert(one.lower > 0 && one.lower <= one.upper);
        const Rational others_low = sum.lower - one.lower;
        const Rational others_high = sum.upper - one.upper;
        one = {one.lower / (one.lower + others_high), one.upper / (one.upper + others_low)};
    }
    return spread(*bounds, final->members, graph.matrix.size());
}

} // namespace internode
