// SPDX-License-Identifier: MIT
//
// Grammar, system, word of the polygon, word after all cycles, its interpretation, its points. What the grammar may not
// do with these points is said with its line, as the command says it.

#include "internode/refine_points.h"

#include "internode/grammar/points/parse_points.h"
#include "internode/point/compile/fast_derivation.h"
#include "internode/point/growth.h"
#include "internode/point/start_word.h"
#include "internode/point/strands.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace internode {

namespace {

std::string told(const RefineRequest& request, const SourcePlace& place, const std::string& message,
                 const std::string& hint) {
    return to_string(diagnostic_at(request.text, request.source, place, message, hint));
}

PointSystem system_of(const PointGrammar& grammar, const RefineRequest& request) {
    CheckedPointSystem checked =
        make_point_system(grammar, {.dimension = request.dimension, .start = PointStart::Input});
    if (checked.system) return *std::move(checked.system);
    std::string problems;
    for (const PointProblem& problem : checked.problems)
        problems += told(request, problem.place, problem.message, problem.hint);
    throw std::invalid_argument(problems);
}

ModuleWord whole(const RefineRequest& request, const std::optional<DerivationProblem>& problem,
                 std::optional<ModuleWord> word) {
    if (problem) throw std::range_error(told(request, problem->place, problem->message, problem->hint));
    return std::move(word).value();
}

/// The word after all cycles, before its interpretation.
ModuleWord derived(const PointSystem& system, const FastOptions& options, const RefineRequest& request) {
    const ModuleWord word = input_word(system, request.points);
    const auto cycles = static_cast<std::uint64_t>(request.steps);
    const std::uint64_t most = options.derive.max_modules;
    if (predicted_length(system, word, cycles, most).value_or(0) > most) throw too_many_points(request);
    FastDerivation fast = derive_fast(system, {word, {request.points.size() / request.dimension}}, cycles, options);
    if (fast.too_large) throw too_many_points(request);
    return whole(request, fast.problem, std::move(fast.word));
}

} // namespace

LimitExceeded too_many_points(const RefineRequest& request) {
    return LimitExceeded(
        fmt::format("{} steps make more than {} points (max_points)", request.steps, request.options.max_points));
}

std::vector<double> refined(const PointGrammar& grammar, const RefineRequest& request) {
    const PointSystem system = system_of(grammar, request);
    FastOptions options;
    options.derive.max_modules = request.options.max_points;
    options.apply = request.options.apply;
    Derivation shown = interpret(system, derived(system, options, request), options.derive);
    const ModuleWord last = whole(request, shown.problem, std::move(shown.word));
    PointStrands drawn = strands(last, system, system.grammar().interpretations.size());
    if (drawn.size() > 0 && drawn.dimension != request.dimension)
        throw std::invalid_argument(fmt::format("the interpretation makes points of {} coordinates of points of {}",
                                                drawn.dimension, request.dimension));
    return std::move(drawn.points);
}

} // namespace internode
