// SPDX-License-Identifier: MIT

#include "internode/point/check/point_validation.h"

#include "internode/point/compile/grammar_mask.h"

#include <algorithm>

namespace internode {

namespace {

constexpr std::size_t least_dimension = 2;
constexpr std::size_t largest_dimension = 4; // `v.w` is the last coordinate that has a name

// A verdict shall not take longer than a few seconds; the grammars of the papers need some thousands.
constexpr std::uint64_t compilation_work = 60'000;

CompilationFacts compilation_facts(const PointSystem& system) {
    const bool from_axiom = system.grammar().axiom && !system.grammar().input && system.start() != PointStart::Input;
    const StartWord start{from_axiom || system.start() == PointStart::Axiom ? std::nullopt
                                                                            : std::optional<std::size_t>(many_points)};
    CompileLimits limits;
    limits.work = compilation_work;
    Compilation compilation = compile(system, start, limits);
    CompilationFacts facts;
    facts.reasons = std::move(compilation.reasons);
    if (!compilation.compiled) return facts;
    facts.compiles = true;
    facts.states = compilation.compiled->automaton().state_count();
    facts.mask = uniform_mask(*compilation.compiled);
    facts.twin = interval_twin(*compilation.compiled);
    return facts;
}

} // namespace

MaskFacts mask_facts(const UniformMask& mask) {
    MaskFacts facts;
    facts.mask = mask;
    facts.properties = mask_properties(mask);
    facts.known = known_schemes(mask);
    facts.smoothness = smoothness(mask);
    return facts;
}

PointValidation make_point_validation(const PointSystem& system) {
    PointValidation validation;
    validation.dimension = system.dimension();
    validation.affine = affine_findings(system);
    validation.coverage = coverage(system);
    validation.compilation = compilation_facts(system);
    if (validation.compilation->mask) {
        const UniformMask& mask = *validation.compilation->mask;
        const bool short_enough = mask.coefficients.size() <= max_validated_coefficients;
        if (mask.arity >= 2 && !mask.coefficients.empty() && short_enough) validation.mask = mask_facts(mask);
    }
    validation.valid =
        validation.coverage->ends_complete && std::ranges::all_of(validation.affine, is_sound, &AffineFinding::verdict);
    return validation;
}

PointValidation make_point_validation(const PointGrammar& grammar, PointSettings settings) {
    PointValidation unsound;
    for (settings.dimension = least_dimension; settings.dimension <= largest_dimension; ++settings.dimension) {
        CheckedPointSystem checked = make_point_system(grammar, settings);
        if (checked.system) return make_point_validation(*checked.system);
        if (settings.dimension == least_dimension) unsound.problems = std::move(checked.problems);
    }
    return unsound;
}

} // namespace internode
