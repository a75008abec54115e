// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/report/rewritten_word.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

Axiom start_word(const WordOptions& options, const IntervalGrammar& grammar) {
    if (!options.word.empty()) return load_word(options.word, grammar.alphabet).axiom;
    if (grammar.axiom) return *grammar.axiom;
    throw failure(ExitCode::Refused, "the grammar has no axiom", "give a word: --word 'LSL'");
}

} // namespace

ExitCode run(const WordOptions& options, const Context& context) {
    const std::string format = settled_format(context, options.output, {"word", Kind::Intervals, ""});
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
    const RewrittenWord result{system.alphabet(), std::move(word),   start.ends, counts,
                               options.steps,     generator(context)};
    if (format == "json")
        write_word_json(output.sink(), result);
    else
        output.sink().write(word_text(result));
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
