// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/opened_text.h"

#include "internode/grammar/lexing/byte_check.h"
#include "internode/grammar/lexing/token.h"

#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

Brackets brackets_of(GrammarKind kind) {
    return kind == GrammarKind::Points ? Brackets::RoundAndSquare : Brackets::Round;
}

} // namespace

OpenedText open_text(std::string_view text, std::optional<GrammarKind> wanted, Complaints& complaints) {
    assert(text.size() <= max_grammar_bytes);
    std::vector<Token> tokens = tokenize(text);
    check_bytes(text, tokens, complaints);
    OpenedText opened{text, wanted ? *wanted : kind_of(tokens, text), {}, {}};
    opened.split = split_statements(std::move(tokens), text, brackets_of(opened.kind));
    opened.opening = read_opening(opened.split, text, opened.kind, complaints);
    assert(!opened.opening.readable || opened.opening.first <= opened.split.statements.size());
    return opened;
}

Diagnostic text_too_large(std::string_view text, std::string_view source) {
    Diagnostic diagnostic;
    diagnostic.code = "text.too-large";
    diagnostic.source = source;
    diagnostic.message = fmt::format("a text of {} bytes, more than {}", text.size(), max_grammar_bytes);
    return diagnostic;
}

} // namespace internode
