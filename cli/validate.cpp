// SPDX-License-Identifier: MIT

#include "cli/commands.h"
#include "cli/load.h"
#include "cli/output.h"
#include "internode/report/validation_json.h"
#include "internode/report/validation_text.h"

namespace internode::cli {

ExitCode run(const ValidateOptions& options, const Context& context) {
    const std::string format = chosen_format(options.output, {"text", "json"}, "text");
    IntervalGrammar grammar = load_grammar(options.grammar);
    grammar.name = display_name(grammar, options.grammar);
    Output output(options.output.file);
    const Verdict verdict = validate(grammar);
    output.sink().write(format == "json" ? validation_json(verdict, grammar, generator(context))
                                         : validation_text(verdict, grammar));
    output.commit();
    return verdict.decision == Decision::Valid ? ExitCode::Success : ExitCode::NotValid;
}

} // namespace internode::cli
