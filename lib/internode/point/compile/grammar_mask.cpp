// SPDX-License-Identifier: MIT

#include "internode/point/compile/grammar_mask.h"

#include <map>

namespace internode {
namespace {

/// The rows of the children as one sequence: p'_{m i + c} = Σ_t w_t p_{i + first + t} has its weights at the indices
/// c - m (first + t).
std::map<std::ptrdiff_t, Rational> coefficients(const std::vector<CellChild>& children) {
    const NumberField rationals;
    const auto arity = static_cast<std::ptrdiff_t>(children.size());
    std::map<std::ptrdiff_t, Rational> all;
    for (std::ptrdiff_t c = 0; c < arity; ++c) {
        const CellRow& row = children[static_cast<std::size_t>(c)].row;
        for (std::size_t t = 0; t < row.weights.size(); ++t)
            if (row.weights[t].sign() != 0)
                all[c - arity * (row.first + static_cast<std::ptrdiff_t>(t))] =
                    row.weights[t].coefficients(rationals).front();
    }
    return all;
}

} // namespace

std::optional<UniformMask> uniform_mask(const std::vector<CellChild>& children) {
    const std::map<std::ptrdiff_t, Rational> all = coefficients(children);
    if (all.empty()) return std::nullopt;
    UniformMask mask{children.size(), all.begin()->first, {}};
    mask.coefficients.resize(static_cast<std::size_t>(all.rbegin()->first - mask.first) + 1);
    for (const auto& [index, weight] : all) mask.coefficients[static_cast<std::size_t>(index - mask.first)] = weight;
    return mask;
}

std::optional<UniformMask> uniform_mask(const CompiledGrammar& compiled) {
    if (!compiled.interior()) return std::nullopt;
    const std::uint32_t start[] = {*compiled.interior()};
    if (normal_form(compiled.rules(), start).rules.size() != 1) return std::nullopt;
    return uniform_mask(compiled.rules()[start[0]]);
}

std::optional<UniformMask> uniform_mask(const PointSystem& system) {
    const Compilation compilation = compile(system, {many_points});
    return compilation.compiled ? uniform_mask(*compilation.compiled) : std::nullopt;
}

} // namespace internode
