// SPDX-License-Identifier: MIT

#include "cli/intervals/handlers.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "internode/report/json/validation_json.h"
#include "internode/report/text/validation_text.h"

namespace internode::cli {

ExitCode run(const IntervalGrammar& grammar, const LoadedText&, const ValidateOptions& options,
             const Context& context) {
    const std::string format = settled_format(context, options.output, {"validate", Kind::Intervals, ""});
    Output output(options.output.file); // before the work: a file that cannot be written is said at once
    IntervalGrammar named = grammar;
    named.name = display_name(grammar, options.grammar);
    const Verdict verdict = validate(named);
    output.sink().write(format == "json" ? validation_json(verdict, named, generator(context))
                                         : validation_text(verdict, named));
    output.commit();
    return verdict.decision == Decision::Valid ? ExitCode::Success : ExitCode::NotValid;
}

} // namespace internode::cli
