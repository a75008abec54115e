// SPDX-License-Identifier: MIT

#include "internode/point/compile/fast_derivation.h"

#include "internode/point/limits.h"
#include "internode/stencil/coordinate_buffer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {
namespace {

/// Whether so many modules are allowed, and the interpreter could hold their numbers.
bool has_room(const CompiledGrammar::WordSize& size, std::size_t dimension, std::uint64_t most) {
    const bool holds_numbers = size.numbers / values_per_module <= most;
    const bool holds_points = dimension <= values_per_module || size.points <= most / dimension * values_per_module;
    return size.modules <= most && size.points <= most && holds_numbers && holds_points;
}

FastDerivation interpreted(const PointSystem& system, const ModuleWord& word, std::uint64_t cycles,
                           const DeriveOptions& options) {
    Derivation derived = derive(system, word, cycles, options);
    if (derived.problem) return {std::nullopt, std::move(derived.problem), std::nullopt, std::nullopt};
    return {std::move(derived.word), std::nullopt, std::nullopt, std::nullopt};
}

/// The word by its automaton; none of both when only the interpreter knows it.
FastDerivation compiled_word(const CompiledGrammar& grammar, const std::vector<double>& start, int cycles,
                             const FastOptions& options) {
    assert(!grammar.cells().empty() && start.size() % grammar.cells().size() == 0);
    const std::size_t dimension = start.size() / grammar.cells().size();
    const CompiledGrammar::WordSize size = grammar.size(static_cast<std::uint64_t>(cycles));
    if (size.points == 0) return {};
    if (!has_room(size, dimension, options.derive.max_modules))
        return {std::nullopt, std::nullopt, TooLargeWord{size, dimension}, std::nullopt};
    const RefinementPlan plan = grammar.plan(cycles);
    std::vector<double> points = in_large_pages<double>(plan.output_size() * dimension);
    plan.apply<double>(start, dimension, points, options.apply);
    if (!std::ranges::all_of(points, [](double coordinate) { return std::isfinite(coordinate); })) return {};
    return {grammar.word(plan.final_cells(), points, dimension), std::nullopt, std::nullopt, std::nullopt};
}

} // namespace

Compilation compile_derivation(const PointSystem& system, StartWord start, const DeriveOptions& options) {
    if (options.phase == 0) return compile(system, start);
    Compilation none;
    none.reasons.push_back({{}, "a phase turns the ring"});
    return none;
}

FastDerivation derive_fast(const PointSystem& system, const DerivationStart& from, std::uint64_t cycles,
                           const FastOptions& options) {
    if (options.interpreter_only || cycles == 0 || cycles > max_compiled_cycles)
        return interpreted(system, from.word, cycles, options.derive);
    const Compilation compilation = compile_derivation(system, from.start, options.derive);
    if (!compilation.compiled) {
        FastDerivation result = interpreted(system, from.word, cycles, options.derive);
        result.interpreted = compilation.reasons.front();
        return result;
    }
    FastDerivation result =
        compiled_word(*compilation.compiled, cell_points(from.word, system), static_cast<int>(cycles), options);
    if (result.word || result.too_large) return result;
    return interpreted(system, from.word, cycles, options.derive);
}

} // namespace internode
