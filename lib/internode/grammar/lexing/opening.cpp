// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/opening.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/name.h"
#include "internode/grammar/lexing/word_reader.h"
#include "internode/text/did_you_mean.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace internode {

namespace {

/// The first word of a grammar.
struct KindWord {
    std::string_view word;
    std::optional<GrammarKind> kind; ///< none: not read by this version
};

constexpr std::array<KindWord, 4> kind_words{{{"intervals", GrammarKind::Intervals},
                                              {"points", GrammarKind::Points},
                                              {"patches", std::nullopt},
                                              {"mesh", std::nullopt}}};

const KindWord* find_kind(std::string_view word) {
    const auto* const found = std::ranges::find(kind_words, word, &KindWord::word);
    return found == kind_words.end() ? nullptr : found;
}

const std::vector<std::string>& all_kinds() {
    static const std::vector<std::string> words = [] {
        std::vector<std::string> all;
        for (const KindWord& kind : kind_words) all.emplace_back(kind.word);
        return all;
    }();
    return words;
}

constexpr std::string_view kind_hint = "begin with `intervals NAME`, then one rule a line: `L -> S L`";
constexpr std::string_view points_hint = "begin with `points NAME`, then one rule a line: `P(v) -> P(v) P(v)`";

/// The name in a statement `intervals NAME`.
std::string read_name(const Statement& statement, std::string_view text, Complaints& complaints) {
    assert(!statement.tokens.empty());
    const std::string_view kind = text_of(statement.tokens.front(), text);
    const std::span<const Token> tokens = statement.tokens.subspan(1);
    const auto is_broken = [](const Token& token) { return token.kind == TokenKind::Broken; };
    if (tokens.empty() || std::ranges::any_of(tokens, is_broken)) return {};
    const Token& token = tokens.front();
    const std::optional<std::string> name = read_grammar_name(text_of(token, text));
    if (token.kind == TokenKind::OpenText) {
        complaints.add("name.open-quote", place_of(token), "a quoted name without its second quote");
    } else if (!name && token.kind == TokenKind::Text) {
        complaints.add("name.bad-escape", place_of(token),
                       "an escape that is not `\\\"`, `\\\\` or `\\u{...}` of a printable character");
    } else if (!name || (tokens.size() > 1 && token.begin + token.bytes == tokens[1].begin)) {
        complaints.add("name.not-a-name", place_of(tokens), "a name is a letter, then letters, digits, `_` or `'`",
                       fmt::format("any other name stands in quotes: `{} \"my-grammar\"`", kind));
    } else if (name->size() > max_name_bytes) {
        complaints.add("name.too-long", place_of(token),
                       fmt::format("a name of {} bytes, more than {}", name->size(), max_name_bytes));
    } else if (tokens.size() > 1) {
        complaints.add("grammar.opening-goes-on", place_of(tokens.subspan(1)),
                       "the statement goes on after the name of the grammar",
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
    const std::string near =
        head.kind == TokenKind::Run && !is_keyword ? did_you_mean(word, all_kinds()) : std::string();
    if (near.empty()) {
        complaints.add("grammar.no-kind", place_of(head), "the first statement must name the kind of grammar",
                       std::string(kind_hint));
    } else {
        complaints.add("grammar.unknown-kind", place_of(head), fmt::format("{} is no kind of grammar", quoted(word)),
                       fmt::format("did you mean `{}`?", near));
        opening.readable = opening.readable && find_kind(near)->kind == GrammarKind::Intervals;
    }
    return opening;
}

/// A text without a statement: the bytes may say why already.
Opening refuse_empty(std::string_view hint, Complaints& complaints) {
    if (complaints.empty()) complaints.add("grammar.empty", {0, 0}, "the text has no statement", std::string(hint));
    Opening opening;
    opening.readable = false;
    return opening;
}

Opening read_intervals_opening(const Statements& split, std::string_view text, Complaints& complaints) {
    if (split.statements.empty()) return refuse_empty(kind_hint, complaints);
    Opening opening;
    const Statement& statement = split.statements.front();
    if (statement.arrow) return opening;
    const Token& head = statement.tokens.front();
    const std::string_view word = text_of(head, text);
    const KindWord* const named = find_kind(word);
    if (named == nullptr) return refuse_first(split, text, complaints);
    if (named->kind == GrammarKind::Intervals) {
        opening.first = 1;
        opening.name = read_name(statement, text, complaints);
        return opening;
    }
    complaints.add(named->kind ? "grammar.other-kind" : "grammar.kind-to-come", place_of(head),
                   named->kind ? "a point grammar where an interval grammar is wanted"
                               : fmt::format("a grammar of kind `{}`: this version reads `intervals` and "
                                             "`points` only",
                                             word),
                   std::string(kind_hint));
    opening.readable = false;
    return opening;
}

Opening read_points_opening(const Statements& split, std::string_view text, Complaints& complaints) {
    if (split.statements.empty()) return refuse_empty(points_hint, complaints);
    Opening opening;
    const Statement& statement = split.statements.front();
    const Token& head = statement.tokens.front();
    const std::string_view word = text_of(head, text);
    const KindWord* const named = find_kind(word);
    if (named != nullptr && named->kind == GrammarKind::Points) {
        opening.first = 1;
        if (statement.arrow)
            complaints.add("grammar.kind-with-arrow", place_of(head),
                           "the kind of the grammar stands on a line of its own", std::string(points_hint));
        else
            opening.name = read_name(statement, text, complaints);
    } else if (named != nullptr) {
        complaints.add("grammar.other-kind", place_of(head),
                       fmt::format("a grammar of kind `{}` where a point grammar is wanted", word),
                       std::string(points_hint));
        opening.readable = false;
    } else if (head.kind != TokenKind::Broken) {
        complaints.add("grammar.no-kind", place_of(head), "the first statement must be `points`",
                       std::string(points_hint));
    }
    return opening;
}

} // namespace

bool is_kind(std::string_view word) {
    return find_kind(word) != nullptr;
}

Opening read_opening(const Statements& split, std::string_view text, GrammarKind kind, Complaints& complaints) {
    return kind == GrammarKind::Points ? read_points_opening(split, text, complaints)
                                       : read_intervals_opening(split, text, complaints);
}

GrammarKind kind_of(std::span<const Token> tokens, std::string_view text) {
    const auto is_between = [&](const Token& token) {
        return token.kind == TokenKind::Newline || is_mark(token, text, ',') || is_mark(token, text, ';');
    };
    const auto first = std::ranges::find_if_not(tokens, is_between);
    const KindWord* const named = first == tokens.end() ? nullptr : find_kind(text_of(*first, text));
    return named == nullptr ? GrammarKind::Intervals : named->kind.value_or(GrammarKind::Intervals);
}

GrammarKind kind_of(std::string_view text) {
    return text.size() > max_grammar_bytes ? GrammarKind::Intervals : kind_of(tokenize(text), text);
}

} // namespace internode
