// SPDX-License-Identifier: MIT

#include "cli/points/point_system.h"

#include "cli/points/points.h"
#include "cli/requests/exit_code.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

namespace internode::cli {

Diagnostic diagnostic_of(const LoadedText& text, const SourcePlace& place, const std::string& message,
                         const std::string& hint) {
    return diagnostic_at(text.text, text.source, place, message, hint);
}

PointSystem checked_system(const LoadedText& text, PointGrammar grammar, const PointSettings& settings) {
    CheckedPointSystem checked = make_point_system(std::move(grammar), settings);
    if (checked.system) return *std::move(checked.system);
    std::vector<Diagnostic> errors;
    for (const PointProblem& problem : checked.problems)
        errors.push_back(diagnostic_of(text, problem.place, problem.message, problem.hint));
    throw Failure(ExitCode::Refused, to_string(errors));
}

PointSystem load_point_system(PointGrammar grammar, const LoadedText& text, const std::vector<std::string>& constants,
                              std::size_t dimension) {
    PointSettings settings;
    settings.dimension = dimension;
    settings.constants = constant_values(grammar, constants);
    settings.start = PointStart::Input;
    return checked_system(text, std::move(grammar), settings);
}

void require_ring(const PointSystem& system, const std::string& name, const std::string& what) {
    if (!system.grammar().ring)
        throw failure(ExitCode::Refused, fmt::format("`{}` has open words; {}", name, what),
                      "`ring` in the grammar makes them circular");
}

} // namespace internode::cli
