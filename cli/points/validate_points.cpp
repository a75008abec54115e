// SPDX-License-Identifier: MIT

#include "cli/points/handlers.h"
#include "cli/points/points.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "internode/report/json/point_validation_json.h"
#include "internode/report/text/point_validation_text.h"

namespace internode::cli {

ExitCode run(const PointGrammar& grammar, const LoadedText& text, const ValidateOptions& options,
             const Context& context) {
    const std::string format = settled_format(context, options.output, {"validate", Kind::Points, ""});
    Output output(options.output.file); // before the work: a file that cannot be written is said at once
    PointGrammar named = grammar;
    named.name = display_name(grammar.name, options.grammar);
    PointSettings settings;
    settings.constants = constant_values(named, options.settings);
    const PointValidation validation = make_point_validation(named, settings);
    const GrammarSourceText source{text.text, text.source};
    output.sink().write(format == "json" ? point_validation_json(validation, named, source, generator(context))
                                         : point_validation_text(validation, named, source));
    output.commit();
    return validation.valid ? ExitCode::Success : ExitCode::NotValid;
}

} // namespace internode::cli
