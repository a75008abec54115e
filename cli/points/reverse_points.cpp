// SPDX-License-Identifier: MIT

#include "cli/intervals/polygon.h"
#include "cli/points/handlers.h"
#include "cli/points/point_system.h"
#include "cli/requests/formats.h"
#include "cli/requests/places.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "internode/grammar/points/print_points.h"
#include "internode/io/csv.h"
#include "internode/point/compile/grammar_mask.h"
#include "internode/point/infer/reduction.h"
#include "internode/point/interpreter.h"
#include "internode/report/json/reversal_json.h"
#include "internode/report/picture/reversal_picture.h"
#include "internode/report/text/reversal_text.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace internode::cli {
namespace {

/// How a grammar is undone: by a derived rule, or by its own rules when it reduces.
struct WayBack {
    PointSystem system;
    std::string name;
    std::optional<UniformMask> mask;
    std::optional<ReverseRule> rule;
    std::size_t arity = 1; ///< points that become one; 1 when the rules do not say it plainly
};

/// The rule of a window of at least --window fine points.
ReverseRule derived_rule(const UniformMask& mask, const std::string& name, const ReverseOptions& options) {
    const std::optional<ReverseRule> rule = reverse_rule_of_window(mask, options.window.value_or(0));
    if (!rule)
        throw failure(
            ExitCode::Refused,
            fmt::format("`{}` has no local reverse rule: its new points do not determine the old ones", name));
    return *rule;
}

WayBack way_back(const PointGrammar& grammar, const LoadedText& text, const ReverseOptions& options,
                 std::size_t dimension) {
    PointSystem system = load_point_system(grammar, text, options.settings, dimension);
    const std::string name = printable(display_name(system.grammar().name, options.grammar));
    require_ring(system, name, "local reverse rules are for rings");
    if (reduces(system.grammar())) {
        const std::size_t arity = reduced_arity(system.grammar());
        return {std::move(system), name, {}, {}, arity};
    }
    std::optional<UniformMask> mask = uniform_mask(system);
    if (!mask)
        throw failure(ExitCode::Refused,
                      fmt::format("`{}` has no mask: its rules do not do the same to every point", name),
                      "`internode validate` says why");
    ReverseRule rule = derived_rule(*mask, name, options);
    const std::size_t arity = mask->arity;
    return {std::move(system), name, std::move(mask), std::move(rule), arity};
}

/// A number of points that the arity divides at every level: as it is, below, or the nearest.
Fitting fit(InputPolygon& polygon, std::size_t arity, std::uint64_t levels, FitOption option) {
    const RingSizes sizes = ring_sizes(polygon.size(), arity, levels);
    if (!sizes.exact() &&
        (option == FitOption::Refuse || sizes.above == 0 || (option == FitOption::Cut && sizes.below == 0)))
        throw failure(ExitCode::Refused,
                      fmt::format("{} has {} points, which cannot become one of {} in each of {} levels",
                                  polygon.source, sizes.measured, arity, levels),
                      sizes.below == 0
                          ? "fewer levels: -n"
                          : fmt::format("--cut to {}, --resample to the nearer of {} and {}, or fewer levels",
                                        sizes.below, sizes.below, sizes.above));
    const bool cuts = option == FitOption::Cut;
    const std::uint64_t points = cuts ? sizes.below : sizes.nearest();
    assert(points > 0);
    FittedPolygon result = fitted(polygon.points, polygon.dimension, Ends::Circular, cuts ? Fit::Cut : Fit::Resampled,
                                  static_cast<std::size_t>(points));
    polygon.points = std::move(result.points);
    return result.fitting;
}

struct Levels {
    std::vector<std::vector<double>> polygons; ///< the fine one first
    std::vector<ReversedLevel> errors;
};

/// By a grammar that reduces by itself.
Levels reduced_levels(const LoadedText& text, const WayBack& way, const InputPolygon& polygon,
                      const ReversalOptions& options) {
    Reduction made = reduced(way.system, polygon.points, options.levels, options.phase);
    if (made.problem)
        throw Failure(ExitCode::Refused,
                      to_string(diagnostic_of(text, made.problem->place, made.problem->message, made.problem->hint)));
    if (!made.polygons.empty() && made.polygons.back().empty())
        throw failure(ExitCode::Refused, fmt::format("no point is left {} levels down", made.polygons.size()));
    made.polygons.insert(made.polygons.begin(), polygon.points);
    return {std::move(made.polygons), {}};
}

Levels levels_of(const LoadedText& text, const WayBack& way, const InputPolygon& polygon, std::uint64_t levels,
                 std::uint64_t phase) {
    const ReversalOptions options{polygon.dimension, levels, phase};
    if (!way.rule) return reduced_levels(text, way, polygon, options);
    assert(way.mask && way.mask->arity == way.rule->arity);
    Levels result{{polygon.points}, reversed(*way.mask, *way.rule, polygon.points, options)};
    for (const ReversedLevel& level : result.errors) result.polygons.push_back(level.points);
    return result;
}

/// The original and the last level of every phase, the asked one first.
std::string picture(const LoadedText& text, const WayBack& way, const InputPolygon& polygon,
                    const ReversalReport& report) {
    ReversalPicture result;
    result.title = fmt::format("{} under {}, {} {} down", report.source, report.name, report.polygons.size() - 1,
                               report.polygons.size() == 2 ? "level" : "levels");
    result.generator = report.generator;
    result.dimension = report.dimension;
    assert(!report.polygons.empty());
    result.original = report.polygons.front();
    constexpr std::uint64_t most_phases = 6;
    const std::uint64_t phases = std::min<std::uint64_t>(way.arity, most_phases);
    result.phases.push_back({report.phase, report.polygons.back()});
    for (std::uint64_t phase = 0; phase < phases; ++phase)
        if (phase != report.phase)
            result.phases.push_back(
                {phase, levels_of(text, way, polygon, report.polygons.size() - 1, phase).polygons.back()});
    return reversal_picture(result);
}

ExitCode write_rules(const PointGrammar& grammar, const LoadedText& text, const ReverseOptions& options,
                     const Context& context) {
    (void)settled_format(context, options.output, {"reverse", Kind::Points, "--rules"});
    if (!options.polygon.place.empty())
        throw failure(ExitCode::Usage, "--rules takes no polygon: the rules are the same for all");
    const WayBack way = way_back(grammar, text, options, 2);
    if (!way.rule)
        throw failure(ExitCode::Usage,
                      fmt::format("`{}` reduces by itself: its rules are the reverse rules", way.name));
    write_output(options.output.file, fmt::format("// {}\n// exact for what `{}` made, in phase 0; gain {}\n",
                                                  context.command_line, way.name, to_string(gain(*way.rule))) +
                                          print(reverse_grammar(way.system.grammar().name + " reversed", *way.rule)));
    return ExitCode::Success;
}

/// \throw Failure (Refused) for what has no place in a ring
InputPolygon reversible_polygon(const PolygonOptions& options) {
    require_polygon(options);
    InputPolygon polygon = load_polygon(options);
    if (!polygon.closed.value_or(true))
        throw failure(ExitCode::Refused,
                      fmt::format("\"closed\": false of {}; local reverse rules are for rings", polygon.source));
    if (!polygon.weights.empty())
        throw failure(ExitCode::Refused, fmt::format("{} has weights; reversing knows none", polygon.source));
    refuse_repeated_point(polygon);
    return polygon;
}

/// Fits the polygon, too.
ReversalReport report_of(const LoadedText& text, const WayBack& way, InputPolygon& polygon,
                         const ReverseOptions& options, const Context& context) {
    const std::uint64_t levels = options.levels.value_or(1);
    if (levels > max_levels) throw failure(ExitCode::Refused, fmt::format("more than {} levels", max_levels));
    ReversalReport report;
    report.fitting = fit(polygon, way.arity, levels, options.fit);
    report.source = base_name(polygon.source);
    report.name = way.name;
    report.dimension = polygon.dimension;
    report.phase = options.phase.value_or(0);
    report.rule = way.rule;
    report.generator = generator(context);
    Levels made = levels_of(text, way, polygon, levels, report.phase);
    report.polygons = std::move(made.polygons);
    report.levels = std::move(made.errors);
    return report;
}

std::string document(const std::string& format, const LoadedText& text, const WayBack& way, const InputPolygon& polygon,
                     const ReversalReport& report) {
    if (format == "json") return reversal_json(report);
    if (format == "svg") return picture(text, way, polygon, report);
    if (format == "text") return reversal_text(report);
    StringSink sink;
    CsvOptions csv;
    csv.header = polygon.columns.empty() ? coordinate_names(polygon.dimension) : polygon.columns;
    write_csv(sink, {polygon.dimension, report.polygons.back()}, csv);
    return sink.text();
}

} // namespace

ExitCode run(const PointGrammar& grammar, const LoadedText& text, const ReverseOptions& options,
             const Context& context) {
    if (options.rules) return write_rules(grammar, text, options, context);
    const std::string format = settled_format(context, options.output, {"reverse", Kind::Points, ""});
    const std::string coarse_format = chosen_format({options.coarse, {}}, {"reverse", Kind::Points, "--coarse"});
    (void)chosen_format({options.picture, {}}, {"reverse", Kind::Points, "--picture"});
    Output output(options.output.file);
    std::optional<Output> coarse;
    std::optional<Output> drawing;
    if (!options.coarse.empty()) coarse.emplace(options.coarse);
    if (!options.picture.empty()) drawing.emplace(options.picture);
    InputPolygon polygon = reversible_polygon(options.polygon);
    const WayBack way = way_back(grammar, text, options, polygon.dimension);
    const ReversalReport report = report_of(text, way, polygon, options, context);
    if (format != "text" && report.fitting.fit != Fit::AsMeasured && !context.quiet)
        say(context, fmt::format("{}: {}\n", report.source, to_string(report.fitting)));
    output.sink().write(document(format, text, way, polygon, report));
    output.commit();
    if (coarse) {
        coarse->sink().write(document(coarse_format, text, way, polygon, report));
        coarse->commit();
    }
    if (drawing) {
        drawing->sink().write(document("svg", text, way, polygon, report));
        drawing->commit();
    }
    return ExitCode::Success;
}

} // namespace internode::cli
