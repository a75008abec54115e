// SPDX-License-Identifier: MIT
//
// The last step of reading a point grammar: from statements to the grammar. Statements are read in the order of the
// normal form: definitions, input, axiom, then rules; so letters have the same order when the normal form is read
// again. Every statement is read on its own, so that an error in one leaves the others readable.

#include "internode/grammar/points/point_reader.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/normal_form.h"
#include "internode/grammar/lexing/opening.h"
#include "internode/grammar/lexing/statement.h"
#include "internode/grammar/points/cycle_reader.h"
#include "internode/grammar/points/definition_reader.h"
#include "internode/grammar/points/module_reader.h"
#include "internode/grammar/points/point_context.h"
#include "internode/grammar/points/point_input_reader.h"
#include "internode/grammar/points/point_rule_reader.h"
#include "internode/grammar/points/print_points.h"
#include "internode/grammar/points/template_reader.h"
#include "internode/text/did_you_mean.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

constexpr std::string_view statement_hint = "a statement is a rule `P(u) < P(v) -> P(u) P(v)`, a definition `t = 1/2`, "
                                            "or begins with `ring`, `input`, `axiom`, "
                                            "`table`, `cycle` or `interpretation`";

constexpr std::string_view line_hint = "a rule ends with its line: go on after the arrow or inside parentheses, or "
                                       "begin a statement with a word or an `=`";

/// What may begin a statement below the heading.
const std::vector<std::string>& body_words() {
    static const std::vector<std::string> words{"ring", "input", "axiom", "table", "cycle", "interpretation"};
    return words;
}

class PointGrammarReader {
public:
    PointGrammarReader(std::span<const Statement> statements, PointContext& context)
        : statements_(statements)
        , context_(context) {}

    PointGrammar read() {
        read_definitions(statements_, context_);
        for (const Statement& statement : statements_)
            if (begins_with(statement, "input")) read_input(statement);
        for (const Statement& statement : statements_)
            if (begins_with(statement, "axiom")) read_axiom(statement);
        for (const Statement& statement : statements_) read_in_order(statement);
        for (const Statement& statement : statements_)
            if (begins_with(statement, "cycle")) read_cycle(statement);
        finish();
        return std::move(grammar_);
    }

private:
    void refuse(std::string_view code, Complaints::Place place, std::string message, std::string_view hint = {}) {
        context_.complaints.add(code, place, std::move(message), std::string(hint));
    }

    [[nodiscard]] std::string_view head(const Statement& statement) const {
        return text_of(statement.tokens.front(), context_.text);
    }

    [[nodiscard]] bool begins_with(const Statement& statement, std::string_view word) const {
        return !statement.arrow && head(statement) == word && !is_definition(statement, context_.text);
    }

    /// False, with a complaint, for all but the first statement of its word.
    bool is_first(const Statement& statement, std::optional<std::size_t>& first) {
        const Token& token = statement.tokens.front();
        if (first) {
            refuse("grammar.second-statement", place_of(token), fmt::format("a second `{}`", head(statement)),
                   fmt::format("the first is in line {}", context_.complaints.line_of(*first)));
            return false;
        }
        first = token.begin;
        return true;
    }

    void read_input(const Statement& statement) {
        if (is_first(statement, input_)) grammar_.input = read_point_input(statement, context_);
    }

    void read_axiom(const Statement& statement) {
        if (!is_first(statement, axiom_)) return;
        if (statement.tokens.size() == 1) {
            refuse("axiom.empty", place_of(statement.tokens), "`axiom` without modules",
                   "write `axiom P((0, 0)) P((1, 0))`");
            return;
        }
        NameScope scope(context_.definitions);
        grammar_.axiom = read_templates(statement.tokens.subspan(1), scope, context_);
    }

    void read_cycle(const Statement& statement) {
        if (is_first(statement, cycle_)) grammar_.cycle = read_cycle_items(statement, grammar_.tables, context_);
    }

    /// Statements whose meaning depends on those before them.
    void read_in_order(const Statement& statement) {
        const std::string_view word = head(statement);
        if (statement.arrow)
            read_rule(statement);
        else if (is_definition(statement, context_.text) || word == "input" || word == "axiom" || word == "cycle")
            return;
        else if (word == "ring")
            read_ring(statement);
        else if (word == "table")
            read_table(statement);
        else if (word == "interpretation")
            read_interpretation(statement);
        else if (statement.tokens.front().kind != TokenKind::Broken)
            refuse_statement(statement);
    }

    void read_rule(const Statement& statement) {
        PointRule rule = read_point_rule(statement, context_);
        ++rules_;
        if (!grammar_.interpretations.empty()) {
            grammar_.interpretations.back().push_back(std::move(rule));
            return;
        }
        if (!grammar_.tables.empty()) rule.table = static_cast<std::uint32_t>(grammar_.tables.size() - 1);
        grammar_.rules.push_back(std::move(rule));
    }

    void read_ring(const Statement& statement) {
        if (statement.tokens.size() > 1)
            refuse("grammar.stands-alone", place_of(statement.tokens.subspan(1)), "`ring` stands alone",
                   "write it on a line of its own");
        else if (is_first(statement, ring_))
            grammar_.ring = true;
    }

    void read_interpretation(const Statement& statement) {
        if (statement.tokens.size() > 1)
            refuse("grammar.stands-alone", place_of(statement.tokens.subspan(1)), "`interpretation` stands alone",
                   "its rules stand on the lines after it");
        if (grammar_.interpretations.size() == max_tables)
            refuse("interpretation.too-many", place_of(statement.tokens),
                   fmt::format("more than {} interpretations", max_tables));
        else
            grammar_.interpretations.emplace_back();
    }

    void read_table(const Statement& statement) {
        const std::span<const Token> name = statement.tokens.subspan(1);
        if (name.size() != 1 || name.front().kind != TokenKind::Run) {
            refuse("table.name", place_of(statement.tokens), "`table` needs one name",
                   "write `table p`, and its rules after it");
            return;
        }
        const std::string_view run = text_of(name.front(), context_.text);
        if (!check_name(run, place_of(name), context_.complaints)) return;
        if (!grammar_.interpretations.empty())
            refuse("table.after-interpretation", place_of(statement.tokens), "a table after `interpretation`",
                   "tables come first");
        else if (std::ranges::find(grammar_.tables, run) != grammar_.tables.end())
            refuse("table.second", place_of(name), fmt::format("a second table {}", quoted(run)),
                   "all rules of a table stand together");
        else if (grammar_.tables.size() == max_tables)
            refuse("table.too-many", place_of(name), fmt::format("more than {} tables", max_tables));
        else
            grammar_.tables.emplace_back(run);
        if (!table_) table_ = statement.tokens.front().begin;
    }

    /// A statement that is no rule, no definition and begins with no word of the language.
    void refuse_statement(const Statement& statement) {
        const Token& token = statement.tokens.front();
        const std::string_view word = head(statement);
        if (token.kind == TokenKind::Unbalanced) {
            const bool opens = word == "(" || word == "[";
            refuse("grammar.unbalanced", place_of(token),
                   fmt::format("`{}` {}", word, opens ? "is never closed" : "was never opened"));
        } else if (is_kind(word)) {
            refuse("grammar.second-kind", place_of(token),
                   "the kind of a grammar is named once, in its first statement");
        } else if (word == "length") {
            refuse("grammar.statement-of-other-kind", place_of(token), "a point grammar has no `length`",
                   statement_hint);
        } else {
            const std::string near =
                token.kind == TokenKind::Run && word.size() > 2 ? did_you_mean(word, body_words()) : std::string();
            const std::string_view hint = rules_ > 0 ? line_hint : statement_hint;
            refuse("grammar.unknown-statement", place_of(token), fmt::format("{} begins no statement", quoted(word)),
                   near.empty() ? std::string(hint) : fmt::format("did you mean `{}`?", near));
        }
    }

    void finish() {
        if (table_ && !cycle_)
            refuse("cycle.missing", {*table_, 5}, "tables without a `cycle`",
                   "say in which order they apply: `cycle p q^2`");
        if (cycle_ && !table_)
            refuse("cycle.without-tables", {*cycle_, 5}, "a `cycle` without tables",
                   "begin a table with `table p`, or leave `cycle` out");
        if (rules_ == 0 && context_.complaints.empty())
            refuse("grammar.no-rules", {0, 0}, "a grammar without rules", "write one rule a line: `P(v) -> P(v) P(v)`");
        if (!input_) context_.letters.note_made("P", 1);
        if (context_.complaints.empty()) context_.letters.finish();
        grammar_.definitions = std::move(context_.definitions).definitions();
        grammar_.arity = context_.letters.arity();
        grammar_.letters = std::move(context_.letters).letters();
    }

    std::span<const Statement> statements_;
    PointContext& context_;
    PointGrammar grammar_;
    std::size_t rules_ = 0;            ///< interpretation rules included
    std::optional<std::size_t> input_; ///< offsets of the first statement of each word
    std::optional<std::size_t> axiom_;
    std::optional<std::size_t> cycle_;
    std::optional<std::size_t> ring_;
    std::optional<std::size_t> table_;
};

/// Only what could be too large is printed.
void check_printed(const PointGrammar& grammar, const PointContext& context) {
    if (!context.repeated && context.text.size() < max_line_bytes / 8) return;
    check_normal_form(print(grammar), context.complaints);
}

} // namespace

std::optional<PointGrammar> read_point_grammar(const OpenedText& opened, Complaints& complaints) {
    assert(opened.kind == GrammarKind::Points && opened.opening.readable);
    PointContext context(opened.text, complaints);
    const std::span<const Statement> all(opened.split.statements);
    PointGrammar grammar = PointGrammarReader(all.subspan(opened.opening.first), context).read();
    grammar.name = opened.opening.name;
    if (complaints.empty()) check_printed(grammar, context);
    return grammar;
}

} // namespace internode
