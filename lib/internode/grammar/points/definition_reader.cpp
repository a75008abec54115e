// SPDX-License-Identifier: MIT

#include "internode/grammar/points/definition_reader.h"

#include "internode/grammar/lexing/limits.h"

#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

using Tokens = std::span<const Token>;

/// The index of `=` after the name and its parentheses; 0 if there is none.
std::size_t find_equals(Tokens tokens, std::string_view text) {
    std::size_t i = 1;
    if (tokens.size() > 1 && is_mark(tokens[1], text, '(')) {
        while (i < tokens.size() && !is_mark(tokens[i], text, ')') && !is_mark(tokens[i], text, '=')) ++i;
        if (i < tokens.size() && is_mark(tokens[i], text, ')')) ++i;
    }
    return i < tokens.size() && is_mark(tokens[i], text, '=') ? i : 0;
}

class DefinitionReader {
public:
    DefinitionReader(const Statement& statement, PointContext& context)
        : tokens_(statement.tokens)
        , equals_(find_equals(tokens_, context.text))
        , context_(context)
        , scope_(context.definitions) {}

    void read() {
        const Token& head = tokens_.front();
        const std::string_view name = text_of(head, context_.text);
        if (!check_name(name, place_of(head), context_.complaints)) return;
        if (context_.definitions.find(name).kind != NameMeaning::Kind::Unknown) {
            refuse("definition.second", place_of(head), fmt::format("a second definition of {}", quoted(name)),
                   fmt::format("the first is in line {}",
                               context_.complaints.line_of(*context_.definitions.announced(name))));
            return;
        }
        if (context_.definitions.size() == max_definitions) {
            refuse("definition.too-many", place_of(head),
                   fmt::format("more than {} constants and functions", max_definitions));
            return;
        }
        if (equals_ > 1) read_formals(tokens_.subspan(1, equals_ - 1));
        Definition definition{std::string(name), scope_.formals(), read_value(), {}};
        const Complaints::Place place = place_of(tokens_);
        definition.place = SourcePlace{place.offset, place.bytes};
        context_.definitions.add(std::move(definition));
    }

private:
    void refuse(std::string_view code, Complaints::Place place, std::string message, std::string_view hint = {}) {
        context_.complaints.add(code, place, std::move(message), std::string(hint));
    }

    /// `(s, t)`, with the parentheses.
    void read_formals(Tokens tokens) {
        for (std::size_t i = 0; i + 1 < tokens.size(); i += 2) {
            const Token& formal = tokens[i + 1];
            const bool begins_well = is_mark(tokens[i], context_.text, i == 0 ? '(' : ',');
            if (!begins_well || formal.kind != TokenKind::Run) {
                refuse("definition.parameters", place_of(tokens), "the parameters of a function are names",
                       "write `f(s, t) = ...`");
                scope_.accept(UnknownNames::AreFormals);
                return;
            }
            read_formal(formal);
        }
        if (scope_.formals().size() > max_parameters)
            refuse("definition.too-many-parameters", place_of(tokens),
                   fmt::format("a function of {} parameters, more than {}", scope_.formals().size(), max_parameters));
    }

    void read_formal(const Token& token) {
        const std::string_view name = text_of(token, context_.text);
        if (!check_name(name, place_of(token), context_.complaints))
            scope_.accept(UnknownNames::AreFormals);
        else if (!scope_.add_formal(name))
            refuse("name.second-parameter", place_of(token), fmt::format("a second parameter {}", quoted(name)),
                   "all names differ");
    }

    /// After a complaint the number 0, so that the name is known.
    Expression read_value() {
        assert(equals_ > 0 && equals_ < tokens_.size());
        const Tokens value = tokens_.subspan(equals_ + 1);
        if (value.empty()) {
            refuse("definition.no-value", place_of(tokens_[equals_]), "no value after `=`", "write `t = 1/2`");
        } else {
            ExpressionContext expressions = context_.expressions(scope_);
            if (auto read = read_expression(value, Wanted::Number, expressions)) return *std::move(read);
        }
        return {{{Operation::Number, 0}}, {Rational(0)}, {}};
    }

    Tokens tokens_;
    std::size_t equals_;
    PointContext& context_;
    NameScope scope_;
};

} // namespace

bool is_definition(const Statement& statement, std::string_view text) {
    const bool begins_with_run = statement.tokens.front().kind == TokenKind::Run;
    return !statement.arrow && begins_with_run && find_equals(statement.tokens, text) > 0;
}

void read_definitions(std::span<const Statement> statements, PointContext& context) {
    for (const Statement& statement : statements)
        if (is_definition(statement, context.text))
            context.definitions.announce(text_of(statement.tokens.front(), context.text),
                                         statement.tokens.front().begin);
    for (const Statement& statement : statements)
        if (is_definition(statement, context.text)) DefinitionReader(statement, context).read();
}

} // namespace internode
