// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/intervals/contour.h"
#include "cli/intervals/curve_output.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "cli/arguments/places.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/io/csv.h"
#include "internode/report/pyramid_report.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

Pyramid kept_details(const Pyramid& pyramid, const ReverseOptions& options) {
    if (options.threshold) return thresholded(pyramid, *options.threshold);
    if (options.keep) return with_longest(pyramid, static_cast<std::size_t>(*options.keep));
    return pyramid;
}

Analysis analysis_of(const LoadedContour& contour, const ReverseOptions& options) {
    constexpr std::uint64_t usual_window = 5;
    const internode::ReverseOptions left_inverse{options.local ? ReverseMethod::Local : ReverseMethod::LeastSquares,
                                                 static_cast<std::size_t>(options.window.value_or(usual_window))};
    try {
        return analyse(contour.coarse, contour.levels, contour.dimension, contour.points, left_inverse);
    } catch (const std::range_error& error) {
        throw failure(ExitCode::Refused, error.what(), "clamped ends are well conditioned: --clamped");
    }
}

void write_coarse(Sink& sink, const std::string& format, const PyramidReport& report, const LoadedContour& contour,
                  const Context& context) {
    const Curve& coarse = report.kept.coarse;
    if (format == "json") return write_curve(sink, coarse, context);
    CsvOptions csv;
    csv.header = contour.columns.empty() ? coordinate_names(coarse.dimension()) : contour.columns;
    write_csv(sink, {coarse.dimension(), coarse.points()}, csv);
}

/// What a user must know even when the table goes nowhere.
void say_what_was_done(const PyramidReport& report, bool table_is_shown, const Context& context) {
    const std::string warning = loose_ends_warning(report);
    if (!warning.empty()) say(context, "warning: " + warning + '\n');
    if (!table_is_shown && (report.fitting.fit != Fit::AsMeasured || report.fitting.clamped) && !context.quiet)
        say(context, fmt::format("{}: {}\n", report.source, to_string(report.fitting)));
}

void refuse_point_options(const ReverseOptions& options) {
    const char* const name = options.rules               ? "--rules"
                             : options.phase             ? "--phase"
                             : !options.settings.empty() ? "--set"
                                                         : nullptr;
    if (name != nullptr)
        throw failure(ExitCode::Usage, fmt::format("{} belongs to point grammars", name),
                      "a text whose first statement is `points NAME`");
}

} // namespace

ExitCode run(const ReverseOptions& options, const Context& context) {
    const LoadedText grammar = load_grammar_text(options.grammar);
    if (kind_of(grammar.text) == GrammarKind::Points) return reverse_points(grammar, options, context);
    refuse_point_options(options);
    require_polygon(options.polygon);
    const std::string format = chosen_format(options.output, {"text", "json"}, "text");
    const std::string coarse_format = chosen_format({options.coarse, {}}, {"csv", "json"}, "csv");
    (void)chosen_format({options.picture, {}}, {"svg"}, "svg");
    const IntervalSystem system = load_system(grammar, options.grammar);
    const LoadedContour contour = load_contour(system, options);
    Output output(options.output.file);
    std::optional<Output> coarse;
    std::optional<Output> picture;
    if (!options.coarse.empty()) coarse.emplace(options.coarse);
    if (!options.picture.empty()) picture.emplace(options.picture);
    Analysis analysis = analysis_of(contour, options);
    Pyramid kept = kept_details(analysis.pyramid, options);
    const PyramidReport report = pyramid_report(std::move(analysis), std::move(kept), contour.fitting, contour.source);
    say_what_was_done(report, format == "text", context);
    output.sink().write(format == "json" ? pyramid_json(report, generator(context)) : pyramid_text(report));
    output.commit();
    if (coarse) {
        write_coarse(coarse->sink(), coarse_format, report, contour, context);
        coarse->commit();
    }
    if (picture) {
        picture->sink().write(pyramid_picture(report, generator(context)));
        picture->commit();
    }
    return ExitCode::Success;
}

} // namespace internode::cli
