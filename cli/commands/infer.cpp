// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/requests/formats.h"
#include "cli/shell/generator.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/io/matrix/fraction_matrix.h"
#include "internode/report/text/inference_text.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

struct LoadedMatrix {
    RationalMatrix matrix;
    std::string source;
};

LoadedMatrix load_matrix(const std::string& place) {
    const LoadedText input = load_text(place);
    ParsedFractionMatrix parsed = read_fraction_matrix(input.text, input.source);
    if (!parsed.matrix) throw Failure(ExitCode::Refused, to_string(parsed.errors));
    return {*std::move(parsed.matrix), input.source};
}

Failure refusal(const std::string& source, const InferenceProblem& problem) {
    std::string text = fmt::format("{}: error: {}\n", printable(source), problem.message);
    text += irregular_rows_text(problem);
    if (!problem.hint.empty()) text += fmt::format("hint: {}\n", problem.hint);
    return {ExitCode::Refused, text};
}

/// "chaikin" of "matrices/chaikin.csv"; "inferred" where a name would be no name.
std::string name_of(const std::string& place) {
    const auto slash = place.find_last_of('/');
    std::string name = slash == std::string::npos ? place : place.substr(slash + 1);
    name = name.substr(0, name.find('.'));
    return name.empty() || name == "-" ? "inferred" : name;
}

void check_shift(const InferOptions& options, const RationalMatrix& matrix) {
    if (!options.shift) return;
    const auto most = static_cast<std::int64_t>(matrix.rows.size()) - 1;
    if (*options.shift > most || *options.shift < -most)
        throw failure(ExitCode::Usage, fmt::format("--shift {} is beyond the matrix", *options.shift),
                      fmt::format("{} rows allow {} to {}", matrix.rows.size(), -most, most));
}

std::string closed_text(const LoadedMatrix& input, const InferenceTextOptions& options) {
    const InferredPattern inferred = infer_closed(input.matrix);
    if (!inferred.pattern) throw refusal(input.source, *inferred.problem);
    return inference_text(*inferred.pattern, options);
}

std::string open_text(const LoadedMatrix& input, const InferenceTextOptions& options) {
    const InferredOpenPattern inferred = infer_open(input.matrix);
    if (!inferred.pattern) throw refusal(input.source, *inferred.problem);
    const std::ptrdiff_t shift = options.shift.value_or(sensible_shifts(inferred.pattern->pattern).recommended);
    const bool none = !options.shift && sensible_open_shifts(*inferred.pattern).shifts.empty();
    const InferredOpenProductions productions = open_productions(*inferred.pattern, shift);
    if (productions.problem && (options.shift || none)) throw refusal(input.source, *productions.problem);
    return inference_text(*inferred.pattern, options);
}

} // namespace

ExitCode run(const InferOptions& options, const Context& context) {
    (void)settled_format(context, options.output, {"infer", {}, ""});
    const LoadedMatrix input = load_matrix(options.matrix);
    check_shift(options, input.matrix);
    InferenceTextOptions text;
    text.name = options.name.empty() ? name_of(options.matrix) : options.name;
    text.generator = generator(context);
    if (options.shift) text.shift = static_cast<std::ptrdiff_t>(*options.shift);
    text.form = options.long_form ? OpenForm::Long : OpenForm::Ordered;
    write_output(options.output.file, options.open ? open_text(input, text) : closed_text(input, text));
    return ExitCode::Success;
}

} // namespace internode::cli
