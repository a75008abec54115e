// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/shell/output.h"
#include "cli/arguments/places.h"
#include "cli/points/point_system.h"
#include "cli/intervals/polygon.h"
#include "internode/grammar/points/print_points.h"
#include "internode/io/csv.h"
#include "internode/point/compile/grammar_mask.h"
#include "internode/point/interpreter.h"
#include "internode/report/picture/reversal_picture.h"
#include "internode/report/reversal_report.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {
namespace {

/// Beyond, a scheme of arity 1 would be undone for ever.
constexpr std::uint64_t max_levels = 100'000;

void refuse_interval_options(const ReverseOptions& options) {
    const PolygonOptions& polygon = options.polygon;
    const char* const name = polygon.degree                       ? "-d"
                             : !polygon.word.empty()              ? "--word"
                             : polygon.repeat                     ? "--repeat"
                             : polygon.ends != EndsOption::Unsaid ? "--closed, --open or --clamped"
                             : options.threshold                  ? "--threshold"
                             : options.keep                       ? "--keep"
                             : options.unclamped                  ? "--unclamped"
                                                                  : nullptr;
    if (name != nullptr)
        throw failure(ExitCode::Usage, fmt::format("{} belongs to interval grammars", name),
                      "the rules of a point grammar say everything");
}

/// How a grammar is undone: by a derived rule, or by its own rules when it reduces.
struct WayBack {
    PointSystem system;
    std::string name;
    std::optional<UniformMask> mask;
    std::optional<ReverseRule> rule;
    std::size_t arity = 1; ///< points that become one; 1 when the rules do not say it plainly
};

/// The common number of strict predecessors of rules that make one point each; 1 when there is none.
std::size_t own_arity(const PointGrammar& grammar) {
    const std::size_t arity = grammar.rules.front().predecessor.size();
    const bool plain = std::ranges::all_of(grammar.rules, [arity](const PointRule& rule) {
        return rule.predecessor.size() == arity && rule.successor.size() == 1;
    });
    return plain ? arity : 1;
}

bool reduces(const PointGrammar& grammar) {
    return std::ranges::any_of(grammar.rules, [](const PointRule& rule) { return rule.predecessor.size() > 1; });
}

/// The rule of a window of at least --window fine points.
ReverseRule derived_rule(const UniformMask& mask, const std::string& name, const ReverseOptions& options) {
    const std::optional<ReverseRule> narrowest = reverse_rule(mask);
    if (!narrowest)
        throw failure(
            ExitCode::Refused,
            fmt::format("`{}` has no local reverse rule: its new points do not determine the old ones", name));
    const std::size_t size = narrowest->weights.size();
    const std::uint64_t asked = options.window.value_or(size);
    if (asked <= size) return *narrowest;
    return reverse_rule(mask, (static_cast<std::size_t>(asked) - size + 1) / 2).value();
}

WayBack way_back(const LoadedText& text, const ReverseOptions& options, std::size_t dimension) {
    PointSystem system = load_point_system(text, options.settings, dimension);
    const std::string name = printable(display_name(system.grammar().name, options.grammar));
    require_ring(system, name, "local reverse rules are for rings");
    if (reduces(system.grammar())) {
        const std::size_t arity = own_arity(system.grammar());
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
    const std::uint64_t measured = polygon.size();
    const std::uint64_t factor = points_per_coarse_point(arity, levels).value_or(0);
    Fitting fitting{.measured = polygon.size(), .points = polygon.size()};
    if (factor != 0 && measured % factor == 0) return fitting;
    const std::uint64_t below = factor == 0 ? 0 : measured / factor * factor;
    const std::uint64_t above = factor == 0 ? 0 : below + factor;
    if (option == FitOption::Refuse || above == 0 || (option == FitOption::Cut && below == 0))
        throw failure(ExitCode::Refused,
                      fmt::format("{} has {} points, which cannot become one of {} in each of {} levels",
                                  polygon.source, measured, arity, levels),
                      below == 0 ? "fewer levels: -n"
                                 : fmt::format("--cut to {}, --resample to the nearer of {} and {}, or fewer levels",
                                               below, below, above));
    const bool down = option == FitOption::Cut || (below != 0 && measured - below <= above - measured);
    fitting.points = static_cast<std::size_t>(down ? below : above);
    fitting.fit = option == FitOption::Cut ? Fit::Cut : Fit::Resampled;
    if (option == FitOption::Cut) {
        polygon.points = cut(polygon.points, polygon.dimension, fitting.points);
    } else {
        ResampledPolygon result = resampled(polygon.points, polygon.dimension, Ends::Circular, fitting.points);
        fitting.spacing = result.spacing;
        polygon.points = std::move(result.points);
    }
    return fitting;
}

/// One cycle of a grammar that reduces by itself.
ModuleWord reduced(const LoadedText& text, const WayBack& way, const ModuleWord& word, std::uint64_t phase) {
    DeriveOptions derive;
    derive.phase = word.size() == 0 ? 0 : phase % word.size();
    Derivation derived = internode::derive(way.system, word, 1, derive);
    if (!derived.problem) return std::move(derived.word);
    const DerivationProblem& problem = *derived.problem;
    throw Failure(ExitCode::Refused, to_string(diagnostic_of(text, problem.place, problem.message, problem.hint)));
}

struct Levels {
    std::vector<std::vector<double>> polygons;
    std::vector<ReversedLevel> errors;
};

Levels levels_of(const LoadedText& text, const WayBack& way, const InputPolygon& polygon, std::uint64_t levels,
                 std::uint64_t phase) {
    Levels result{{polygon.points}, {}};
    if (way.rule) {
        result.errors = reversed(*way.mask, *way.rule, polygon.points, {polygon.dimension, levels, phase});
        for (const ReversedLevel& level : result.errors) result.polygons.push_back(level.points);
        return result;
    }
    ModuleWord word = input_word(way.system, polygon.points);
    for (std::uint64_t level = 0; level < levels; ++level) {
        word = reduced(text, way, word, phase);
        PointStrands drawn = strands(word, way.system, 0);
        if (drawn.size() == 0)
            throw failure(ExitCode::Refused, fmt::format("no point is left {} levels down", level + 1));
        result.polygons.push_back(std::move(drawn.points));
    }
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

ExitCode write_rules(const LoadedText& text, const ReverseOptions& options, const Context& context) {
    (void)chosen_format(options.output, {"lsys"}, "lsys");
    const WayBack way = way_back(text, options, 2);
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

ExitCode reverse_points(const LoadedText& text, const ReverseOptions& options, const Context& context) {
    refuse_interval_options(options);
    if (options.rules) return write_rules(text, options, context);
    const std::string format = chosen_format(options.output, {"text", "json", "csv", "svg"}, "text");
    const std::string coarse_format = chosen_format({options.coarse, {}}, {"csv", "json"}, "csv");
    (void)chosen_format({options.picture, {}}, {"svg"}, "svg");
    Output output(options.output.file);
    std::optional<Output> coarse;
    std::optional<Output> drawing;
    if (!options.coarse.empty()) coarse.emplace(options.coarse);
    if (!options.picture.empty()) drawing.emplace(options.picture);
    InputPolygon polygon = reversible_polygon(options.polygon);
    const WayBack way = way_back(text, options, polygon.dimension);
    const ReversalReport report = report_of(text, way, polygon, options, context);
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
