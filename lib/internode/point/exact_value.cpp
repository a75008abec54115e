// SPDX-License-Identifier: MIT

#include "internode/point/exact_value.h"

#include <algorithm>
#include <cassert>

namespace internode {
namespace {

using Entry = std::variant<Rational, PointSum, bool>;

bool is_long(const Rational& number) {
    return mpz_sizeinbase(number.get_num_mpz_t(), 2) > max_exact_bits ||
           mpz_sizeinbase(number.get_den_mpz_t(), 2) > max_exact_bits;
}

PointSum scaled(PointSum sum, const Rational& factor) {
    if (factor == 0) return {};
    for (auto& term : sum.terms) term.second *= factor;
    return sum;
}

/// a + sign b.
PointSum added(const PointSum& a, const PointSum& b, int sign) {
    PointSum sum;
    auto left = a.terms.begin();
    auto right = b.terms.begin();
    while (left != a.terms.end() || right != b.terms.end()) {
        const bool takes_left = right == b.terms.end() || (left != a.terms.end() && left->first <= right->first);
        const bool takes_right = left == a.terms.end() || (right != b.terms.end() && right->first <= left->first);
        const std::ptrdiff_t index = takes_left ? left->first : right->first;
        Rational weight;
        if (takes_left) weight += (left++)->second;
        if (takes_right) weight += sign * (right++)->second;
        if (weight != 0) sum.terms.emplace_back(index, weight);
    }
    return sum;
}

Rational floor_of(const Rational& number) {
    Integer quotient;
    mpz_fdiv_q(quotient.get_mpz_t(), number.get_num_mpz_t(), number.get_den_mpz_t());
    return quotient;
}

/// The root of the square of a rational.
std::optional<Rational> root_of(const Rational& number) {
    if (number < 0 || mpz_perfect_square_p(number.get_num_mpz_t()) == 0 ||
        mpz_perfect_square_p(number.get_den_mpz_t()) == 0)
        return std::nullopt;
    Rational root;
    mpz_sqrt(root.get_num_mpz_t(), number.get_num_mpz_t());
    mpz_sqrt(root.get_den_mpz_t(), number.get_den_mpz_t());
    return root;
}

bool compares(Operation operation, const Rational& a, const Rational& b) {
    switch (operation) {
    case Operation::Less:
        return a < b;
    case Operation::LessEqual:
        return a <= b;
    case Operation::Greater:
        return a > b;
    case Operation::GreaterEqual:
        return a >= b;
    case Operation::Equal:
        return a == b;
    default:
        return a != b;
    }
}

/// A stack machine; definitions call it again, as deep as definitions use each other.
class Machine {
public:
    explicit Machine(const PointSystem& system)
        : system_(system) {}

    /// Nothing when there is no value: reason() says why.
    std::optional<Entry> run(const Expression& expression, std::span<const ExactValue> formals) {
        if (++depth_ > max_depth) return fail("uses definitions inside definitions too deeply");
        std::vector<Entry> stack;
        auto literal = expression.numbers.begin();
        for (const Instruction& instruction : expression.code) {
            if (++work_ > max_exact_instructions) return fail("takes too many operations");
            if (instruction.operation == Operation::Number)
                stack.emplace_back(*literal++);
            else if (!step(instruction, formals, stack))
                return std::nullopt;
        }
        --depth_;
        return std::move(stack.back());
    }

    [[nodiscard]] const std::string& reason() const { return reason_; }

private:
    std::nullopt_t fail(std::string reason) {
        reason_ = std::move(reason);
        return std::nullopt;
    }
    bool refuse(std::string reason) {
        reason_ = std::move(reason);
        return false;
    }

    bool step(Instruction instruction, std::span<const ExactValue> formals, std::vector<Entry>& stack) {
        switch (instruction.operation) {
        case Operation::Formal:
            stack.push_back(std::visit([](const auto& value) { return Entry(value); }, formals[instruction.operand]));
            return true;
        case Operation::Constant:
            if (!system_.constant(instruction.operand).exact) return refuse("uses a square root that is not rational");
            stack.emplace_back(*system_.constant(instruction.operand).exact);
            return true;
        case Operation::Call:
            return call(instruction.operand, stack);
        case Operation::Point:
        case Operation::Coordinate:
            return refuse("mixes coordinates");
        default:
            return operate(instruction, stack);
        }
    }

    bool call(std::uint32_t index, std::vector<Entry>& stack) {
        const Definition& definition = system_.grammar().definitions[index];
        const std::size_t arity = definition.formals.size();
        std::vector<ExactValue> arguments;
        for (std::size_t i = stack.size() - arity; i < stack.size(); ++i) {
            if (const Rational* number = std::get_if<Rational>(&stack[i]))
                arguments.emplace_back(*number);
            else
                arguments.emplace_back(std::get<PointSum>(stack[i]));
        }
        stack.resize(stack.size() - arity);
        std::optional<Entry> value = run(definition.value, arguments);
        if (!value) return false;
        stack.push_back(*std::move(value));
        return true;
    }

    bool operate(Instruction instruction, std::vector<Entry>& stack) {
        const std::size_t count = operand_count(instruction, 0);
        Entry right = std::move(stack.back());
        stack.pop_back();
        if (count == 1) return push(unary(instruction.operation, right), stack);
        Entry left = std::move(stack.back());
        stack.pop_back();
        return push(binary(instruction.operation, left, right), stack);
    }

    bool push(std::optional<Entry> value, std::vector<Entry>& stack) {
        if (!value) return false;
        if (const Rational* number = std::get_if<Rational>(&*value); number != nullptr && is_long(*number))
            return refuse("has numbers of more than 4096 bits");
        if (const PointSum* sum = std::get_if<PointSum>(&*value))
            for (const auto& term : sum->terms)
                if (is_long(term.second)) return refuse("has weights of more than 4096 bits");
        stack.push_back(*std::move(value));
        return true;
    }

    std::optional<Entry> unary(Operation operation, const Entry& entry) {
        if (operation == Operation::Not) return !std::get<bool>(entry);
        if (const PointSum* sum = std::get_if<PointSum>(&entry)) {
            assert(operation == Operation::Negate);
            return scaled(*sum, -1);
        }
        const auto& number = std::get<Rational>(entry);
        if (operation == Operation::Negate) return Rational(-number);
        if (operation == Operation::Floor) return floor_of(number);
        if (operation == Operation::Absolute) return Rational(abs(number));
        if (std::optional<Rational> root = root_of(number)) return *std::move(root);
        return fail("takes a square root that is not rational");
    }

    std::optional<Entry> binary(Operation operation, const Entry& left, const Entry& right) {
        if (operation == Operation::And) return std::get<bool>(left) && std::get<bool>(right);
        if (operation == Operation::Or) return std::get<bool>(left) || std::get<bool>(right);
        const PointSum* const a = std::get_if<PointSum>(&left);
        const PointSum* const b = std::get_if<PointSum>(&right);
        if (a == nullptr && b == nullptr)
            return of_numbers(operation, std::get<Rational>(left), std::get<Rational>(right));
        if (a != nullptr && b != nullptr) return added(*a, *b, operation == Operation::Add ? 1 : -1);
        if (operation == Operation::Multiply)
            return a != nullptr ? scaled(*a, std::get<Rational>(right)) : scaled(*b, std::get<Rational>(left));
        if (std::get<Rational>(right) == 0) return fail("divides by zero");
        return scaled(*a, 1 / std::get<Rational>(right));
    }

    std::optional<Entry> of_numbers(Operation operation, const Rational& a, const Rational& b) {
        switch (operation) {
        case Operation::Add:
            return Rational(a + b);
        case Operation::Subtract:
            return Rational(a - b);
        case Operation::Multiply:
            return Rational(a * b);
        case Operation::Divide:
            if (b == 0) return fail("divides by zero");
            return Rational(a / b);
        case Operation::Minimum:
            return std::min(a, b);
        case Operation::Maximum:
            return std::max(a, b);
        default:
            return compares(operation, a, b);
        }
    }

    static constexpr std::size_t max_depth = 200;
    const PointSystem& system_;
    std::size_t depth_ = 0;
    std::size_t work_ = 0;
    std::string reason_;
};

} // namespace

ExactResult exact_value(const Expression& expression, std::span<const ExactValue> formals, const PointSystem& system) {
    Machine machine(system);
    ExactResult result;
    result.value = machine.run(expression, formals);
    result.reason = machine.reason();
    return result;
}

} // namespace internode
