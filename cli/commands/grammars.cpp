// SPDX-License-Identifier: MIT

#include "cli/commands/commands.h"
#include "cli/shell/load.h"
#include "cli/shell/output.h"
#include "internode/grammar/bundled.h"
#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {
namespace {

/// What follows `// source:` in a bundled grammar.
std::string_view source_line(std::string_view text) {
    constexpr std::string_view mark = "// source:";
    const auto at = text.find(mark);
    if (at == std::string_view::npos) return {};
    const auto begin = text.find_first_not_of(' ', at + mark.size());
    return text.substr(begin, text.find('\n', begin) - begin);
}

std::string grammar_list() {
    std::size_t width = 0;
    for (const BundledGrammar& grammar : bundled_grammars()) width = std::max(width, grammar.name.size());
    std::string text;
    for (const BundledGrammar& grammar : bundled_grammars())
        text += fmt::format("@{:<{}}  {}\n", grammar.name, width, source_line(grammar.text));
    text += "\nA grammar of one symbol, like @bisection, serves any knot vector: one symbol per distinct length.\n";
    return text;
}

std::string grammar_text(std::string name) {
    if (name.rfind('@', 0) == 0) name.erase(0, 1);
    if (const BundledGrammar* grammar = find_bundled_grammar(name)) return std::string(grammar->text);
    std::vector<std::string> names;
    for (const BundledGrammar& grammar : bundled_grammars()) names.emplace_back(grammar.name);
    const std::string meant = did_you_mean(name, names);
    throw failure(ExitCode::Usage, fmt::format("no bundled grammar `{}`", name),
                  meant.empty() ? "`internode grammars` lists them" : fmt::format("did you mean `{}`?", meant));
}

} // namespace

ExitCode run(const GrammarsOptions& options, const Context&) {
    write_output("-", options.name.empty() ? grammar_list() : grammar_text(options.name));
    return ExitCode::Success;
}

} // namespace internode::cli
