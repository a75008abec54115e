// SPDX-License-Identifier: MIT

#include "cli/shell/load.h"

#include "cli/requests/exit_code.h"
#include "internode/grammar/bundled.h"
#include "internode/grammar/parse.h"
#include "internode/io/file/input_file.h"
#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"
#include "internode/text/printable.h"

#include <fmt/format.h>

#include <cassert>

namespace internode::cli {
namespace {

LoadedText bundled_text(const std::string& place) {
    assert(place.starts_with('@'));
    const std::string name = place.substr(1);
    if (const BundledGrammar* grammar = find_bundled_grammar(name)) return {std::string(grammar->text), place};
    std::vector<std::string> names;
    for (const BundledGrammar& grammar : bundled_grammars()) names.emplace_back(grammar.name);
    const std::string meant = did_you_mean(name, names);
    throw failure(ExitCode::Usage, fmt::format("no bundled grammar `{}`", place),
                  meant.empty() ? "`internode grammars` lists them" : fmt::format("did you mean `@{}`?", meant));
}

ExitCode exit_code(FileError::Kind kind) {
    switch (kind) {
    case FileError::Kind::TooLarge:
    case FileError::Kind::NotText:
        return ExitCode::Refused;
    case FileError::Kind::Interrupted:
        return ExitCode::Interrupted;
    default:
        return ExitCode::File;
    }
}

LoadedText grammar_text(const GrammarSource& source) {
    if (source.expression) return {*source.expression, "<expression>"};
    if (source.place.rfind('@', 0) == 0) return bundled_text(source.place);
    return load_text(source.place);
}

IntervalGrammar interval_grammar(const LoadedText& input) {
    ParsedGrammar parsed = parse_grammar(input.text, input.source);
    if (!parsed.grammar) throw Failure(ExitCode::Refused, to_string(parsed.errors));
    return *std::move(parsed.grammar);
}

} // namespace

namespace {

LoadedText load(const std::string& place, const InputOptions& options) {
    InputText input = read_input(place, options);
    if (!input.error) return {std::move(input.text), std::move(input.source)};
    const FileError& error = *input.error;
    std::string where = printable(error.path);
    if (error.line > 0) where += fmt::format(":{}:{}", error.line, error.column);
    throw Failure(exit_code(error.kind), fmt::format("{}: error: {}\n", where, error.message));
}

} // namespace

LoadedText load_text(const std::string& place) {
    return load(place, {});
}

LoadedText load_bytes(const std::string& place) {
    return load(place, {.may_be_binary = true});
}

LoadedGrammar load_grammar(const GrammarSource& source) {
    LoadedText text = grammar_text(source);
    Parsed<Grammar> parsed = parse(text.text, text.source);
    if (!parsed.grammar) throw Failure(ExitCode::Refused, to_string(parsed.errors));
    return {*std::move(parsed.grammar), std::move(text)};
}

IntervalSystem load_system(const GrammarSource& source) {
    return load_system(interval_grammar(grammar_text(source)), source);
}

IntervalSystem load_system(const IntervalGrammar& grammar, const GrammarSource& source) {
    const Verdict verdict = validate(grammar);
    if (verdict.system) return *verdict.system;
    const std::string name = printable(display_name(grammar, source));
    if (verdict.decision == Decision::Valid)
        throw failure(ExitCode::Refused,
                      fmt::format("`{}` is valid, but too large for exact masks: its field's degree is above {} or a "
                                  "class has more than {} symbols",
                                  name, ValidityLimits{}.field_degree, ValidityLimits{}.exact_class));
    std::string text = fmt::format("error: `{}` is {}\n", name,
                                   verdict.decision == Decision::Invalid ? "not a valid interval system" : "undecided");
    for (const Reason& reason : verdict.reasons) text += fmt::format("  {}\n", printable(reason.message));
    throw Failure(ExitCode::Refused, text);
}

ParsedWord load_word(const std::string& text, const Alphabet& alphabet) {
    ParsedWord word = parse_word(text, alphabet, "<word>");
    if (!word.errors.empty()) throw Failure(ExitCode::Refused, to_string(word.errors));
    return word;
}

std::string display_name(const IntervalGrammar& grammar, const GrammarSource& source) {
    return display_name(grammar.name, source);
}

std::string display_name(const std::string& name, const GrammarSource& source) {
    if (!name.empty()) return name;
    if (source.expression) return "<expression>";
    const auto slash = source.place.find_last_of('/');
    return slash == std::string::npos ? source.place : source.place.substr(slash + 1);
}

} // namespace internode::cli
