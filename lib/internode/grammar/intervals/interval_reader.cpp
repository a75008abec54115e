// SPDX-License-Identifier: MIT
//
// The last step of reading an interval grammar: from statements to the grammar. Every statement is read on its own, in
// the order of the text, so that an error in one leaves the others readable.

#include "internode/grammar/intervals/interval_reader.h"

#include "internode/grammar/intervals/left_side.h"
#include "internode/grammar/intervals/length_reader.h"
#include "internode/grammar/intervals/print.h"
#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/normal_form.h"
#include "internode/grammar/lexing/opening.h"
#include "internode/grammar/lexing/statement.h"
#include "internode/grammar/lexing/symbol_hints.h"
#include "internode/grammar/lexing/word_reader.h"
#include "internode/text/did_you_mean.h"

#include <algorithm>
#include <cassert>
#include <unordered_map>

#include <fmt/format.h>

namespace internode {

namespace {

constexpr std::string_view statement_hint = "a statement is a rule `L -> S L`, `axiom L S`, `length L = 3/2` or `ring`";

const std::vector<std::string>& keywords() {
    static const std::vector<std::string> names{"axiom", "length", "ring"};
    return names;
}

/// Reads the statements after the kind.
class StatementReader {
public:
    StatementReader(std::string_view text, LeftSides sides, Complaints& complaints)
        : text_(text)
        , complaints_(complaints)
        , sides_(std::move(sides))
        , symbols_(sides_.alphabet)
        , lengths_(text, symbols_, complaints)
        , images_(sides_.alphabet.size()) {}

    void read(const Statement& statement, std::optional<Symbol> left_side) {
        assert(!statement.tokens.empty());
        const std::string_view head = text_of(statement.tokens.front(), text_);
        if (statement.arrow)
            read_rule(statement, left_side);
        else if (head == "axiom")
            read_axiom(statement);
        else if (head == "length")
            note_unknown(lengths_.read(statement));
        else if (head == "ring")
            read_ring(statement);
        else if (statement.tokens.front().kind != TokenKind::Broken)
            refuse(statement);
    }

    [[nodiscard]] const LeftSides& sides() const { return sides_; }

    /// What only the whole text can tell.
    void finish() {
        complain_of_unknown_symbols();
        if (ring_place_ && axiom_) axiom_->ends = Ends::Circular;
        if (ring_place_ && !axiom_place_)
            complaints_.add("axiom.missing-for-ring", *ring_place_, "`ring` without an axiom",
                            "write `axiom (L S)`, or leave `ring` out");
    }

    /// The grammar; the complaints must be empty.
    IntervalGrammar grammar(std::string name) && {
        assert(complaints_.empty());
        return {std::move(name), std::move(sides_.alphabet), Morphism(std::move(images_)), std::move(axiom_),
                std::move(lengths_).declarations()};
    }

private:
    [[nodiscard]] WordContext context(WordPlace place, std::size_t max_letters) const {
        return {text_, symbols_, place, max_letters, letters_};
    }

    Word keep(ReadWord read) {
        for (const SymbolUse& use : read.unknown) note_unknown(use);
        letters_ += read.word.size();
        return std::move(read.word);
    }

    void read_rule(const Statement& statement, std::optional<Symbol> left_side) {
        const std::span<const Token> right = statement.tokens.subspan(*statement.arrow + 1);
        if (right.empty()) {
            complaints_.add("rule.empty-successor", place_of(statement.tokens[*statement.arrow]), "an empty successor",
                            "an interval cannot become nothing: write at least one symbol after `->`");
            return;
        }
        Word word = keep(read_word(right, context(WordPlace::Rule, max_rule_letters), complaints_));
        if (left_side) images_[to_index(*left_side)] = std::move(word);
    }

    void read_axiom(const Statement& statement) {
        const Token& head = statement.tokens.front();
        if (axiom_place_) {
            complaints_.add("grammar.second-statement", place_of(head), "a second axiom",
                            fmt::format("the first is in line {}", complaints_.line_of(axiom_place_->offset)));
            return;
        }
        axiom_place_ = place_of(head);
        const std::span<const Token> word = statement.tokens.subspan(1);
        if (word.empty()) {
            complaints_.add("axiom.empty", *axiom_place_, "`axiom` without a word",
                            "write `axiom L S L`, or `axiom (L S)` for a circle");
        } else if (is_mark(word.front(), text_, ':') || is_mark(word.front(), text_, '=')) {
            complaints_.add("axiom.sign", place_of(word.front()), "a sign between `axiom` and its word",
                            "write `axiom L S L`");
        } else {
            ReadWord axiom = read_word(word, context(WordPlace::Axiom, max_word_letters), complaints_);
            const Ends ends = axiom.ends;
            axiom_ = Axiom{keep(std::move(axiom)), ends};
        }
    }

    void read_ring(const Statement& statement) {
        const std::span<const Token> more = statement.tokens.subspan(1);
        if (!more.empty())
            complaints_.add("grammar.stands-alone", place_of(more), "`ring` stands alone",
                            "write it on a line of its own");
        else if (ring_place_)
            complaints_.add("grammar.second-statement", place_of(statement.tokens.front()), "a second `ring`",
                            fmt::format("the first is in line {}", complaints_.line_of(ring_place_->offset)));
        if (!ring_place_) ring_place_ = place_of(statement.tokens.front());
    }

    /// A statement that is neither a rule nor begins with a keyword.
    void refuse(const Statement& statement) {
        const Token& head = statement.tokens.front();
        const std::string_view word = text_of(head, text_);
        const bool is_run = head.kind == TokenKind::Run;
        if (head.kind == TokenKind::Unbalanced) {
            complaints_.add("grammar.unbalanced", place_of(head),
                            word == "(" ? "`(` is never closed" : "`)` was never opened");
        } else if (is_run && refuse_other_sign(statement, word)) {
            return;
        } else if (is_run && is_kind(word)) {
            complaints_.add("grammar.second-kind", place_of(head),
                            "the kind of a grammar is named once, in its first statement");
        } else if (word == "table" || word == "cycle" || word == "input") {
            complaints_.add("grammar.statement-of-other-kind", place_of(head),
                            fmt::format("an interval grammar has no `{}`", word), std::string(statement_hint));
        } else {
            const bool may_be_keyword = is_run && symbol_length(word) != word.size();
            const std::string near = may_be_keyword ? did_you_mean(word, keywords()) : std::string();
            complaints_.add("grammar.unknown-statement", place_of(head),
                            fmt::format("{} begins no statement", quoted(word)),
                            near.empty() ? std::string(statement_hint) : fmt::format("did you mean `{}`?", near));
        }
    }

    /// `L = S L`, `L : S L`, `L - > S L`, `L => S L`.
    bool refuse_other_sign(const Statement& statement, std::string_view word) {
        const bool is_symbol = symbol_length(word) == word.size();
        if (!is_symbol || statement.tokens.size() < 2) return false;
        const Token& sign = statement.tokens[1];
        if (sign.kind != TokenKind::Mark || std::string_view("=:-").find(text_[sign.begin]) == std::string_view::npos)
            return false;
        sides_.excused.emplace(word);
        complaints_.add("rule.other-arrow", place_of(sign), "a rule is written with `->`", "write `L -> S L`");
        return true;
    }

    void note_unknown(const std::optional<SymbolUse>& use) {
        if (use) unknown_.try_emplace(use->name, use->offset);
    }

    void complain_of_unknown_symbols() {
        std::vector<SymbolUse> uses;
        for (const auto& [name, offset] : unknown_)
            if (!sides_.excused.contains(std::string(name))) uses.push_back({name, offset});
        std::ranges::sort(uses, {}, &SymbolUse::offset);
        SymbolHints hints(sides_.alphabet);
        for (const SymbolUse& use : uses)
            complaints_.add("grammar.no-rule", {use.offset, use.name.size()},
                            fmt::format("{} has no rule", quoted(use.name)), hints.in_grammar(use.name));
    }

    std::string_view text_;
    Complaints& complaints_;
    LeftSides sides_;
    SymbolTable symbols_;
    LengthReader lengths_;
    std::vector<Word> images_;
    std::optional<Axiom> axiom_;
    std::optional<Complaints::Place> axiom_place_;
    std::optional<Complaints::Place> ring_place_;
    std::unordered_map<std::string_view, std::size_t> unknown_; ///< names without a rule, at their first use
    std::size_t letters_ = 0;                                   ///< letters of all words so far
};

std::size_t letters_of(const IntervalGrammar& grammar) {
    std::size_t letters = grammar.axiom ? grammar.axiom->word.size() : 0;
    for (const Word& image : grammar.rules.images()) letters += image.size();
    return letters;
}

/// Only what could be too large is printed.
void check_printed(const IntervalGrammar& grammar, std::size_t text_bytes, Complaints& complaints) {
    const std::size_t lengths = grammar.lengths.size() * 2 * max_digits;
    const std::size_t letters = letters_of(grammar) * (max_name_bytes + 1);
    if (std::max({lengths, letters, text_bytes}) < max_line_bytes / 4) return;
    check_normal_form(print(grammar), complaints);
}

} // namespace

std::optional<IntervalGrammar> read_interval_grammar(const OpenedText& opened, Complaints& complaints) {
    assert(opened.kind == GrammarKind::Intervals && opened.opening.readable);
    const std::span<const Statement> statements(opened.split.statements);
    LeftSides sides = read_left_sides(opened.split, opened.opening.first, opened.text, complaints);
    if (!sides.readable) return std::nullopt;
    StatementReader reader(opened.text, std::move(sides), complaints);
    for (std::size_t i = opened.opening.first; i < statements.size(); ++i)
        reader.read(statements[i], reader.sides().symbols[i]);
    reader.finish();
    if (complaints.empty() && reader.sides().alphabet.size() == 0)
        complaints.add("grammar.no-rules", place_of(statements.front().tokens.front()), "a grammar without rules",
                       "write one rule a line: `L -> S L`");
    if (!complaints.empty()) return std::nullopt;
    IntervalGrammar grammar = std::move(reader).grammar(opened.opening.name);
    check_printed(grammar, opened.text.size(), complaints);
    return grammar;
}

} // namespace internode
