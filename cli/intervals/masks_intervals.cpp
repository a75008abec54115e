// SPDX-License-Identifier: MIT

#include "cli/intervals/handlers.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "internode/curve/knots.h"
#include "internode/io/matrix/matrix_market.h"
#include "internode/report/code/automaton_code.h"
#include "internode/report/json/automaton_json.h"
#include "internode/report/json/masks_json.h"
#include "internode/report/picture/graph_dot.h"
#include "internode/report/picture/graph_picture.h"
#include "internode/report/text/masks_text.h"
#include "internode/stencil/step_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace internode::cli {
namespace {

/// Refuses a word that no curve of this degree can have, with the numbers.
void check_fits(const IntervalSystem& system, int degree, const Axiom& axiom, const std::string& origin) {
    assert(degree >= 1);
    const auto d = static_cast<std::size_t>(degree);
    const bool open = axiom.ends == Ends::Open;
    if (open && axiom.word.size() < 2 * d + 1)
        throw failure(ExitCode::Refused, fmt::format("{} has {} letters; an open word of degree {} has at least {}",
                                                     origin, axiom.word.size(), d, 2 * d + 1));
    const CheckedKnots checked = make_knots(system, {degree, axiom.ends, axiom.word});
    if (!checked.knots) throw failure(ExitCode::Refused, fmt::format("{}: {}", origin, checked.problems.front()));
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

/// Words, windows or states, and their exact work, whose size -v says before it starts.
ExactLimits limits_of(const Context& context) {
    ExactLimits limits(max_table_words);
    if (context.verbose)
        limits.announce = [&context](std::uint64_t work) {
            say(context, fmt::format("{} units of exact work\n", work));
        };
    return limits;
}

/// The automaton of --word, else of the axiom, else of the words that persist (or of all).
AutomatonExport automaton_of(const IntervalSystem& system, const std::string& name, const MasksOptions& options,
                             const Context& context) {
    const WordChoice choice = options.all ? WordChoice::All : WordChoice::Default;
    if (options.word.empty()) return export_automaton(name, system, options.degree, choice, limits_of(context));
    const Axiom word = load_word(options.word, system.alphabet()).axiom;
    check_fits(system, options.degree, word, "--word");
    return export_automaton(name, system, options.degree, word, limits_of(context));
}

/// The same of so many steps at once.
AutomatonExport chosen_automaton(const IntervalSystem& once, const MasksOptions& options, const Context& context) {
    const IntervalSystem system = several_steps(once, options.steps);
    std::string name = display_name(once.grammar(), options.grammar);
    if (options.steps > 1) name = fmt::format("{}^{}", name, options.steps);
    AutomatonExport automaton = automaton_of(system, name, options, context);
    automaton.steps = options.steps;
    return automaton;
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

/// All that a writer of masks needs.
struct MasksJob {
    const IntervalSystem& system;
    const MasksOptions& options;
    const Context& context;

    [[nodiscard]] WordChoice choice() const { return options.all ? WordChoice::All : WordChoice::Default; }
    [[nodiscard]] MaskTable table() const {
        return make_mask_table(system, options.degree, choice(), limits_of(context));
    }
    [[nodiscard]] FactorGraph graph() const {
        return word_graph(system, static_cast<std::size_t>(options.degree) + 1, choice(), max_table_words);
    }
};

void write_masks_text(Sink& sink, const MasksJob& job) {
    sink.write(masks_text(job.table()));
}

void write_masks_json(Sink& sink, const MasksJob& job) {
    sink.write(masks_json(job.table(), generator(job.context)));
}

void write_matrix(Sink& sink, const MasksJob& job) {
    write_matrix(sink, job.system, job.options, job.context);
}

void write_dot(Sink& sink, const MasksJob& job) {
    sink.write(graph_dot(job.graph(), job.system.alphabet(), generator(job.context)));
}

void write_picture(Sink& sink, const MasksJob& job) {
    sink.write(picture(job.graph(), job.system, job.options, job.context));
}

void write_automaton_json(Sink& sink, const MasksJob& job) {
    sink.write(automaton_json(chosen_automaton(job.system, job.options, job.context), generator(job.context)));
}

void write_c(Sink& sink, const MasksJob& job) {
    sink.write(automaton_c(chosen_automaton(job.system, job.options, job.context), generator(job.context)));
}

void write_glsl(Sink& sink, const MasksJob& job) {
    sink.write(automaton_glsl(chosen_automaton(job.system, job.options, job.context), generator(job.context)));
}

using Writers = std::vector<FormatWriter<void (*)(Sink&, const MasksJob&)>>;

const Writers& mask_writers() {
    static const Writers table{{"text", write_masks_text}, {"json", write_masks_json}, {"mtx", write_matrix},
                               {"dot", write_dot},         {"svg", write_picture},     {"c", write_c},
                               {"glsl", write_glsl}};
    return table;
}

const Writers& automaton_writers() {
    static const Writers table{{"json", write_automaton_json}, {"c", write_c}, {"glsl", write_glsl}};
    return table;
}

} // namespace

ExitCode run(const IntervalGrammar& grammar, const LoadedText&, const MasksOptions& options, const Context& context) {
    const std::string format =
        settled_format(context, options.output, {"masks", Kind::Intervals, ""}, options.automaton ? "json" : "text");
    if (options.degree == 0)
        throw failure(ExitCode::Usage, "-d is needed: the degree of the B-spline", "for example -d 2");
    const IntervalSystem system = load_system(grammar, options.grammar);
    if (system.grammar().axiom && !options.all && options.word.empty())
        check_fits(system, options.degree, *system.grammar().axiom, "the axiom");
    Output output(options.output.file);
    const auto write = writer_of(options.automaton ? automaton_writers() : mask_writers(), format);
    write(output.sink(), {system, options, context});
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
