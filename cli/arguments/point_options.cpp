// SPDX-License-Identifier: MIT

#include "cli/arguments/point_options.h"

#include "cli/shell/exit_code.h"

#include <fmt/format.h>

namespace internode::cli {

void refuse_curve_options(const SubdivideOptions& options) {
    const PolygonOptions& polygon = options.polygon;
    const char* const name = polygon.degree                        ? "-d"
                             : !polygon.word.empty()               ? "--word"
                             : polygon.repeat                      ? "--repeat"
                             : polygon.ends == EndsOption::Closed  ? "--closed"
                             : polygon.ends == EndsOption::Open    ? "--open"
                             : polygon.ends == EndsOption::Clamped ? "--clamped"
                             : options.limit                       ? "--limit"
                             : options.derivatives                 ? "--derivatives"
                                                                   : nullptr;
    if (name == nullptr) return;
    throw failure(ExitCode::Usage, fmt::format("{} belongs to interval grammars", name),
                  polygon.ends != EndsOption::Unsaid ? "a point grammar says `ring` itself"
                                                     : "the rules of a point grammar say everything");
}

void refuse_point_options(const PointOptions& options) {
    const char* const name = !options.settings.empty()  ? "--set"
                             : !options.queries.empty() ? "--query"
                             : options.phase            ? "--phase"
                             : options.seed             ? "--seed"
                             : options.max_modules      ? "--max-modules"
                             : options.trace            ? "--trace"
                             : options.tree             ? "--tree"
                             : options.interpreter      ? "--interpreter"
                                                        : nullptr;
    if (name != nullptr)
        throw failure(ExitCode::Usage, fmt::format("{} belongs to point grammars", name),
                      "a text whose first statement is `points NAME`");
}

} // namespace internode::cli
