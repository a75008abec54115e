// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/points/compiled_points.h"
#include "cli/shell/output.h"
#include "cli/points/picture_axes.h"
#include "cli/arguments/point_options.h"
#include "cli/points/point_output.h"
#include "cli/points/point_run.h"
#include "internode/text/diagnostic.h"

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

std::string point_format(const SubdivideOptions& options, const PointSystem& system) {
    if (options.point.trace && options.point.tree)
        throw failure(ExitCode::Usage, "--trace and --tree exclude each other");
    if (options.point.trace) return chosen_format(options.output, {"text"}, "text");
    if (options.point.tree) return chosen_format(options.output, {"svg"}, "svg");
    return chosen_format(options.output, {"csv", "json", "npy", "obj", "svg", "text"},
                         has_points(system) ? "csv" : "text");
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

/// By the automaton where there is one; the interpreter is the reference.
ModuleWord final_word(const LoadedPoints& loaded, const SubdivideOptions& options, const Context& context) {
    if (options.point.interpreter || options.steps == 0 || options.steps > max_compiled_cycles)
        return derived_word(loaded, options.steps);
    refuse_growth(loaded, options.steps);
    const CompiledPoints compiled = compiled_points(loaded);
    if (!compiled.grammar) {
        if (context.verbose) say(context, fmt::format("interpreted: {}\n", printable(compiled.reason)));
        return derived_word(loaded, options.steps);
    }
    std::optional<ModuleWord> word = compiled_word(compiled, loaded, options.steps, context);
    return word ? *std::move(word) : derived_word(loaded, options.steps);
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
    const CompiledPoints compiled = compiled_points(loaded);
    if (compiled.grammar)
        text += fmt::format("compiled to {} states, {} rows\n", compiled.grammar->automaton().state_count(),
                            compiled.grammar->automaton().row_count());
    else
        text += fmt::format("interpreted: {}\n", printable(compiled.reason));
    write_output("-", text);
    return ExitCode::Success;
}

} // namespace

ExitCode subdivide_points(const LoadedText& grammar, const SubdivideOptions& options, const Context& context) {
    refuse_curve_options(options);
    if (options.steps > max_cycles) throw failure(ExitCode::Refused, fmt::format("more than {} cycles", max_cycles));
    const LoadedPoints loaded = load_points(grammar, options);
    const std::string format = point_format(options, loaded.system);
    if (options.plan) return plan_points(loaded, options);
    Output output(options.output.file);
    write_result(output.sink(), format, loaded, options, context);
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
