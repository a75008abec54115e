// SPDX-License-Identifier: MIT

#include "cli/points/handlers.h"
#include "cli/points/point_system.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "internode/io/matrix/fraction_matrix.h"
#include "internode/io/matrix/matrix_market.h"
#include "internode/point/compile/grammar_mask.h"
#include "internode/report/code/cells_code.h"
#include "internode/report/json/point_masks_json.h"
#include "internode/report/text/point_masks_text.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

constexpr std::size_t usual_dimension = 2; ///< masks are the same in all
constexpr std::uint64_t usual_points = 8;

std::size_t points_of(const MasksOptions& options) {
    const std::uint64_t points = options.points.value_or(usual_points);
    if (points >= 1 && points <= max_matrix_points) return static_cast<std::size_t>(points);
    throw failure(ExitCode::Usage, fmt::format("--points {} is not from 1 to {}", points, max_matrix_points));
}

Failure stopped(const LoadedText& text, const ExactStop& stop) {
    return {ExitCode::Refused, to_string(diagnostic_of(text, stop.place, stop.reason, {}))};
}

RationalMatrix matrix_of(const LoadedText& text, const PointSystem& system, std::size_t points) {
    const std::variant<RationalMatrix, ExactStop> result = point_matrix(system, points);
    if (const auto* stop = std::get_if<ExactStop>(&result)) throw stopped(text, *stop);
    return std::get<RationalMatrix>(result);
}

CellExport cells_of(const LoadedText& text, const PointSystem& system, const std::string& name, std::size_t points,
                    const Context& context) {
    Compilation compilation = compile(system, {points});
    if (!compilation.compiled) throw stopped(text, compilation.reasons.front());
    return {name, system.grammar().ring, *std::move(compilation.compiled), generator(context)};
}

/// Weights rounded to doubles: MatrixMarket knows no fractions.
void write_rounded(Sink& sink, const RationalMatrix& matrix, const Context& context) {
    std::vector<MatrixEntry> entries;
    for (std::size_t row = 0; row < matrix.rows.size(); ++row)
        for (const RationalEntry& entry : matrix.rows[row])
            entries.push_back({row, entry.column, to_double(entry.value)});
    const std::vector<std::string> comments{fmt::format("internode {}", generator(context).version),
                                            context.command_line, "one cycle: new points = matrix * old points"};
    write_matrix_market(sink, {matrix.rows.size(), matrix.columns, entries}, comments);
}

} // namespace

ExitCode run(const PointGrammar& grammar, const LoadedText& text, const MasksOptions& options, const Context& context) {
    const std::string format =
        settled_format(context, options.output, {"masks", Kind::Points, options.automaton ? "--automaton" : ""});
    const std::size_t points = points_of(options);
    const PointSystem system = load_point_system(grammar, text, options.settings, usual_dimension);
    const std::string name = display_name(system.grammar().name, options.grammar);
    Output output(options.output.file);
    if (format == "c" || format == "glsl" || options.automaton) {
        const CellExport cells = cells_of(text, system, name, points, context);
        output.sink().write(format == "c" ? cells_c(cells) : format == "glsl" ? cells_glsl(cells) : cells_json(cells));
    } else {
        const RationalMatrix matrix = matrix_of(text, system, points);
        const PointMasks masks{name, system.grammar().ring, matrix, uniform_mask(system), generator(context)};
        if (format == "mtx")
            write_rounded(output.sink(), matrix, context);
        else if (format == "csv")
            write_fraction_csv(output.sink(), matrix);
        else
            output.sink().write(format == "json" ? point_masks_json(masks) : point_masks_text(masks));
    }
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
