// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/curve/curve.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/io/matrix/matrix_market.h"
#include "internode/report/code/automaton_code.h"
#include "internode/report/json/masks_json.h"
#include "internode/report/picture/graph_dot.h"
#include "internode/report/picture/graph_picture.h"
#include "internode/report/text/masks_text.h"
#include "internode/stencil/step_matrix.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {
namespace {

/// Refuses a word that no curve of this degree can have, with the numbers.
void check_fits(const IntervalSystem& system, int degree, const Axiom& axiom, const std::string& origin) {
    const auto d = static_cast<std::size_t>(degree);
    const bool open = axiom.ends == Ends::Open;
    if (open && axiom.word.size() < 2 * d + 1)
        throw failure(ExitCode::Refused, fmt::format("{} has {} letters; an open word of degree {} has at least {}",
                                                     origin, axiom.word.size(), d, 2 * d + 1));
    const std::size_t points = open ? axiom.word.size() - d : axiom.word.size();
    const CheckedCurve checked = make_curve(system, {degree, axiom.ends, axiom.word, 1, std::vector<double>(points)});
    if (!checked.curve) throw failure(ExitCode::Refused, fmt::format("{}: {}", origin, checked.problems.front()));
}

/// The word of --matrix, known to fit the degree.
Axiom matrix_word(const IntervalSystem& system, const MasksOptions& options) {
    const std::optional<Axiom>& axiom = system.grammar().axiom;
    if (options.word.empty() && !axiom)
        throw failure(ExitCode::Refused, "the grammar has no axiom to take the matrix of",
                      "give the word of the step: --word '(LSL)' or --word 'LSLLSL'");
    if (options.word.empty()) return *axiom;
    Axiom word = load_word(options.word, system.alphabet()).axiom;
    check_fits(system, options.degree, word, "--word");
    return word;
}

void write_matrix(Sink& sink, const IntervalSystem& system, const MasksOptions& options, const Context& context) {
    const Axiom word = matrix_word(system, options);
    const StepMatrix matrix = step_matrix(system, options.degree, word.word, word.ends);
    std::vector<MatrixEntry> entries;
    entries.reserve(matrix.entries.size());
    for (const StepMatrix::Entry& entry : matrix.entries)
        entries.push_back({entry.row, entry.column, entry.weight.to_double()});
    const std::vector<std::string> comments{
        fmt::format("internode {}", generator(context).version), context.command_line,
        fmt::format("one step of degree {}: new points = matrix * old points", options.degree)};
    write_matrix_market(sink, {matrix.rows, matrix.columns, entries}, comments);
}

/// The system of `steps` steps at once, where its rules are not too long.
IntervalSystem several_steps(const IntervalSystem& system, std::uint64_t steps) {
    if (steps < 1) throw failure(ExitCode::Usage, "--steps of an automaton is at least 1");
    Word symbols;
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) symbols.push_back(to_symbol(i));
    const std::uint64_t most = std::max<std::uint64_t>(max_fused_letters, symbols.size());
    if (steps > 1 && letter_counts(system.rules(), symbols, steps, most).saturated)
        throw failure(ExitCode::Refused,
                      fmt::format("the rules of {} steps at once have more than {} letters", steps, most),
                      "fewer steps at once");
    return power(system, static_cast<int>(steps));
}

/// The automaton of --word, else of the axiom, else of the words that persist (or of all); of so many steps at once.
AutomatonExport chosen_automaton(const IntervalSystem& once, const MasksOptions& options) {
    const IntervalSystem system = several_steps(once, options.steps);
    std::string name = display_name(once.grammar(), options.grammar);
    if (options.steps > 1) name = fmt::format("{}^{}", name, options.steps);
    const WordChoice choice = options.all ? WordChoice::All : WordChoice::Default;
    if (options.word.empty()) return export_automaton(name, system, options.degree, choice, max_table_words);
    const Axiom word = load_word(options.word, system.alphabet()).axiom;
    check_fits(system, options.degree, word, "--word");
    return export_automaton(name, system, options.degree, word, max_table_words);
}

std::string automaton_text(const std::string& format, const IntervalSystem& system, const MasksOptions& options,
                           const Context& context) {
    AutomatonExport automaton = chosen_automaton(system, options);
    automaton.steps = options.steps;
    if (format == "c") return automaton_c(automaton, generator(context));
    if (format == "glsl") return automaton_glsl(automaton, generator(context));
    return automaton_json(automaton, generator(context));
}

void check_interval_options(const MasksOptions& options) {
    if (options.points || !options.settings.empty())
        throw failure(ExitCode::Usage,
                      fmt::format("{} belongs to point grammars", options.points ? "--points" : "--set"),
                      "-d says the degree");
    if (options.degree == 0)
        throw failure(ExitCode::Usage, "-d is needed: the degree of the B-spline", "for example -d 2");
}

/// The graph on a circle, or a word about its size.
std::string picture(const FactorGraph& graph, const IntervalSystem& system, const MasksOptions& options,
                    const Context& context) {
    if (graph.words.size() > max_drawn_words)
        throw failure(ExitCode::Refused,
                      fmt::format("the graph has {} words, more than the {} that fit on a circle", graph.words.size(),
                                  max_drawn_words),
                      "use --dot and Graphviz");
    const std::string title =
        fmt::format("{}, degree {}", display_name(system.grammar(), options.grammar), options.degree);
    return graph_picture(graph, system.alphabet(), title, generator(context));
}

} // namespace

ExitCode run(const MasksOptions& options, const Context& context) {
    const LoadedText grammar = load_grammar_text(options.grammar);
    if (kind_of(grammar.text) == GrammarKind::Points) return masks_points(grammar, options, context);
    check_interval_options(options);
    const std::string format = chosen_format(options.output, {"text", "json", "mtx", "dot", "svg", "c", "glsl"},
                                             options.automaton ? "json" : "text");
    const bool is_code = format == "c" || format == "glsl";
    if (options.automaton && format != "json" && !is_code)
        throw failure(ExitCode::Usage, fmt::format("--automaton has no {} form", format), "use JSON, c or glsl");
    if (options.steps != 1 && !options.automaton && !is_code)
        throw failure(ExitCode::Usage, "--steps belongs to --automaton, --format c and --format glsl");
    const IntervalSystem system = load_system(grammar, options.grammar);
    if (system.grammar().axiom && !options.all && options.word.empty())
        check_fits(system, options.degree, *system.grammar().axiom, "the axiom");
    const WordChoice choice = options.all ? WordChoice::All : WordChoice::Default;
    const auto letters = static_cast<std::size_t>(options.degree) + 1;
    Output output(options.output.file);
    if (options.automaton || is_code) {
        output.sink().write(automaton_text(format, system, options, context));
    } else if (format == "mtx") {
        write_matrix(output.sink(), system, options, context);
    } else if (format == "dot") {
        output.sink().write(
            graph_dot(word_graph(system, letters, choice, max_table_words), system.alphabet(), generator(context)));
    } else if (format == "svg") {
        output.sink().write(picture(word_graph(system, letters, choice, max_table_words), system, options, context));
    } else {
        const MaskTable table = make_mask_table(system, options.degree, choice, max_table_words);
        output.sink().write(format == "json" ? masks_json(table, generator(context)) : masks_text(table));
    }
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
