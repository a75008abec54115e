// SPDX-License-Identifier: MIT
//
// Any bytes are a point grammar or have errors with a place; what is a grammar survives printing and reading, and its
// places are in the text.

#include "internode/grammar/lexing/grammar_kind.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/grammar/points/print_points.h"
#include "tests/fuzz/require.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

using internode::fuzz::require;

/// Powers make 10^5 modules from a few bytes: such are read but not written under the fuzzer's clock.
constexpr std::size_t written_modules = 5'000;

std::size_t modules(const internode::PointGrammar& grammar) {
    std::size_t count = grammar.axiom ? grammar.axiom->size() : 0;
    if (grammar.input) count += grammar.input->first.size() + grammar.input->each.size() + grammar.input->last.size();
    for (const internode::PointRule& rule : grammar.rules) count += rule.successor.size();
    for (const auto& pass : grammar.interpretations)
        for (const internode::PointRule& rule : pass) count += rule.successor.size();
    return count;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const internode::ParsedPointGrammar parsed = internode::parse_point_grammar(text, "<fuzz>");
    require(parsed.grammar.has_value() == parsed.errors.empty());
    for (const internode::Diagnostic& error : parsed.errors) require(error.line >= 1 && error.column >= 1);
    require(parsed.errors.empty() == internode::to_string(parsed.errors).empty());
    if (!parsed.grammar) return 0;
    require(internode::kind_of(text) == internode::GrammarKind::Points);
    for (const internode::PointRule& rule : parsed.grammar->rules)
        require(internode::diagnostic_at(text, "<fuzz>", rule.place, "a rule", "").line >= 1);
    if (modules(*parsed.grammar) > written_modules) return 0;
    const internode::ParsedPointGrammar again =
        internode::parse_point_grammar(internode::print(*parsed.grammar), "<printed>");
    require(again.grammar == parsed.grammar);
    return 0;
}
