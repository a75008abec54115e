// SPDX-License-Identifier: MIT
//
// Printing and reading of expressions over all small ones: a program without operations on literals alone comes back as
// it was, any other with its value.

#include "internode/grammar/points/parse_points.h"
#include "internode/grammar/points/print_points.h"
#include "tests/fixtures/stride.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace internode {

namespace {

/// The constant t is definition 0, the function f definition 1; formals are u and v.
constexpr std::string_view definitions = "points\nt = 3/4\nf(a, b) = a - b\n";

const PointGrammar& surroundings() {
    static const PointGrammar grammar =
        *parse_point_grammar(std::string(definitions) + "A(u, v) -> A(u, v)", "t").grammar;
    return grammar;
}

const std::vector<std::string>& formals() {
    static const std::vector<std::string> names{"u", "v"};
    return names;
}

std::optional<Expression> read_value(const std::string& text) {
    std::string grammar(definitions);
    grammar.append("A(u, v) -> A(u, ").append(text).append(")");
    const auto parsed = parse_point_grammar(grammar, "t");
    if (!parsed.grammar) return std::nullopt;
    return parsed.grammar->rules.front().successor.front().arguments[1];
}

std::optional<Expression> read_condition(const std::string& text) {
    std::string grammar(definitions);
    grammar.append("A(u, v) : ").append(text).append(" -> A(u, v)");
    const auto parsed = parse_point_grammar(grammar, "t");
    if (!parsed.grammar) return std::nullopt;
    return parsed.grammar->rules.front().condition;
}

std::size_t operands(Instruction instruction) {
    return operand_count(instruction, 2);
}

// Trees as programs: the code of the operands, then the operation.

Expression leaf(Instruction instruction) {
    return {{instruction}, {}, {}};
}

Expression number(const Rational& value) {
    return {{{Operation::Number, 0}}, {value}, {}};
}

void append(Expression& to, const Expression& operand) {
    for (Instruction instruction : operand.code) {
        if (instruction.operation == Operation::Number)
            instruction.operand += static_cast<std::uint32_t>(to.numbers.size());
        to.code.push_back(instruction);
    }
    to.numbers.insert(to.numbers.end(), operand.numbers.begin(), operand.numbers.end());
}

Expression combined(Instruction operation, const std::vector<const Expression*>& of) {
    Expression result;
    for (const Expression* operand : of) append(result, *operand);
    result.code.push_back(operation);
    return result;
}

/// Whether some + - * / or unary minus has numbers only for its operands.
bool has_foldable(const Expression& expression) {
    std::vector<bool> literal;
    for (const Instruction instruction : expression.code) {
        const std::size_t count = operands(instruction);
        bool all = count > 0;
        for (std::size_t i = 0; i < count; ++i) {
            all = all && literal.back();
            literal.pop_back();
        }
        if (all && instruction.operation >= Operation::Negate && instruction.operation <= Operation::Divide)
            return true;
        literal.push_back(instruction.operation == Operation::Number);
    }
    return false;
}

Rational floor_of(const Rational& value) {
    Integer result;
    mpz_fdiv_q(result.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
    return Rational(result);
}

/// Truths are 0 and 1; a square root is some function, different from all others. None where a division has no value.
std::optional<Rational> value_of(Instruction instruction, const std::vector<Rational>& x) {
    switch (instruction.operation) {
    case Operation::Call:
        return Rational(x[0] - x[1]);
    case Operation::Negate:
        return Rational(-x[0]);
    case Operation::Add:
        return Rational(x[0] + x[1]);
    case Operation::Subtract:
        return Rational(x[0] - x[1]);
    case Operation::Multiply:
        return Rational(x[0] * x[1]);
    case Operation::Divide:
        return sgn(x[1]) == 0 ? std::nullopt : std::optional(Rational(x[0] / x[1]));
    case Operation::Minimum:
        return std::min(x[0], x[1]);
    case Operation::Maximum:
        return std::max(x[0], x[1]);
    case Operation::Floor:
        return floor_of(x[0]);
    case Operation::Absolute:
        return Rational(abs(x[0]));
    case Operation::SquareRoot:
        return Rational(x[0] / 17 + Rational(1, 19));
    case Operation::Less:
        return Rational(x[0] < x[1] ? 1 : 0);
    case Operation::LessEqual:
        return Rational(x[0] <= x[1] ? 1 : 0);
    case Operation::Greater:
        return Rational(x[0] > x[1] ? 1 : 0);
    case Operation::GreaterEqual:
        return Rational(x[0] >= x[1] ? 1 : 0);
    case Operation::Equal:
        return Rational(x[0] == x[1] ? 1 : 0);
    case Operation::NotEqual:
        return Rational(x[0] != x[1] ? 1 : 0);
    case Operation::And:
        return Rational(x[0] * x[1]);
    case Operation::Or:
        return std::max(x[0], x[1]);
    case Operation::Not:
        return Rational(1 - x[0]);
    default:
        ADD_FAILURE() << "an operation that no test makes";
        return std::nullopt;
    }
}

std::optional<Rational> value_of(const Expression& expression) {
    std::vector<Rational> stack;
    for (const Instruction instruction : expression.code) {
        if (instruction.operation == Operation::Number) {
            stack.push_back(expression.numbers[instruction.operand]);
        } else if (instruction.operation == Operation::Formal) {
            stack.push_back(instruction.operand == 0 ? Rational(7, 3) : Rational(-5, 11));
        } else if (instruction.operation == Operation::Constant) {
            stack.emplace_back(3, 4);
        } else {
            const auto first = stack.end() - static_cast<std::ptrdiff_t>(operands(instruction));
            const std::optional<Rational> value = value_of(instruction, {first, stack.end()});
            if (!value) return std::nullopt;
            stack.erase(first, stack.end());
            stack.push_back(*value);
        }
    }
    return stack.back();
}

template<typename Read>
void expect_law(const Expression& expression, Read read) {
    const std::string text = print(expression, formals(), surroundings());
    const std::optional<Expression> again = read(text);
    if (!has_foldable(expression)) {
        ASSERT_EQ(again, expression) << text;
    } else if (value_of(expression)) {
        ASSERT_TRUE(again) << text;
        ASSERT_EQ(value_of(*again), value_of(expression)) << text;
        ASSERT_FALSE(has_foldable(*again)) << text;
    }
}

class RandomExpressions {
public:
    explicit RandomExpressions(unsigned seed)
        : draw_(seed) {}

    Expression value(std::size_t nodes) {
        if (nodes <= 1) return random_leaf();
        constexpr std::array<Operation, 4> unary{Operation::Negate, Operation::Floor, Operation::Absolute,
                                                 Operation::SquareRoot};
        constexpr std::array<Operation, 7> binary{Operation::Add,    Operation::Subtract, Operation::Multiply,
                                                  Operation::Divide, Operation::Minimum,  Operation::Maximum,
                                                  Operation::Call};
        if (nodes == 2 || draw_() % 6 == 0) {
            const Expression of = value(nodes - 1);
            return combined({unary[draw_() % unary.size()], 0}, {&of});
        }
        const std::size_t left = 1 + draw_() % (nodes - 2);
        const Expression a = value(left);
        const Expression b = value(nodes - 1 - left);
        const Operation operation = binary[draw_() % binary.size()];
        return combined({operation, operation == Operation::Call ? 1u : 0u}, {&a, &b});
    }

    Expression truth(std::size_t nodes) {
        constexpr std::array<Operation, 6> comparisons{Operation::Less,    Operation::LessEqual,
                                                       Operation::Greater, Operation::GreaterEqual,
                                                       Operation::Equal,   Operation::NotEqual};
        const std::size_t half = nodes / 2;
        if (nodes < 5) {
            const Expression a = value(half);
            const Expression b = value(nodes - half);
            return combined({comparisons[draw_() % comparisons.size()], 0}, {&a, &b});
        }
        const Expression a = truth(half);
        if (draw_() % 3 == 0) return combined({Operation::Not, 0}, {&a});
        const Expression b = truth(nodes - half);
        return combined({draw_() % 2 == 0 ? Operation::And : Operation::Or, 0}, {&a, &b});
    }

private:
    Expression random_leaf() {
        switch (draw_() % 6) {
        case 0:
            return leaf({Operation::Formal, 0});
        case 1:
            return leaf({Operation::Formal, 1});
        case 2:
            return leaf({Operation::Constant, 0});
        case 3:
            return number(Rational(static_cast<int>(1 + draw_() % 3)));
        case 4:
            return number(Rational(-2));
        default:
            return number(Rational(1, 3));
        }
    }

    std::mt19937 draw_;
};

const std::size_t all_up_to = tests::in_full() ? 7 : 5;
const int drawn = tests::times(20'000);

} // namespace

TEST(ExpressionLaw, AllSmallSumsAndProductsPrintAndReadBack) {
    std::vector<std::vector<Expression>> by_size(all_up_to + 1);
    by_size[1] = {leaf({Operation::Formal, 0}), number(Rational(2)), number(Rational(1, 2)), number(Rational(-3))};
    for (std::size_t size = 2; size <= all_up_to; ++size) {
        for (const Expression& of : by_size[size - 1]) by_size[size].push_back(combined({Operation::Negate, 0}, {&of}));
        for (const Operation operation : {Operation::Add, Operation::Subtract, Operation::Multiply, Operation::Divide})
            for (std::size_t left = 1; left + 1 < size; ++left)
                for (const Expression& a : by_size[left])
                    for (const Expression& b : by_size[size - 1 - left])
                        by_size[size].push_back(combined({operation, 0}, {&a, &b}));
        for (const Expression& expression : by_size[size]) {
            expect_law(expression, read_value);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(ExpressionLaw, RandomOnesOfEveryOperationPrintAndReadBack) {
    RandomExpressions random(7);
    for (int i = 0; i < drawn && !HasFatalFailure(); ++i)
        expect_law(random.value(static_cast<std::size_t>(1 + i % 14)), read_value);
}

TEST(ExpressionLaw, RandomConditionsPrintAndReadBack) {
    RandomExpressions random(8);
    for (int i = 0; i < drawn && !HasFatalFailure(); ++i)
        expect_law(random.truth(static_cast<std::size_t>(2 + i % 16)), read_condition);
}

TEST(ExpressionLaw, PointsPrintAndReadBack) {
    for (const std::string_view text :
         {"(u, v)", "(u, v, 1, 2, 3)", "((u, v).x, v.y)", "(u + v).x", "(-u).y", "u.x v", "2 u.w", "f(u.x, v.z)",
          "1/2 (u.x, 2) + u", "(u.x + 1) u", "u.x (v + u)", "-u.x", "min(u.x, v.y, 3)", "min(u.x, min(v.y, 3))"}) {
        const std::optional<Expression> value = read_value(std::string(text));
        ASSERT_TRUE(value) << text;
        EXPECT_EQ(print(*value, formals(), surroundings()), text);
    }
}

} // namespace internode
