// SPDX-License-Identifier: MIT

#include "cli/points/handlers.h"
#include "cli/points/point_output.h"
#include "cli/points/point_run.h"
#include "cli/points/point_system.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "cli/shell/picture_axes.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/point/check/affine.h"
#include "internode/point/compile/fast_derivation.h"
#include "internode/point/growth.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {

namespace {

/// Whether some letter of the interpreted word can have a point.
bool has_points(const PointSystem& system) {
    const Layout& layout = system.layout(system.grammar().interpretations.size());
    return std::ranges::any_of(layout, [](const std::optional<std::vector<Extent>>& extents) {
        return extents && std::ranges::any_of(*extents, [](Extent extent) { return extent > 0; });
    });
}

/// Options that only some grammars can answer.
void refuse_unanswered(const PointOptions& options, const PointGrammar& grammar) {
    const bool stochastic =
        std::ranges::any_of(grammar.rules, [](const PointRule& rule) { return rule.weight.has_value(); });
    if (options.seed && !stochastic)
        throw failure(ExitCode::Usage, "--seed: no rule of the grammar has a weight",
                      "`weight` makes a rule stochastic");
    const bool parted =
        std::ranges::any_of(grammar.rules, [](const PointRule& rule) { return rule.predecessor.size() > 1; });
    if (options.phase && !grammar.ring && !parted)
        throw failure(ExitCode::Usage, "--phase: no rule of the grammar takes several modules at once",
                      "in rings it turns the word, too");
}

std::string point_format(const SubdivideOptions& options, const PointSystem& system, const Context& context) {
    if (options.point.trace && options.point.tree)
        throw failure(ExitCode::Usage, "--trace and --tree exclude each other");
    const char* const output = options.point.trace ? "--trace" : options.point.tree ? "--tree" : "";
    const char* const usual = has_points(system) || *output != '\0' ? "" : "text";
    return settled_format(context, options.output, {"subdivide", Kind::Points, output}, usual);
}

std::string title(const LoadedPoints& loaded, std::uint64_t cycles) {
    return fmt::format("{} under {}, {} {}", loaded.start, loaded.name, cycles, cycles == 1 ? "cycle" : "cycles");
}

std::string levels_svg(const LoadedPoints& loaded, const SubdivideOptions& options, const Context& context) {
    LevelsPicture picture;
    picture.levels = all_levels(loaded, options.steps);
    std::erase_if(picture.levels,
                  [](const PictureLevel& level) { return level.strands.size() == 0 && level.strands.lines.empty(); });
    if (picture.levels.empty())
        throw failure(ExitCode::Refused, "no word has a point that could be drawn", "--tree draws the derivation");
    for (PictureLevel& level : picture.levels) project(level.strands, loaded);
    picture.axes = chosen_axes(options.axes, picture.levels.front().strands.dimension);
    picture.has_control = !options.polygon.place.empty() && picture.levels.front().number == 0;
    picture.title = title(loaded, options.steps);
    picture.generator = generator(context);
    return levels_picture(picture);
}

std::string tree_svg(const LoadedPoints& loaded, const SubdivideOptions& options, const Context& context) {
    DerivationTree tree = all_steps(loaded, options.steps);
    tree.title = "Derivation of " + title(loaded, options.steps);
    tree.generator = generator(context);
    return derivation_tree(tree, loaded.system);
}

/// Why the interpreter runs, with its line.
std::string told(const LoadedPoints& loaded, const ExactStop& stop) {
    std::string reason = stop.reason;
    if (stop.place.bytes > 0) {
        const Diagnostic place = diagnostic_at(loaded.text.text, loaded.text.source, stop.place, {}, {});
        reason = fmt::format("line {}: {}", place.line, stop.reason);
    }
    return fmt::format("interpreted: {}\n", printable(reason));
}

Failure too_large(const TooLargeWord& word, const LoadedPoints& loaded, std::uint64_t cycles) {
    return failure(ExitCode::Refused,
                   fmt::format("after {} cycles the word would have {} modules and {} points of {} coordinates; {} "
                               "modules are allowed",
                               cycles, word.size.modules, word.size.points, word.dimension, loaded.derive.max_modules),
                   "fewer cycles, or a larger --max-modules");
}

/// The word after all cycles, before its interpretation.
ModuleWord final_word(const LoadedPoints& loaded, const SubdivideOptions& options, const Context& context) {
    const bool is_fast = !options.point.interpreter && options.steps != 0 && options.steps <= max_compiled_cycles;
    if (is_fast) refuse_growth(loaded, options.steps);
    FastDerivation derived = derive_fast(loaded.system, {loaded.word, start_of(loaded)}, options.steps,
                                         {loaded.derive, {context.threads, context.isa}, options.point.interpreter});
    if (derived.interpreted && context.verbose) say(context, told(loaded, *derived.interpreted));
    if (derived.problem) throw derivation_failure(loaded, *derived.problem);
    if (derived.too_large) throw too_large(*derived.too_large, loaded, options.steps);
    return std::move(derived.word).value();
}

void write_result(Sink& sink, const std::string& format, const LoadedPoints& loaded, const SubdivideOptions& options,
                  const Context& context) {
    if (options.point.trace)
        write_trace(sink, loaded, options.steps);
    else if (options.point.tree)
        sink.write(tree_svg(loaded, options, context));
    else if (format == "svg")
        sink.write(levels_svg(loaded, options, context));
    else if (format == "text")
        write_word(sink, loaded, final_word(loaded, options, context));
    else
        write_points(sink, format, drawn(loaded, final_word(loaded, options, context)), loaded, options.steps, context);
}

/// What --plan says; nothing is derived.
ExitCode plan_points(const LoadedPoints& loaded, const SubdivideOptions& options) {
    if (options.output.file != "-") throw failure(ExitCode::Usage, "--plan writes no file: leave -o out");
    const std::uint64_t most = loaded.derive.max_modules;
    const auto modules = predicted_length(loaded.system, loaded.word, options.steps, most);
    std::string length = "not known beforehand";
    if (modules) length = *modules > most ? fmt::format("more than {}", most) : std::to_string(*modules);
    std::string text = fmt::format("modules {}\nsteps {}\n", length, options.steps * loaded.system.cycle().size());
    const Compilation compilation = compile_derivation(loaded.system, start_of(loaded), loaded.derive);
    if (compilation.compiled)
        text += fmt::format("compiled to {} states, {} rows\n", compilation.compiled->automaton().state_count(),
                            compilation.compiled->automaton().row_count());
    else
        text += told(loaded, compilation.reasons.front());
    write_output("-", text);
    return ExitCode::Success;
}

/// A curve whose points are no affine combinations does not move with its polygon: one line says so.
void warn_of_sums(const LoadedPoints& loaded, const Context& context) {
    if (context.quiet) return;
    const std::vector<AffineFinding> wrong = wrong_sums(loaded.system);
    if (wrong.empty()) return;
    const Diagnostic at = diagnostic_of(loaded.text, wrong.front().place, {}, {});
    const std::string where = at.line > 0 ? fmt::format("{}:{}:{}", at.source, at.line, at.column) : at.source;
    const std::string more = wrong.size() > 1 ? fmt::format(", and {} more like it", wrong.size() - 1) : "";
    say(context, fmt::format("warning: {}: the coefficients of a point sum to {}, not to 1{}; see `internode "
                             "validate`\n",
                             printable(where), printable(wrong.front().sum), more));
}

} // namespace

ExitCode run(const PointGrammar& grammar, const LoadedText& text, const SubdivideOptions& options,
             const Context& context) {
    refuse_foreign_options(context.given, Kind::Points);
    if (options.steps > max_cycles) throw failure(ExitCode::Refused, fmt::format("more than {} cycles", max_cycles));
    refuse_unanswered(options.point, grammar);
    const LoadedPoints loaded = load_points(grammar, text, options);
    const std::string format = point_format(options, loaded.system, context);
    warn_of_sums(loaded, context);
    if (options.plan) return plan_points(loaded, options);
    Output output(options.output.file);
    write_result(output.sink(), format, loaded, options, context);
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
