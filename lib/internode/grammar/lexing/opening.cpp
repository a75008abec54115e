// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/opening.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/name.h"
#include "internode/grammar/lexing/word_reader.h"

#include <algorithm>

#include <fmt/format.h>

namespace internode {

namespace {

const std::vector<std::string>& kinds() {
    static const std::vector<std::string> names{"intervals", "points", "patches", "mesh"};
    return names;
}

constexpr std::string_view points = "points";

constexpr std::string_view kind_hint = "begin with `intervals NAME`, then one rule a line: `L -> S L`";
constexpr std::string_view points_hint = "begin with `points NAME`, then one rule a line: `P(v) -> P(v) P(v)`";

/// The name in a statement `intervals NAME`.
std::string read_name(const Statement& statement, std::string_view text, Complaints& complaints) {
    const std::string_view kind = text_of(statement.tokens.front(), text);
    const std::span<const Token> tokens = statement.tokens.subspan(1);
    const auto is_broken = [](const Token& token) { return token.kind == TokenKind::Broken; };
    if (tokens.empty() || std::ranges::any_of(tokens, is_broken)) return {};
    const Token& token = tokens.front();
    const std::optional<std::string> name = read_grammar_name(text_of(token, text));
    if (token.kind == TokenKind::OpenText) {
        complaints.add(place_of(token), "a quoted name without its second quote");
    } else if (!name && token.kind == TokenKind::Text) {
        complaints.add(place_of(token), "an escape that is not `\\\"`, `\\\\` or `\\u{...}` of a printable character");
    } else if (!name || (tokens.size() > 1 && token.begin + token.bytes == tokens[1].begin)) {
        complaints.add(place_of(tokens), "a name is a letter, then letters, digits, `_` or `'`",
                       fmt::format("any other name stands in quotes: `{} \"my-grammar\"`", kind));
    } else if (name->size() > max_name_bytes) {
        complaints.add(place_of(token), fmt::format("a name of {} bytes, more than {}", name->size(), max_name_bytes));
    } else if (tokens.size() > 1) {
        complaints.add(place_of(tokens.subspan(1)), "the statement goes on after the name of the grammar",
                       "a name with blanks or signs stands in quotes; a statement ends with its line");
    } else {
        return *name;
    }
    return {};
}

bool has_arrow(const Statement& statement) {
    return statement.arrow.has_value();
}

/// The first statement has no arrow and does not begin with a kind.
Opening refuse_first(const Statements& split, std::string_view text, Complaints& complaints) {
    const Token& head = split.statements.front().tokens.front();
    const std::string_view word = text_of(head, text);
    const bool is_keyword = word == "axiom" || word == "length" || word == "ring";
    Opening opening;
    opening.readable = std::ranges::any_of(split.statements, has_arrow);
    opening.first = is_keyword ? 0 : 1;
    if (head.kind == TokenKind::Broken) return opening;
    const std::string near = head.kind == TokenKind::Run && !is_keyword ? did_you_mean(word, kinds()) : std::string();
    if (near.empty()) {
        complaints.add(place_of(head), "the first statement must name the kind of grammar", std::string(kind_hint));
    } else {
        complaints.add(place_of(head), fmt::format("{} is no kind of grammar", quoted(word)),
                       fmt::format("did you mean `{}`?", near));
        opening.readable = opening.readable && near == kinds().front();
    }
    return opening;
}

} // namespace

bool is_kind(std::string_view word) {
    return std::ranges::find(kinds(), word) != kinds().end();
}

Opening read_opening(const Statements& split, std::string_view text, Complaints& complaints) {
    Opening opening;
    if (split.statements.empty()) {
        if (complaints.empty()) complaints.add({0, 0}, "the text has no statement", std::string(kind_hint));
        opening.readable = false;
        return opening;
    }
    const Statement& statement = split.statements.front();
    if (statement.arrow) return opening;
    const Token& head = statement.tokens.front();
    const std::string_view word = text_of(head, text);
    if (word == kinds().front()) {
        opening.first = 1;
        opening.name = read_name(statement, text, complaints);
    } else if (is_kind(word)) {
        complaints.add(place_of(head),
                       word == points ? "a point grammar where an interval grammar is wanted"
                                      : fmt::format("a grammar of kind `{}`: this version reads `intervals` and "
                                                    "`points` only",
                                                    word),
                       std::string(kind_hint));
        opening.readable = false;
    } else {
        opening = refuse_first(split, text, complaints);
    }
    return opening;
}

Opening read_points_opening(const Statements& split, std::string_view text, Complaints& complaints) {
    Opening opening;
    if (split.statements.empty()) {
        if (complaints.empty()) complaints.add({0, 0}, "the text has no statement", std::string(points_hint));
        opening.readable = false;
        return opening;
    }
    const Statement& statement = split.statements.front();
    const Token& head = statement.tokens.front();
    const std::string_view word = text_of(head, text);
    if (word == points && !statement.arrow) {
        opening.first = 1;
        opening.name = read_name(statement, text, complaints);
    } else if (word == points) {
        opening.first = 1;
        complaints.add(place_of(head), "the kind of the grammar stands on a line of its own", std::string(points_hint));
    } else if (is_kind(word)) {
        complaints.add(place_of(head), fmt::format("a grammar of kind `{}` where a point grammar is wanted", word),
                       std::string(points_hint));
        opening.readable = false;
    } else if (head.kind != TokenKind::Broken) {
        complaints.add(place_of(head), "the first statement must be `points`", std::string(points_hint));
    }
    return opening;
}

} // namespace internode
