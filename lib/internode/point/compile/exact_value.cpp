// SPDX-License-Identifier: MIT

#include "internode/point/compile/exact_value.h"

#include "internode/expression/known_number.h"
#include "internode/point/limits.h"

namespace internode {
namespace {

bool is_long(const Rational& number) {
    return mpz_sizeinbase(number.get_num_mpz_t(), 2) + mpz_sizeinbase(number.get_den_mpz_t(), 2) > max_known_bits;
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

/// A stack machine; definitions call it again, as deep as definitions use each other.
class Machine {
public:
    explicit Machine(const PointSystem& system)
        : system_(system) {}

    /// Nothing when there is no value: reason() says why.
    std::optional<ExactValue> run(const Expression& expression, std::span<const ExactValue> formals) {
        if (++depth_ > max_depth) return fail("uses definitions inside definitions too deeply");
        std::vector<ExactValue> stack;
        auto literal = expression.numbers.begin();
        for (const Instruction& instruction : expression.code) {
            if (++work_ > max_expression_operations) return fail("takes too many operations");
            if (instruction.operation == Operation::Number)
                stack.emplace_back(*literal++);
            else if (!step(instruction, formals, stack))
                return std::nullopt;
        }
        --depth_;
        return std::move(stack.back());
    }

    [[nodiscard]] const std::string& reason() const { return reason_; }
    /// Whether an operation on doubles would have given another number than the nearest one.
    [[nodiscard]] bool rounds() const { return rounds_; }

private:
    std::nullopt_t fail(std::string reason) {
        reason_ = std::move(reason);
        return std::nullopt;
    }
    bool refuse(std::string reason) {
        reason_ = std::move(reason);
        return false;
    }

    bool step(Instruction instruction, std::span<const ExactValue> formals, std::vector<ExactValue>& stack) {
        switch (instruction.operation) {
        case Operation::Formal:
            stack.push_back(formals[instruction.operand]);
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

    bool call(std::uint32_t index, std::vector<ExactValue>& stack) {
        const Definition& definition = system_.grammar().definitions[index];
        const std::size_t arity = definition.formals.size();
        const std::vector<ExactValue> arguments(stack.end() - static_cast<std::ptrdiff_t>(arity), stack.end());
        stack.resize(stack.size() - arity);
        std::optional<ExactValue> value = run(definition.value, arguments);
        if (!value) return false;
        stack.push_back(*std::move(value));
        return true;
    }

    bool operate(Instruction instruction, std::vector<ExactValue>& stack) {
        const bool is_unary = operand_count(instruction, 0) == 1;
        const ExactValue right = std::move(stack.back());
        stack.pop_back();
        if (is_unary) {
            const PointSum* const sum = std::get_if<PointSum>(&right);
            return sum != nullptr ? push(scaled(*sum, -1), stack) // nothing else is done to one point
                                  : compute(instruction.operation, {{std::get<Rational>(right)}}, stack);
        }
        const ExactValue left = std::move(stack.back());
        stack.pop_back();
        return combine(instruction.operation, left, right, stack);
    }

    bool combine(Operation operation, const ExactValue& left, const ExactValue& right, std::vector<ExactValue>& stack) {
        const PointSum* const a = std::get_if<PointSum>(&left);
        const PointSum* const b = std::get_if<PointSum>(&right);
        if (a == nullptr && b == nullptr)
            return compute(operation, {{std::get<Rational>(left)}, {std::get<Rational>(right)}}, stack);
        if (a != nullptr && b != nullptr) return push(added(*a, *b, operation == Operation::Add ? 1 : -1), stack);
        if (b != nullptr) return push(scaled(*b, std::get<Rational>(left)), stack);
        const auto& number = std::get<Rational>(right);
        if (operation == Operation::Multiply) return push(scaled(*a, number), stack);
        if (number == 0) return refuse("divides by zero");
        return push(scaled(*a, 1 / number), stack);
    }

    bool compute(Operation operation, std::vector<KnownNumber> arguments, std::vector<ExactValue>& stack) {
        KnownNumber result = apply_operation(operation, arguments);
        if (result.exact) {
            const double first = nearest(arguments.front());
            rounds_ = rounds_ || nearest(result) != apply_operation(operation, first, nearest(arguments.back()));
            stack.emplace_back(*std::move(result.exact));
            return true;
        }
        if (operation == Operation::Divide && *arguments.back().exact == 0) return refuse("divides by zero");
        if (operation == Operation::SquareRoot) return refuse("takes a square root that is not rational");
        return refuse(too_long);
    }

    bool push(PointSum sum, std::vector<ExactValue>& stack) {
        for (const auto& term : sum.terms)
            if (is_long(term.second)) return refuse(too_long);
        stack.emplace_back(std::move(sum));
        return true;
    }

    static constexpr const char* too_long = "has numbers of too many digits";
    static constexpr std::size_t max_depth = 200;
    const PointSystem& system_;
    std::size_t depth_ = 0;
    std::size_t work_ = 0;
    bool rounds_ = false;
    std::string reason_;
};

} // namespace

ExactResult exact_value(const Expression& expression, std::span<const ExactValue> formals, const PointSystem& system) {
    Machine machine(system);
    ExactResult result;
    result.value = machine.run(expression, formals);
    result.reason = machine.reason();
    if (result.value && std::holds_alternative<Rational>(*result.value) && machine.rounds()) {
        result.value.reset();
        result.reason = "computes with numbers that doubles round";
    }
    return result;
}

} // namespace internode
