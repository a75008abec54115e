// SPDX-License-Identifier: MIT

#include "cli/intervals/contour.h"
#include "cli/intervals/curve_output.h"
#include "cli/intervals/handlers.h"
#include "cli/requests/formats.h"
#include "cli/requests/places.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "internode/io/csv.h"
#include "internode/report/json/pyramid_json.h"
#include "internode/report/picture/pyramid_picture.h"
#include "internode/report/pyramid_report.h"
#include "internode/report/text/pyramid_text.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

Pyramid kept_details(const Pyramid& pyramid, const ReverseOptions& options) {
    if (options.threshold) return thresholded(pyramid, *options.threshold);
    if (options.keep) return with_longest(pyramid, static_cast<std::size_t>(*options.keep));
    return pyramid;
}

Analysis analysis_of(const SettledContour& contour, const ReverseOptions& options, int threads) {
    constexpr std::uint64_t usual_window = 5;
    const internode::ReverseOptions left_inverse{options.local ? ReverseMethod::Local : ReverseMethod::LeastSquares,
                                                 static_cast<std::size_t>(options.window.value_or(usual_window))};
    try {
        return analyse(contour.coarse, contour.levels, contour.dimension, contour.points, left_inverse, threads);
    } catch (const std::range_error& error) {
        throw failure(ExitCode::Refused, error.what(), "clamped ends are well conditioned: --clamped");
    }
}

void write_coarse(Sink& sink, const std::string& format, const PyramidReport& report, const SettledContour& contour,
                  const Context& context) {
    const Curve& coarse = report.kept.coarse;
    if (format == "json") return write_curve(sink, coarse, context);
    CsvOptions csv;
    csv.header = contour.columns.empty() ? coordinate_names(coarse.dimension()) : contour.columns;
    csv.threads = context.apply.threads;
    write_csv(sink, {coarse.dimension(), coarse.points()}, csv);
}

/// What a user must know even when the table goes nowhere.
void say_what_was_done(const PyramidReport& report, bool table_is_shown, const Context& context) {
    const std::string warning = loose_ends_warning(report);
    if (!warning.empty() && !context.quiet) say(context, "warning: " + warning + '\n');
    if (!table_is_shown && (report.fitting.fit != Fit::AsMeasured || report.fitting.clamped) && !context.quiet)
        say(context, fmt::format("{}: {}\n", report.source, to_string(report.fitting)));
}

} // namespace

ExitCode run(const IntervalGrammar& grammar, const LoadedText&, const ReverseOptions& options, const Context& context) {
    const std::string format = settled_format(context, options.output, {"reverse", Kind::Intervals, ""});
    require_polygon(options.polygon);
    const std::string coarse_format = chosen_format({options.coarse, {}}, {"reverse", Kind::Intervals, "--coarse"});
    (void)chosen_format({options.picture, {}}, {"reverse", Kind::Intervals, "--picture"});
    const IntervalSystem system = load_system(grammar, options.grammar);
    const SettledContour contour = load_contour(system, options);
    if (options.unclamped && contour.coarse.ends() == Ends::Circular)
        throw failure(ExitCode::Usage, "--unclamped belongs to open curves", "a circular word has no ends to clamp");
    Output output(options.output.file);
    std::optional<Output> coarse;
    std::optional<Output> picture;
    if (!options.coarse.empty()) coarse.emplace(options.coarse);
    if (!options.picture.empty()) picture.emplace(options.picture);
    Analysis analysis = analysis_of(contour, options, context.apply.threads);
    Pyramid kept = kept_details(analysis.pyramid, options);
    const PyramidReport report =
        pyramid_report(std::move(analysis), std::move(kept), contour.fitting, contour.source, context.apply.threads);
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
