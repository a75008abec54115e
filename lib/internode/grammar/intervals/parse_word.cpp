// SPDX-License-Identifier: MIT

#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/lexing/complaints.h"
#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/statement.h"
#include "internode/grammar/lexing/symbol_hints.h"
#include "internode/grammar/lexing/word_reader.h"

#include <algorithm>

#include <fmt/format.h>

namespace internode {

namespace {

/// Newlines are blanks here; parentheses without partners are marked.
std::vector<Token> word_tokens(std::string_view text) {
    std::vector<Token> tokens = tokenize(text);
    std::erase_if(tokens, [](const Token& token) { return token.kind == TokenKind::Newline; });
    mark_unbalanced(tokens, text);
    return tokens;
}

void refuse_broken(const std::vector<Token>& tokens, std::string_view text, Complaints& complaints) {
    for (const Token& token : tokens) {
        if (token.kind != TokenKind::Broken) continue;
        const unsigned byte = static_cast<unsigned char>(text[token.begin]);
        complaints.add("word.damaged-byte", place_of(token), fmt::format("the byte \\x{:02X} is no text", byte));
    }
}

} // namespace

ParsedWord parse_word(std::string_view text, const Alphabet& alphabet, std::string_view source) {
    ParsedWord result;
    if (text.size() > max_grammar_bytes) {
        result.errors.emplace_back();
        result.errors.back().code = "word.too-large";
        result.errors.back().source = source;
        result.errors.back().message = fmt::format("a word of {} bytes, more than {}", text.size(), max_grammar_bytes);
        return result;
    }
    Complaints complaints(text, source);
    const std::vector<Token> tokens = word_tokens(text);
    refuse_broken(tokens, text, complaints);
    if (tokens.empty()) {
        complaints.add("word.empty", {0, 0}, "a word without letters",
                       "write `L S L`, `0^3 (L S)^4 0^3` or `(L S)` for a circle");
    } else {
        const SymbolTable symbols(alphabet);
        ReadWord word = read_word(tokens, {text, symbols, WordPlace::Axiom, max_word_letters}, complaints);
        SymbolHints hints(alphabet);
        for (const SymbolUse& use : word.unknown)
            complaints.add("word.unknown-symbol", {use.offset, use.name.size()},
                           fmt::format("{} is no symbol of the grammar", quoted(use.name)), hints.in_word(use.name));
        result.says_ends = word.ends == Ends::Circular;
        result.axiom = {std::move(word.word), word.ends};
    }
    result.errors = std::move(complaints).diagnostics();
    return result;
}

} // namespace internode
