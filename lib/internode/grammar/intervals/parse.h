// SPDX-License-Identifier: MIT
//
// From text to grammar. The language is described in docs/language.md; all errors of a text come in one run.

#pragma once

#include "internode/grammar/intervals/interval_grammar.h"
#include "internode/grammar/lexing/parsed.h"
#include "internode/text/diagnostic.h"

#include <string_view>
#include <vector>

namespace internode {

using ParsedGrammar = Parsed<IntervalGrammar>;

/// Reads a whole text that must be an interval grammar (grammar/parse.h reads any kind); `source` is the name that
/// diagnostics show. Never throws on any text (but std::bad_alloc). Cost: linear in the text. Limits:
/// grammar/lexing/limits.h.
[[nodiscard]] ParsedGrammar parse_grammar(std::string_view text, std::string_view source);

struct ParsedWord {
    Axiom axiom;            ///< meaningful iff errors is empty
    bool says_ends = false; ///< the text stood in parentheses: `( … )` is circular
    std::vector<Diagnostic> errors;
};

/// Reads a word over an alphabet ("SLLS", "0^3 (LS)^4 0^3", "(L S)"), as `--word` and an axiom are written.
[[nodiscard]] ParsedWord parse_word(std::string_view text, const Alphabet& alphabet, std::string_view source);

} // namespace internode
