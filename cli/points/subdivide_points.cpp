// SPDX-License-Identifier: MIT

#include "cli/points/handlers.h"
#include "cli/points/point_output.h"
#include "cli/points/point_run.h"
#include "cli/points/point_system.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "cli/shell/parts.h"
#include "cli/shell/picture_axes.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/point/check/affine.h"
#include "internode/point/compile/fast_derivation.h"
#include "internode/point/growth.h"
#include "internode/text/diagnostic.h"
#include "internode/text/limits.h"
#include "internode/text/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace internode::cli {

namespace {

using Parts = std::vector<LoadedPoints>;

/// Whether some letter of the interpreted word can have a point.
bool has_points(const LoadedPoints& loaded) {
    const PointSystem& system = *loaded.system;
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

std::string point_format(const SubdivideOptions& options, const Parts& parts, const Context& context) {
    if (options.point.trace && options.point.tree)
        throw failure(ExitCode::Usage, "--trace and --tree exclude each other");
    const char* const output = options.point.trace ? "--trace" : options.point.tree ? "--tree" : "";
    const char* const usual = std::ranges::any_of(parts, has_points) || *output != '\0' ? "" : "text";
    return settled_format(context, options.output, {"subdivide", Kind::Points, output}, usual);
}

std::string title(const Parts& parts, std::uint64_t cycles) {
    const LoadedPoints& first = parts.front();
    const std::string count = parts.size() > 1 ? fmt::format(" ({} parts)", parts.size()) : "";
    return fmt::format("{}{} under {}, {} {}", first.start, count, first.name, cycles,
                       cycles == 1 ? "cycle" : "cycles");
}

bool is_empty(const PointStrands& strands) {
    return strands.size() == 0 && strands.lines.empty();
}

/// The fewest coordinates of points that are no mere numbers; 1 where all are.
std::size_t least_dimension(const std::vector<PictureLevel>& levels) {
    std::size_t least = max_dimension + 1;
    for (const PictureLevel& level : levels)
        for (const PointStrands& part : level.parts)
            if (part.dimension > 1) least = std::min(least, part.dimension);
    return least > max_dimension ? 1 : least;
}

/// No panel shows numbers beside points.
void check_plane(const PictureLevel& level) {
    std::optional<std::size_t> first;
    for (const PointStrands& part : level.parts)
        if (!is_empty(part)) {
            require_one_plane(first.value_or(part.dimension), part.dimension);
            first = part.dimension;
        }
}

std::string levels_svg(Parts& parts, const SubdivideOptions& options, const Context& context) {
    LevelsPicture picture;
    picture.levels = all_levels(parts, options.steps);
    std::erase_if(picture.levels, [](const PictureLevel& level) { return std::ranges::all_of(level.parts, is_empty); });
    if (picture.levels.empty())
        throw failure(ExitCode::Refused, "no word has a point that could be drawn", "--tree draws the derivation");
    for (PictureLevel& level : picture.levels)
        for (std::size_t i = 0; i < parts.size(); ++i) project(level.parts[i], parts[i]);
    for (const PictureLevel& level : picture.levels) check_plane(level);
    picture.axes = chosen_axes(options.axes, least_dimension(picture.levels));
    picture.has_control = !options.polygon.place.empty() && picture.levels.front().number == 0;
    picture.title = title(parts, options.steps);
    picture.generator = generator(context);
    return levels_picture(picture);
}

std::string tree_svg(const Parts& parts, const SubdivideOptions& options, const Context& context) {
    refuse_several(parts.size(), "a tree");
    DerivationTree tree = all_steps(parts.front(), options.steps);
    tree.title = "Derivation of " + title(parts, options.steps);
    tree.generator = generator(context);
    return derivation_tree(tree, *parts.front().system);
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
    const std::string part = loaded.part > 0 ? fmt::format(" of part {}", loaded.part) : "";
    return failure(ExitCode::Refused,
                   fmt::format("after {} cycles the word{} would have {} modules and {} points of {} coordinates; {} "
                               "modules are allowed",
                               cycles, part, word.size.modules, word.size.points, word.dimension,
                               loaded.derive.max_modules),
                   "fewer cycles, or a larger --max-modules");
}

/// The word after all cycles, before its interpretation.
ModuleWord final_word(const LoadedPoints& loaded, const SubdivideOptions& options, bool& told_why,
                      const Context& context) {
    FastDerivation derived = derive_fast(*loaded.system, {loaded.word, start_of(loaded)}, options.steps,
                                         {loaded.derive, context.apply, options.point.interpreter});
    if (derived.interpreted && context.verbose && !std::exchange(told_why, true))
        say(context, told(loaded, *derived.interpreted));
    if (derived.problem) throw derivation_failure(loaded, *derived.problem);
    if (derived.too_large) throw too_large(*derived.too_large, loaded, options.steps);
    return std::move(derived.word).value();
}

/// What `take` makes of the final word of each part, in their order.
template<class Take>
void take_words(Parts& parts, const SubdivideOptions& options, const Context& context, const Take& take) {
    const bool is_fast = !options.point.interpreter && options.steps != 0 && options.steps <= max_compiled_cycles;
    if (is_fast || parts.size() > 1) refuse_growth(parts, options.steps);
    bool told_why = false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const ModuleWord word = final_word(parts[i], options, told_why, context);
        take(parts[i], word);
        take_modules(parts, i, word.size());
    }
}

/// A block of lines for each part, blank lines between.
void write_traces(Sink& sink, Parts& parts, std::uint64_t cycles) {
    refuse_growth(parts, cycles);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) sink.write("\n");
        take_modules(parts, i, write_trace(sink, parts[i], cycles));
    }
}

/// A line for the word of each part.
std::string words_text(Parts& parts, const SubdivideOptions& options, const Context& context) {
    std::string text;
    take_words(parts, options, context,
               [&](const LoadedPoints& loaded, const ModuleWord& word) { text += word_text(loaded, word); });
    return text;
}

void write_result(Sink& sink, const std::string& format, Parts& parts, const SubdivideOptions& options,
                  const Context& context) {
    if (options.point.trace) return write_traces(sink, parts, options.steps);
    if (options.point.tree || format == "svg") {
        sink.write(options.point.tree ? tree_svg(parts, options, context) : levels_svg(parts, options, context));
        return;
    }
    if (format == "text") {
        sink.write(words_text(parts, options, context));
        return;
    }
    if (format == "npy") refuse_several(parts.size(), format);
    std::vector<DrawnPart> drawings;
    take_words(parts, options, context, [&](const LoadedPoints& loaded, const ModuleWord& word) {
        drawings.push_back(drawn_part(drawn(loaded, word), loaded, format));
    });
    write_points(sink, format, drawings, options.steps, context);
}

/// The automata that the words of all parts are derived with, or why the interpreter runs.
std::string planned_automata(const Parts& parts) {
    std::size_t states = 0;
    std::size_t rows = 0;
    for (const LoadedPoints& loaded : parts) {
        const Compilation compilation = compile_derivation(*loaded.system, start_of(loaded), loaded.derive);
        if (!compilation.compiled) return told(loaded, compilation.reasons.front());
        states += compilation.compiled->automaton().state_count();
        rows += compilation.compiled->automaton().row_count();
    }
    return fmt::format("compiled to {} states, {} rows\n", states, rows);
}

/// What --plan says; nothing is derived.
ExitCode plan_points(const Parts& parts, const SubdivideOptions& options) {
    if (options.output.file != "-") throw failure(ExitCode::Usage, "--plan writes no file: leave -o out");
    const LoadedPoints& first = parts.front();
    const std::uint64_t most = first.derive.max_modules;
    const auto modules = predicted_modules(parts, options.steps, most);
    std::string length = "not known beforehand";
    if (modules) length = *modules > most ? fmt::format("more than {}", most) : std::to_string(*modules);
    write_output("-", fmt::format("modules {}\nsteps {}\n{}", length, options.steps * first.system->cycle().size(),
                                  planned_automata(parts)));
    return ExitCode::Success;
}

/// A curve whose points are no affine combinations does not move with its polygon: one line says so.
void warn_of_sums(const LoadedPoints& loaded, const Context& context) {
    if (context.quiet) return;
    const std::vector<AffineFinding> wrong = wrong_sums(*loaded.system);
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
    Parts parts = load_points(grammar, text, options);
    const std::string format = point_format(options, parts, context);
    warn_of_sums(parts.front(), context);
    if (options.plan) return plan_points(parts, options);
    Output output(options.output.file);
    write_result(output.sink(), format, parts, options, context);
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
