// SPDX-License-Identifier: MIT

#include "internode/grammar/expressions/expression_reader.h"

#include "internode/grammar/expressions/expression_symbols.h"
#include "internode/grammar/expressions/unknown_name.h"
#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/lexing/token_cursor.h"

#include <cassert>
#include <vector>

#include <fmt/format.h>

namespace internode {

namespace {

/// What waits on the stack for its operands or its closing parenthesis.
struct Pending {
    enum class Shape { Open, Call, Prefix, Binary };
    Shape shape = Shape::Open;
    Operation operation = Operation::Call; ///< operation of a built-in function; Operation::Call for a defined one
    std::uint32_t definition = 0;
    std::size_t commas = 0;
    Complaints::Place place;
    std::string_view name; ///< name of the function that is called
};

class ExpressionReader {
public:
    ExpressionReader(std::span<const Token> tokens, ExpressionContext& context)
        : context_(context)
        , builder_(context.budget, context.complaints)
        , cursor_(tokens, context.text)
        , whole_(place_of(tokens))
        , nesting_(context.levels) {}

    std::optional<Expression> read(Wanted wanted) {
        while (sound_ && !cursor_.at_end()) {
            if (expects_operand_)
                read_operand();
            else
                read_operator();
        }
        if (sound_) finish(wanted);
        if (!sound_) return std::nullopt;
        return std::move(builder_).expression(whole_);
    }

private:
    using Place = Complaints::Place;

    void refuse(std::string_view code, Place place, std::string message, std::string_view hint = {}) {
        context_.complaints.add(code, place, std::move(message), std::string(hint));
        sound_ = false;
    }
    void keep(bool sound) { sound_ = sound_ && sound; }

    // Operands.

    void read_operand() {
        if (cursor_.at_mark('(')) {
            push({Pending::Shape::Open, {}, 0, 0, cursor_.place(), {}});
            cursor_.next();
        } else if (cursor_.at_mark('-')) {
            push({Pending::Shape::Prefix, Operation::Negate, 0, 0, cursor_.place(), {}});
            cursor_.next();
        } else if (end_of_number(cursor_) > cursor_.offset()) {
            read_number();
        } else if (cursor_.is_run() && is_name(cursor_.rest())) {
            read_name();
        } else {
            refuse_operand();
        }
    }

    void push(Pending pending) {
        if (pending.shape != Pending::Shape::Binary) {
            check_nesting(nesting_ + 1, pending.place);
            ++nesting_;
        }
        pending_.push_back(pending);
    }

    void check_nesting(std::size_t levels, Place place) {
        if (sound_ && levels > max_nesting)
            refuse("expression.too-deep", place,
                   fmt::format("more than {} levels of parentheses and signs", max_nesting),
                   "name a part: `a = 1/2 + t`");
    }

    [[nodiscard]] bool is_divisor() const {
        auto top = pending_.rbegin();
        while (top != pending_.rend() && top->shape == Pending::Shape::Prefix) ++top;
        return top != pending_.rend() && top->shape == Pending::Shape::Binary && top->operation == Operation::Divide;
    }

    /// `3/4` is one number, unless a division wants only the 3.
    void read_number() {
        const std::size_t begin = cursor_.offset();
        Rational value = take_number();
        std::size_t end = end_;
        if (sound_ && !is_divisor() && is_fraction_ahead()) {
            cursor_.next();
            const Rational divisor = take_number();
            end = end_;
            if (sound_ && sgn(divisor) == 0)
                refuse("expression.division-by-zero", {begin, end - begin}, "a division by zero");
            if (sound_) value /= divisor;
        }
        // The normal form writes a fraction after `/` in parentheses.
        if (is_divisor() && value.get_den() != 1) check_nesting(nesting_ + 1, {begin, end - begin});
        if (sound_) keep(builder_.number(std::move(value), {begin, end - begin}));
        expects_operand_ = false;
    }

    [[nodiscard]] bool is_fraction_ahead() const {
        if (!cursor_.at_mark('/')) return false;
        const bool begins = cursor_.is_run(1) || cursor_.at_mark('.', 1);
        return begins && end_of_number(cursor_, 1) > cursor_.offset_ahead(1);
    }

    Rational take_number() {
        const std::size_t begin = cursor_.offset();
        end_ = end_of_number(cursor_);
        const std::string_view digits = context_.text.substr(begin, end_ - begin);
        std::optional<Rational> value = parse_rational(digits);
        if (!value)
            refuse("expression.too-many-digits", {begin, end_ - begin},
                   fmt::format("a number of more than {} digits", max_digits));
        cursor_.move_to(end_);
        return value ? *std::move(value) : Rational(0);
    }

    void read_name() {
        const std::string_view name = cursor_.rest();
        const Place place = cursor_.place();
        const bool touches_number = cursor_.offset() == end_;
        cursor_.next();
        expects_operand_ = false;
        if (name == "not") {
            push({Pending::Shape::Prefix, Operation::Not, 0, 0, place, {}});
            expects_operand_ = true;
            return;
        }
        if (name == "and" || name == "or") {
            refuse("expression.nothing-on-left", place, fmt::format("`{}` has nothing on its left", name));
            return;
        }
        if (const std::optional<Operation> function = builtin_function(name)) {
            open_call(*function, 0, place, name);
            return;
        }
        const NameMeaning meaning = context_.scope.find(name);
        if (meaning.kind == NameMeaning::Kind::Formal)
            keep(builder_.formal(meaning.index, place));
        else if (meaning.kind == NameMeaning::Kind::Constant)
            keep(builder_.constant(meaning.index, place));
        else if (meaning.kind == NameMeaning::Kind::Function)
            open_call(Operation::Call, meaning.index, place, name);
        else
            refuse_name({name, place, cursor_.at_mark('('), touches_number});
    }

    void open_call(Operation operation, std::uint32_t definition, Place place, std::string_view name) {
        if (!cursor_.at_mark('(')) {
            refuse("expression.function-without-arguments", place, fmt::format("{} is a function", quoted(name)),
                   fmt::format("write {}", sample_call(operation, definition, name)));
            return;
        }
        push({Pending::Shape::Call, operation, definition, 0, place, name});
        cursor_.next();
        expects_operand_ = true;
    }

    [[nodiscard]] std::string sample_call(Operation operation, std::uint32_t definition, std::string_view name) const {
        if (operation != Operation::Call)
            return operand_count({operation, 0}, 0) == 1 ? fmt::format("`{}(x)`", name)
                                                         : fmt::format("`{}(x, y)`", name);
        const std::vector<std::string>& formals = context_.scope.table()[definition].formals;
        return fmt::format("`{}({}{})`", name, formals.front(), formals.size() > 1 ? ", ..." : "");
    }

    void refuse_name(const UnknownName& name) {
        complain_of(name, context_.scope, context_.searches, context_.complaints);
        sound_ = false;
    }

    void refuse_operand() {
        const Token& token = cursor_.token();
        const std::string_view fragment = cursor_.rest();
        if (token.kind == TokenKind::Broken) {
            sound_ = false; // complained about where the tokens are made
        } else if (token.kind == TokenKind::Unbalanced) {
            refuse_unbalanced();
        } else if (cursor_.at_mark('+')) {
            refuse("expression.plus-sign", cursor_.place(), "a sign `+` before a value", "leave it out");
        } else if (cursor_.at_mark(')') || cursor_.at_mark(',')) {
            const bool is_empty = !pending_.empty() && pending_.back().shape != Pending::Shape::Binary;
            refuse(is_empty ? "expression.empty" : "expression.nothing-on-right", cursor_.place(),
                   is_empty ? "nothing where a value is wanted" : "an operation without its right side");
        } else {
            refuse("expression.no-value", cursor_.place(), fmt::format("{} where a value is wanted", quoted(fragment)),
                   hint_for_sign(fragment));
        }
    }

    void refuse_unbalanced() {
        const std::string_view bracket = cursor_.rest();
        const bool opens = bracket == "(" || bracket == "[";
        refuse("grammar.unbalanced", cursor_.place(),
               fmt::format("`{}` {}", bracket, opens ? "is never closed" : "was never opened"));
    }

    // Operators.

    void read_operator() {
        if (cursor_.is_run() || cursor_.at_mark('(')) {
            read_word_or_product();
        } else if (cursor_.at_mark(',')) {
            comma();
        } else if (cursor_.at_mark(')')) {
            close();
        } else if (cursor_.at_mark('.')) {
            read_coordinate();
        } else if (const auto found = find_binary_sign(cursor_)) {
            const Place place{cursor_.offset(), found->bytes};
            cursor_.move_to(place.offset + place.bytes);
            push_binary(found->operation, place);
        } else {
            refuse_operator();
        }
    }

    void read_word_or_product() {
        const std::string_view word = cursor_.rest();
        const Place place = cursor_.place();
        if (word == "and" || word == "or") {
            cursor_.next();
            push_binary(word == "and" ? Operation::And : Operation::Or, place);
            return;
        }
        if (word != "(" && !is_name(word)) {
            refuse("expression.two-values", place, fmt::format("{} follows a value", quoted(word)),
                   "write `*` before a number: `v * 2`, or `2 v`");
            return;
        }
        if (word == "not") {
            refuse("expression.two-values", place, "`not` follows a value", "write `x < 1 and not y < 1`");
            return;
        }
        reduce(precedence(Operation::Multiply));
        if (!sound_) return;
        if (builder_.ends_in_quotient()) {
            const std::size_t begin = builder_.last_place().offset;
            refuse("expression.ambiguous-quotient", {begin, place.offset + place.bytes - begin},
                   "a quotient, then a factor: is it below the line?",
                   "write `a/b * c` or `a/(b c)`; `1/2 v` is half of v");
            return;
        }
        push({Pending::Shape::Binary, Operation::Multiply, 0, 0, place, {}});
        expects_operand_ = true;
    }

    void push_binary(Operation operation, Place place) {
        reduce(precedence(operation));
        push({Pending::Shape::Binary, operation, 0, 0, place, {}});
        expects_operand_ = true;
    }

    /// Applies what waits and binds at least as strongly.
    void reduce(int strength) {
        while (sound_ && !pending_.empty()) {
            const Pending top = pending_.back();
            const bool is_operation = top.shape == Pending::Shape::Prefix || top.shape == Pending::Shape::Binary;
            if (!is_operation || precedence(top.operation) < strength) return;
            pending_.pop_back();
            if (top.shape == Pending::Shape::Prefix) --nesting_;
            keep(builder_.apply(top.operation, top.place));
        }
    }

    void comma() {
        reduce(0);
        if (!sound_) return;
        if (pending_.empty()) {
            refuse("expression.comma", cursor_.place(), "`,` outside parentheses", "a point is written `(x, y)`");
            return;
        }
        Pending& top = pending_.back();
        ++top.commas;
        cursor_.next();
        expects_operand_ = true;
        const bool is_chain = top.operation == Operation::Minimum || top.operation == Operation::Maximum;
        if (top.shape == Pending::Shape::Call && is_chain && top.commas > 1)
            keep(builder_.apply(top.operation, top.place));
    }

    void close() {
        reduce(0);
        if (!sound_) return;
        if (pending_.empty()) {
            refuse("grammar.unbalanced", cursor_.place(), "`)` was never opened");
            return;
        }
        const Pending top = pending_.back();
        pending_.pop_back();
        --nesting_;
        const std::size_t end = cursor_.offset() + 1;
        cursor_.next();
        if (top.shape == Pending::Shape::Call)
            finish_call(top, top.commas + 1);
        else if (top.commas > 0)
            keep(builder_.point(top.commas + 1, top.place));
        if (sound_) builder_.enclose(top.place.offset, end);
    }

    void finish_call(const Pending& call, std::size_t arguments) {
        assert(call.shape == Pending::Shape::Call && arguments > 0);
        const bool is_defined = call.operation == Operation::Call;
        const bool is_chain = call.operation == Operation::Minimum || call.operation == Operation::Maximum;
        const std::size_t arity =
            is_defined ? context_.scope.table()[call.definition].formals.size() : operand_count({call.operation, 0}, 0);
        if (is_chain ? arguments < 2 : arguments != arity)
            refuse("expression.wrong-arity", call.place,
                   fmt::format("{} takes {}{} argument{}, not {}", quoted(call.name), is_chain ? "at least " : "",
                               arity, arity == 1 ? "" : "s", arguments));
        else
            keep(is_defined ? builder_.call(call.definition, arity) : builder_.apply(call.operation, call.place));
    }

    void read_coordinate() {
        const std::size_t begin = cursor_.offset();
        cursor_.next();
        const std::string_view name = cursor_.is_run() ? cursor_.rest() : std::string_view();
        const std::size_t index = std::string_view("xyzw").find(name.empty() ? '?' : name.front());
        const Place place{begin, 1 + name.size()};
        if (name.size() != 1 || index == std::string_view::npos) {
            refuse("expression.no-coordinate", place,
                   fmt::format("{} is no coordinate", quoted(context_.text.substr(begin, place.bytes))),
                   "`.x`, `.y`, `.z`, `.w` are the coordinates of a point");
            return;
        }
        cursor_.next();
        keep(builder_.coordinate(static_cast<std::uint32_t>(index), place));
    }

    void refuse_operator() {
        const std::string_view fragment = cursor_.rest();
        if (cursor_.token().kind == TokenKind::Broken)
            sound_ = false;
        else if (cursor_.token().kind == TokenKind::Unbalanced)
            refuse_unbalanced();
        else
            refuse("expression.foreign-sign", cursor_.place(),
                   fmt::format("{} has no meaning in an expression", quoted(fragment)), hint_for_sign(fragment));
    }

    void finish(Wanted wanted) {
        const Place last{whole_.offset + whole_.bytes, 0};
        if (expects_operand_) {
            refuse("expression.nothing-on-right", last, "an operation without its right side");
            return;
        }
        reduce(0);
        if (!sound_) return;
        if (!pending_.empty()) { // its partner went to another statement
            refuse("grammar.unbalanced", pending_.back().place, "`(` is never closed");
            return;
        }
        const ValueKind kind = builder_.kind();
        if (wanted == Wanted::Truth && kind != ValueKind::Truth)
            refuse("expression.number-for-truth", whole_, "a number where a condition is wanted",
                   "a condition compares: `x < 2`, `x == 0 and y != 1`");
        else if (wanted != Wanted::Truth && kind == ValueKind::Truth)
            refuse("expression.truth-for-number", whole_, "a condition where a value is wanted");
        else if (wanted == Wanted::Number && kind == ValueKind::Point)
            refuse("expression.point-for-number", whole_, "a point where a number is wanted",
                   "`.x`, `.y`, `.z`, `.w` are its coordinates");
    }

    ExpressionContext& context_;
    ExpressionBuilder builder_;
    TokenCursor cursor_;
    Place whole_;
    std::size_t nesting_; ///< entries of pending_ that are no binary operations
    std::vector<Pending> pending_;
    std::size_t end_ = 0; ///< where the last number ends
    bool expects_operand_ = true;
    bool sound_ = true;
};

} // namespace

std::optional<Expression> read_expression(std::span<const Token> tokens, Wanted wanted, ExpressionContext& context) {
    assert(!tokens.empty());
    return ExpressionReader(tokens, context).read(wanted);
}

} // namespace internode
