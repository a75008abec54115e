// SPDX-License-Identifier: MIT
//
// A postfix program is printed with a stack of texts, each with the strength of its outermost operation. Parentheses
// stand where the strength asks for them, and where digits on both sides of `/` would be read as one number: the
// quotient of x * 2 by 3 is `x * (2)/3`.

#include "internode/grammar/expressions/print_expression.h"

#include "internode/grammar/expressions/expression_symbols.h"
#include "internode/grammar/expressions/name_scope.h"

#include <cassert>
#include <optional>
#include <vector>

namespace internode {

namespace {

struct Printed {
    std::string text;
    int strength = primary_precedence;
    std::optional<Operation> last; ///< the outermost operation, where it is not in parentheses
    std::size_t literal_tail = 0;  ///< bytes of an integer at the end of a product
    bool fraction = false;         ///< a literal with a denominator, perhaps with a sign before it
};

bool is_integer(const Printed& printed) {
    return !printed.last && !printed.fraction && printed.text.find_first_not_of("-0123456789") == std::string::npos;
}

std::string in_parentheses(std::string text) {
    text.insert(text.begin(), '(');
    text += ')';
    return text;
}

class ExpressionPrinter {
public:
    ExpressionPrinter(const Expression& expression, std::span<const std::string> formals,
                      std::span<const Definition> definitions)
        : expression_(expression)
        , formals_(formals)
        , definitions_(definitions) {}

    std::string print() && {
        for (const Instruction& instruction : expression_.code) push(instruction);
        assert(stack_.size() == 1);
        return std::move(stack_.back().text);
    }

private:
    void push(Instruction instruction) {
        switch (instruction.operation) {
        case Operation::Number:
            push_number(expression_.numbers[instruction.operand]);
            break;
        case Operation::Formal:
            assert(instruction.operand < formals_.size());
            push_primary(formals_[instruction.operand]);
            break;
        case Operation::Constant:
            assert(instruction.operand < definitions_.size());
            push_primary(definitions_[instruction.operand].name);
            break;
        case Operation::Call:
            push_call(definitions_[instruction.operand]);
            break;
        case Operation::Point:
            push_list("(", instruction.operand);
            break;
        case Operation::Coordinate:
            push_coordinate(instruction.operand);
            break;
        case Operation::Minimum:
        case Operation::Maximum:
            push_extremum(instruction.operation);
            break;
        case Operation::Floor:
        case Operation::Absolute:
        case Operation::SquareRoot:
            push_list(std::string(sign_of(instruction.operation)) + '(', 1);
            break;
        case Operation::Negate:
        case Operation::Not:
            push_prefix(instruction.operation);
            break;
        default:
            push_binary(instruction.operation);
        }
    }

    void push_primary(std::string text) {
        stack_.push_back({std::move(text), primary_precedence, std::nullopt, 0, false});
    }

    void push_number(const Rational& value) {
        push_primary(to_string(value));
        stack_.back().fraction = value.get_den() != 1;
    }

    Printed pop() {
        assert(!stack_.empty());
        Printed last = std::move(stack_.back());
        stack_.pop_back();
        return last;
    }

    static std::string at_least(int strength, Printed operand) {
        return operand.strength < strength ? in_parentheses(std::move(operand.text)) : std::move(operand.text);
    }

    /// The last `count` values, separated by commas, after an opening parenthesis.
    void push_list(std::string text, std::size_t count) {
        assert(count > 0 && count <= stack_.size());
        const std::size_t first = stack_.size() - count;
        for (std::size_t i = first; i < stack_.size(); ++i) text += (i == first ? "" : ", ") + stack_[i].text;
        stack_.resize(first);
        push_primary(text + ')');
    }

    void push_call(const Definition& function) { push_list(function.name + '(', function.formals.size()); }

    /// A chain of minima from the left is one call.
    void push_extremum(Operation operation) {
        const Printed second = pop();
        Printed first = pop();
        if (first.last == operation)
            first.text.back() = ',';
        else
            first.text = std::string(sign_of(operation)) + '(' + first.text + ',';
        first.text += ' ' + second.text + ')';
        stack_.push_back({std::move(first.text), primary_precedence, operation, 0, false});
    }

    void push_coordinate(std::size_t index) {
        assert(index < 4);
        std::string text = at_least(primary_precedence, pop());
        text += '.';
        text += "xyzw"[index];
        push_primary(std::move(text));
    }

    void push_prefix(Operation operation) {
        const int strength = precedence(operation);
        Printed operand = pop();
        const bool fraction = operand.fraction;
        std::string text = operation == Operation::Not ? "not " : "-";
        text += at_least(strength, std::move(operand));
        stack_.push_back({std::move(text), strength, operation, 0, fraction});
    }

    void push_binary(Operation operation) {
        const int strength = precedence(operation);
        Printed right = pop();
        Printed left = pop();
        const bool is_product = operation == Operation::Multiply;
        const bool is_quotient = operation == Operation::Divide;
        if (is_quotient && left.literal_tail > 0 && is_integer(right) && right.text.front() != '-')
            left.text = left.text.substr(0, left.text.size() - left.literal_tail) +
                        in_parentheses(left.text.substr(left.text.size() - left.literal_tail));
        const std::size_t tail = is_product && is_integer(right) ? right.text.size() : 0;
        // Comparisons do not chain, and what groups from the left needs parentheses on the right.
        const bool is_comparison = strength == precedence(Operation::Less);
        const bool is_bare_fraction = is_quotient && right.fraction;
        const bool left_is_quotient = left.last == Operation::Divide && left.strength >= strength;
        std::string text = at_least(is_comparison ? strength + 1 : strength, std::move(left));
        const std::string other =
            is_bare_fraction ? in_parentheses(std::move(right.text)) : at_least(strength + 1, std::move(right));
        const bool joins = is_product && !left_is_quotient && (is_name(other) || other.front() == '(');
        text += joins ? " " : spaced(operation);
        text += other;
        stack_.push_back({std::move(text), strength, operation, tail, false});
    }

    static std::string spaced(Operation operation) {
        if (operation == Operation::Divide) return "/";
        return ' ' + std::string(sign_of(operation)) + ' ';
    }

    const Expression& expression_;
    std::span<const std::string> formals_;
    std::span<const Definition> definitions_;
    std::vector<Printed> stack_;
};

} // namespace

std::string print(const Expression& expression, std::span<const std::string> formals,
                  std::span<const Definition> definitions) {
    return ExpressionPrinter(expression, formals, definitions).print();
}

} // namespace internode
