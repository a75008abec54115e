// SPDX-License-Identifier: MIT
//
// From text to point grammar. docs/language.md describes the language; all errors of a text
// come in one run.

#pragma once

#include "internode/grammar/lexing/parsed.h"
#include "internode/grammar/points/point_grammar.h"
#include "internode/text/diagnostic.h"

#include <string>
#include <string_view>

namespace internode {

using ParsedPointGrammar = Parsed<PointGrammar>;

/// Reads a whole text that must be a point grammar (grammar/parse.h reads any kind). Never throws on any text (but
/// std::bad_alloc). Cost: linear in the text. Limits: grammar/lexing/limits.h.
[[nodiscard]] ParsedPointGrammar parse_point_grammar(std::string_view text, std::string_view source);

/// A diagnostic about a place of a grammar that has been read: with its line, column and source line. A place of no
/// bytes means the whole grammar and gives none of these.
[[nodiscard]] Diagnostic diagnostic_at(std::string_view text, std::string_view source, const SourcePlace& place,
                                       std::string message, std::string hint, std::string_view code = {});

} // namespace internode
