// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "cli/arguments/point_options.h"
#include "cli/points/points.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/report/json/point_validation_json.h"
#include "internode/report/json/validation_json.h"
#include "internode/report/text/point_validation_text.h"
#include "internode/report/text/validation_text.h"

#include <variant>

namespace internode::cli {

namespace {

/// What is printed, and whether the grammar is valid.
struct Report {
    std::string text;
    bool valid = false;
};

Report report_of(IntervalGrammar grammar, const ValidateOptions& options, bool json, const Context& context) {
    grammar.name = display_name(grammar, options.grammar);
    const Verdict verdict = validate(grammar);
    return {json ? validation_json(verdict, grammar, generator(context)) : validation_text(verdict, grammar),
            verdict.decision == Decision::Valid};
}

Report report_of(PointGrammar grammar, const LoadedText& input, const ValidateOptions& options, bool json,
                 const Context& context) {
    grammar.name = display_name(grammar.name, options.grammar);
    PointSettings settings;
    settings.constants = constant_values(grammar, options.settings);
    const PointValidation validation = make_point_validation(grammar, settings);
    const GrammarSourceText source{input.text, input.source};
    return {json ? point_validation_json(validation, grammar, source, generator(context))
                 : point_validation_text(validation, grammar, source),
            validation.valid};
}

} // namespace

ExitCode run(const ValidateOptions& options, const Context& context) {
    const bool json = chosen_format(options.output, {"text", "json"}, "text") == "json";
    const LoadedText input = load_grammar_text(options.grammar);
    const bool points = kind_of(input.text) == GrammarKind::Points;
    const std::variant<IntervalGrammar, PointGrammar> grammar =
        points ? std::variant<IntervalGrammar, PointGrammar>(load_point_grammar(input)) : load_grammar(input);
    PointOptions point_options;
    point_options.settings = options.settings;
    if (!points) refuse_point_options(point_options);
    Output output(options.output.file); // before the work: a file that cannot be written is said at once
    const Report report = points ? report_of(std::get<PointGrammar>(grammar), input, options, json, context)
                                 : report_of(std::get<IntervalGrammar>(grammar), options, json, context);
    output.sink().write(report.text);
    output.commit();
    return report.valid ? ExitCode::Success : ExitCode::NotValid;
}

} // namespace internode::cli
