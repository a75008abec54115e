// SPDX-License-Identifier: MIT

#include "internode/grammar/points/point_rule_reader.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/token_split.h"
#include "internode/grammar/points/module_reader.h"
#include "internode/grammar/points/template_reader.h"

#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

using Tokens = std::span<const Token>;

constexpr std::string_view rule_hint = "a rule is `label : left < module > right : condition -> successor : weight`";

class PointRuleReader {
public:
    PointRuleReader(const Statement& statement, PointContext& context)
        : left_side_(statement.tokens.first(*statement.arrow))
        , right_side_(statement.tokens.subspan(*statement.arrow + 1))
        , arrow_(place_of(statement.tokens[*statement.arrow]))
        , context_(context)
        , scope_(context.definitions) {
        const Complaints::Place place = place_of(statement.tokens);
        rule_.place = SourcePlace{place.offset, place.bytes};
    }

    PointRule read() {
        read_left_side();
        rule_.formals = scope_.formals();
        read_right_side();
        return std::move(rule_);
    }

private:
    void refuse(std::string_view code, Complaints::Place place, std::string message, std::string_view hint = {}) {
        context_.complaints.add(code, place, std::move(message), std::string(hint));
    }
    /// A formal may be missing: names without a meaning are taken for it.
    void refuse_pattern(std::string_view code, Complaints::Place place, std::string message,
                        std::string_view hint = {}) {
        refuse(code, place, std::move(message), hint);
        scope_.accept(UnknownNames::AreFormals);
    }

    void read_left_side() {
        const std::vector<std::size_t> colons = find_outside(left_side_, context_.text, ':');
        if (colons.size() > 2) {
            refuse_pattern("rule.third-colon", place_of(left_side_[colons[2]]), "a third `:` before the arrow",
                           rule_hint);
            return;
        }
        const std::vector<Tokens> parts = split_at(left_side_, colons);
        const bool has_label = colons.size() == 2 || (colons.size() == 1 && is_label(parts[0], parts[1]));
        if (has_label) read_label(parts[0], place_of(left_side_[colons[0]]));
        read_pattern(parts[has_label ? 1 : 0]);
        if (has_label && colons.size() == 1) doubt_label();
        if (colons.size() == (has_label ? 2u : 1u)) read_condition(parts.back(), place_of(left_side_[colons.back()]));
    }

    [[nodiscard]] bool is_label(Tokens first, Tokens second) const {
        const bool one_name = first.size() == 1 && first.front().kind == TokenKind::Run;
        return one_name && !(second.size() > 1 && is_mark(second.front(), context_.text, '('));
    }

    void read_label(Tokens tokens, Complaints::Place colon) {
        if (tokens.empty()) {
            refuse("rule.no-label", colon, "no label before `:`", rule_hint);
        } else if (tokens.size() > 1 || tokens.front().kind != TokenKind::Run) {
            refuse("rule.label", place_of(tokens), "a label is one name", rule_hint);
        } else {
            const std::string_view name = text_of(tokens.front(), context_.text);
            if (check_name(name, place_of(tokens), context_.complaints)) rule_.label = name;
        }
    }

    /// `E : n > 2 -> F` names a rule E for a module n: where n is a constant, a condition was meant.
    void doubt_label() {
        for (const RawModule& module : read_)
            if (module.parameters.empty() && context_.definitions.announced(module.letter))
                refuse(
                    "rule.constant-as-module", module.place,
                    fmt::format("{} is a constant, here a module", quoted(module.letter)),
                    "after a single name `:` begins the rule; a condition stands in parentheses: `E : (n > 2) -> F`");
    }

    void read_pattern(Tokens tokens) {
        const std::vector<std::size_t> left = find_outside(tokens, context_.text, '<');
        const std::vector<std::size_t> right = find_outside(tokens, context_.text, '>');
        if (left.size() > 1 || right.size() > 1) {
            refuse_pattern("rule.second-context", place_of(tokens[left.size() > 1 ? left[1] : right[1]]),
                           fmt::format("a second `{}` before the arrow", left.size() > 1 ? '<' : '>'), rule_hint);
            return;
        }
        if (!left.empty() && !right.empty() && right[0] < left[0]) {
            refuse_pattern("rule.contexts-swapped", place_of(tokens[right[0]]), "`>` before `<`", rule_hint);
            return;
        }
        const std::size_t begin = left.empty() ? 0 : left[0] + 1;
        const std::size_t end = right.empty() ? tokens.size() : right[0];
        if (!left.empty()) rule_.left = read_part(tokens.first(left[0]), place_of(tokens[left[0]]), "left context");
        rule_.predecessor = read_part(tokens.subspan(begin, end - begin), arrow_, "module to rewrite");
        if (!right.empty())
            rule_.right = read_part(tokens.subspan(end + 1), place_of(tokens[right[0]]), "right context");
        check_size(tokens);
    }

    void check_size(Tokens tokens) {
        const std::size_t modules = rule_.left.size() + rule_.predecessor.size() + rule_.right.size();
        if (modules > max_predecessor_modules && !damaged_)
            refuse("rule.too-many-modules", place_of(tokens),
                   fmt::format("{} modules before the arrow, more than {}", modules, max_predecessor_modules));
        std::size_t& used = context_.budget.modules;
        if (modules > max_point_modules - used)
            refuse("module.too-many", place_of(tokens),
                   fmt::format("more than {} modules in one grammar", max_point_modules));
        else
            used += modules;
    }

    std::vector<Symbol> read_part(Tokens tokens, Complaints::Place near, std::string_view what) {
        std::vector<Symbol> letters;
        if (tokens.empty()) {
            refuse_pattern("rule.empty-part", near, fmt::format("no {}", what), rule_hint);
            return letters;
        }
        RawModules read = read_modules(tokens, ModulePlace::Pattern, context_.text, context_.complaints);
        if (read.damaged) {
            scope_.accept(UnknownNames::AreFormals);
            damaged_ = true;
        }
        for (RawModule& module : read.modules) {
            letters.push_back(
                context_.letters.use(module.letter, module.parameters.size(), LetterTable::Use::Asked, module.place));
            for (const Tokens parameter : module.parameters) read_formal(parameter);
            read_.push_back(std::move(module));
        }
        return letters;
    }

    void read_formal(Tokens tokens) {
        const Complaints::Place place = place_of(tokens);
        const std::string_view fragment = context_.text.substr(place.offset, place.bytes);
        if (tokens.size() > 1 || tokens.front().kind != TokenKind::Run || !is_name(fragment)) {
            refuse_pattern(
                "rule.no-parameter", place, fmt::format("{} is no name of a parameter", quoted(fragment)),
                "before the arrow a parameter is a name; to compare, write a condition: `P(x) : x == 1 -> ...`");
        } else if (!check_name(fragment, place, context_.complaints)) {
            scope_.accept(UnknownNames::AreFormals);
        } else if (!scope_.add_formal(fragment)) {
            refuse("name.second-parameter", place, fmt::format("a second parameter {}", quoted(fragment)),
                   "all names of a rule differ; to compare, write a condition: `A(x) < B(y) : x == y -> ...`");
        }
    }

    void read_condition(Tokens tokens, Complaints::Place colon) {
        if (tokens.empty()) {
            refuse("rule.no-condition", colon, "no condition after `:`", rule_hint);
            return;
        }
        ExpressionContext expressions = context_.expressions(scope_);
        // After a single letter the normal form puts the condition in parentheses.
        const bool has_some = is_mark(tokens.front(), context_.text, '(') && !closes_at_end(tokens);
        expressions.levels = rule_.label.empty() && read_.size() == 1 && has_some ? 1 : 0;
        rule_.condition = read_expression(tokens, Wanted::Truth, expressions);
    }

    /// Whether the parenthesis at the begin closes at the end.
    [[nodiscard]] bool closes_at_end(Tokens tokens) const {
        std::size_t depth = 0;
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            if (is_mark(tokens[i], context_.text, '(')) ++depth;
            if (is_mark(tokens[i], context_.text, ')') && --depth == 0) return i + 1 == tokens.size();
        }
        return false;
    }

    void read_right_side() {
        const std::vector<std::size_t> colons = find_outside(right_side_, context_.text, ':');
        const Tokens successor = colons.empty() ? right_side_ : right_side_.first(colons[0]);
        read_successor(successor);
        if (!colons.empty()) read_weight(right_side_.subspan(colons[0] + 1), place_of(right_side_[colons[0]]));
    }

    void read_successor(Tokens tokens) {
        const bool is_empty = tokens.size() == 1 && (tokens.front().kind == TokenKind::Epsilon ||
                                                     is_mark(tokens.front(), context_.text, '.'));
        if (is_empty) return;
        if (tokens.empty())
            refuse("rule.empty-successor", arrow_, "an empty successor", "a module that vanishes becomes `.`");
        else
            rule_.successor = read_templates(tokens, scope_, context_);
    }

    void read_weight(Tokens tokens, Complaints::Place colon) {
        if (tokens.empty()) {
            refuse("rule.no-weight", colon, "no weight after `:`",
                   "a condition stands before the arrow, a weight at the end");
            return;
        }
        ExpressionContext expressions = context_.expressions(scope_);
        rule_.weight = read_expression(tokens, Wanted::Number, expressions);
        const bool is_literal =
            rule_.weight && rule_.weight->code.front().operation == Operation::Number && rule_.weight->code.size() == 1;
        if (is_literal && sgn(rule_.weight->numbers.front()) <= 0)
            refuse("rule.weight-not-positive", place_of(tokens), "a weight must be positive",
                   "leave the rule out if it never applies");
    }

    Tokens left_side_;
    Tokens right_side_;
    Complaints::Place arrow_;
    PointContext& context_;
    NameScope scope_;
    PointRule rule_;
    std::vector<RawModule> read_; ///< modules of the pattern
    bool damaged_ = false;        ///< modules of the pattern may lack
};

} // namespace

PointRule read_point_rule(const Statement& statement, PointContext& context) {
    assert(statement.arrow);
    return PointRuleReader(statement, context).read();
}

} // namespace internode
