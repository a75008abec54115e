// SPDX-License-Identifier: MIT
//
// Any bytes are a grammar or have errors with a place; what is a grammar survives printing and reading.

#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/intervals/print.h"
#include "tests/fuzz/require.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

using internode::fuzz::require;

/// Powers make words of up to 10^7 letters from a few bytes: such are read but not written under the fuzzer's clock.
constexpr std::size_t written_letters = 100'000;

std::size_t letters(const internode::IntervalGrammar& grammar) {
    std::size_t count = grammar.axiom ? grammar.axiom->word.size() : 0;
    for (const internode::Word& image : grammar.rules.images()) count += image.size();
    return count;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const internode::ParsedGrammar parsed = internode::parse_grammar(text, "<fuzz>");
    require(parsed.grammar.has_value() == parsed.errors.empty());
    for (const internode::Diagnostic& error : parsed.errors) require(error.line >= 1 && error.column >= 1);
    require(parsed.errors.empty() == internode::to_string(parsed.errors).empty());
    if (!parsed.grammar) return 0;
    static_cast<void>(internode::parse_word(text, parsed.grammar->alphabet, "<fuzz>"));
    if (letters(*parsed.grammar) > written_letters) return 0;
    const internode::ParsedGrammar again = internode::parse_grammar(internode::print(*parsed.grammar), "<printed>");
    require(again.grammar == parsed.grammar);
    return 0;
}
