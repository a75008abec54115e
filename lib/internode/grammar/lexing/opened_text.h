// SPDX-License-Identifier: MIT
//
// A text taken apart once, from bytes to tokens to statements, and its first statement read: what every kind of
// grammar begins with. What follows the opening is read by the kind's own reader, from these statements.

#pragma once

#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/grammar_kind.h"
#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/opening.h"
#include "internode/grammar/lexing/parsed.h"
#include "internode/grammar/lexing/statement.h"
#include "internode/text/diagnostic.h"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace internode {

struct OpenedText {
    std::string_view text;
    GrammarKind kind = GrammarKind::Intervals; ///< the kind that was wanted, else the one that the text says
    Statements split;
    Opening opening;
};

/// Complains of damaged bytes and of the opening. A `wanted` kind is read whatever the text says, and another one is
/// refused. The text has at most max_grammar_bytes. Cost: linear in the text.
[[nodiscard]] OpenedText open_text(std::string_view text, std::optional<GrammarKind> wanted, Complaints& complaints);

/// "a text of 16777217 bytes, more than 16777216"
[[nodiscard]] Diagnostic text_too_large(std::string_view text, std::string_view source);

/// Opens the text and has its statements read: `read(opened, complaints)` returns an optional Value.
template<class Value, class Reader>
[[nodiscard]] Parsed<Value> parse_opened(std::string_view text, std::string_view source,
                                         std::optional<GrammarKind> wanted, Reader read) {
    if (text.size() > max_grammar_bytes) return {std::nullopt, {text_too_large(text, source)}};
    Complaints complaints(text, source);
    const OpenedText opened = open_text(text, wanted, complaints);
    std::optional<Value> value;
    if (opened.opening.readable) value = read(opened, complaints);
    if (complaints.empty()) return {std::move(value), {}};
    return {std::nullopt, std::move(complaints).diagnostics()};
}

} // namespace internode
