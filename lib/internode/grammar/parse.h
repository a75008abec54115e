// SPDX-License-Identifier: MIT
//
// From text to grammar, of the kind that the text names. docs/language.md describes the language; all errors of a text
// come in one run.

#pragma once

#include "internode/grammar/grammar.h"
#include "internode/grammar/lexing/parsed.h"

#include <string_view>

namespace internode {

/// Reads a whole text; `source` is the name that diagnostics show. Never throws on any text (but std::bad_alloc). One
/// pass: bytes, tokens, statements and the opening once, then the statements by the kind's reader.
/// Cost: linear in the text. Limits: grammar/lexing/limits.h.
[[nodiscard]] Parsed<Grammar> parse(std::string_view text, std::string_view source);

} // namespace internode
