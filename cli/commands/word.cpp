// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/io/json/json_writer.h"
#include "internode/report/json/json_parts.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

Axiom start_word(const WordOptions& options, const IntervalGrammar& grammar) {
    if (!options.word.empty()) return load_word(options.word, grammar.alphabet).axiom;
    if (grammar.axiom) return *grammar.axiom;
    throw failure(ExitCode::Refused, "the grammar has no axiom", "give a word: --word 'LSL'");
}

struct RewrittenWord {
    const IntervalGrammar& grammar;
    Word word;
    LetterCounts counts;
    std::uint64_t steps = 0;
};

std::string as_text(const RewrittenWord& result) {
    std::string text = to_string(result.word, result.grammar.alphabet) + '\n';
    text += fmt::format("{} letters after {} steps\n", result.counts.total, result.steps);
    for (std::size_t i = 0; i < result.grammar.alphabet.size(); ++i)
        text += fmt::format("  {} {}\n", result.grammar.alphabet.names()[i], result.counts.symbols[i]);
    if (result.counts.zeros > 0) text += fmt::format("  0 {}\n", result.counts.zeros);
    return text;
}

void write_json(Sink& sink, const RewrittenWord& result, Ends ends, const Context& context) {
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-word", generator(context));
    json.key("steps").integer(result.steps).key("circular").boolean(ends == Ends::Circular);
    json.key("letters").integer(result.counts.total).key("counts").begin_object();
    for (std::size_t i = 0; i < result.grammar.alphabet.size(); ++i)
        json.key(result.grammar.alphabet.names()[i]).integer(result.counts.symbols[i]);
    if (result.counts.zeros > 0) json.key("0").integer(result.counts.zeros);
    json.end_object().key("word").begin_array(JsonWriter::Layout::Line);
    for (const Symbol symbol : result.word) json.string(result.grammar.alphabet.name(symbol));
    json.end_array().end_object().finish();
}

} // namespace

ExitCode run(const WordOptions& options, const Context& context) {
    const std::string format = chosen_format(options.output, {"text", "json"}, "text");
    const IntervalSystem system = load_system(options.grammar);
    const Axiom start = start_word(options, system.grammar());
    const LetterCounts counts = letter_counts(system.rules(), start.word, options.steps, options.max_letters);
    if (counts.saturated)
        throw failure(
            ExitCode::Refused,
            fmt::format("the word after {} steps has more than {} letters", options.steps, options.max_letters),
            "fewer steps, or a larger --max-letters");
    Output output(options.output.file);
    Word word = start.word;
    for (std::uint64_t step = 0; step < options.steps; ++step) word = system.rules()(word);
    const RewrittenWord result{system.grammar(), std::move(word), counts, options.steps};
    if (format == "json")
        write_json(output.sink(), result, start.ends, context);
    else
        output.sink().write(as_text(result));
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
