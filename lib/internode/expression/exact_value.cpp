// SPDX-License-Identifier: MIT

#include "internode/expression/exact_value.h"

#include "internode/expression/limits.h"
#include "internode/expression/visitor.h"

#include <cassert>

namespace internode {
namespace {

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

/// Rational numbers, and combinations of points with rational weights; functions are written out.
class ExactOperations {
public:
    using Value = ExactValue;

    ExactOperations(std::span<const ExactValue> formals, const DefinitionScope& scope)
        : formals_(formals)
        , scope_(scope) {}

    [[nodiscard]] bool admits(std::size_t texts) {
        if (texts > max_texts) return refuse("uses definitions inside definitions too deeply");
        return ++work_ <= max_expression_operations || refuse("takes too many operations");
    }
    [[nodiscard]] const Definition* written_out(Instruction instruction) const {
        return instruction.operation == Operation::Call ? &scope_.definitions[instruction.operand] : nullptr;
    }
    static std::optional<ExactValue> number(const Rational& number) { return number; }
    [[nodiscard]] std::optional<ExactValue> formal(std::uint32_t index) const {
        assert(index < formals_.size());
        return formals_[index];
    }
    std::optional<ExactValue> apply(Instruction instruction, std::span<const ExactValue> operands) {
        switch (instruction.operation) {
        case Operation::Constant:
            return constant(scope_.constants[instruction.operand]);
        case Operation::Point:
        case Operation::Coordinate:
            return fail("mixes coordinates");
        default:
            return operands.size() == 1 ? apply_to_one(instruction.operation, operands[0])
                                        : apply_to_two(instruction.operation, operands[0], operands[1]);
        }
    }

    /// Why there is no value.
    [[nodiscard]] const std::string& reason() const { return reason_; }
    /// Whether an operation on doubles would have given another number than the nearest one.
    [[nodiscard]] bool rounds() const { return rounds_; }

private:
    std::nullopt_t fail(const char* reason) {
        reason_ = reason;
        return std::nullopt;
    }
    bool refuse(const char* reason) {
        reason_ = reason;
        return false;
    }

    std::optional<ExactValue> constant(const KnownNumber& value) {
        if (!value.exact) return fail("uses a square root that is not rational");
        return *value.exact;
    }

    std::optional<ExactValue> apply_to_one(Operation operation, const ExactValue& operand) {
        if (const PointSum* const sum = std::get_if<PointSum>(&operand)) {
            assert(operation == Operation::Negate && "nothing else is done to one point");
            return within_limits(scaled(*sum, -1));
        }
        const KnownNumber arguments[] = {{std::get<Rational>(operand), 0}};
        return compute(operation, arguments);
    }

    std::optional<ExactValue> apply_to_two(Operation operation, const ExactValue& left, const ExactValue& right) {
        const PointSum* const a = std::get_if<PointSum>(&left);
        const PointSum* const b = std::get_if<PointSum>(&right);
        if (a == nullptr && b == nullptr) {
            const KnownNumber arguments[] = {{std::get<Rational>(left), 0}, {std::get<Rational>(right), 0}};
            return compute(operation, arguments);
        }
        if (a != nullptr && b != nullptr) return within_limits(added(*a, *b, operation == Operation::Add ? 1 : -1));
        if (b != nullptr) return within_limits(scaled(*b, std::get<Rational>(left)));
        const auto& number = std::get<Rational>(right);
        if (operation == Operation::Multiply) return within_limits(scaled(*a, number));
        assert(operation == Operation::Divide);
        if (number == 0) return fail("divides by zero");
        return within_limits(scaled(*a, 1 / number));
    }

    std::optional<ExactValue> compute(Operation operation, std::span<const KnownNumber> arguments) {
        KnownNumber result = apply_operation(operation, arguments);
        if (result.exact) {
            const double first = nearest(arguments.front());
            rounds_ = rounds_ || nearest(result) != apply_operation(operation, first, nearest(arguments.back()));
            return *std::move(result.exact);
        }
        if (operation == Operation::Divide && *arguments.back().exact == 0) return fail("divides by zero");
        if (operation == Operation::SquareRoot) return fail("takes a square root that is not rational");
        return fail(too_long);
    }

    std::optional<ExactValue> within_limits(PointSum sum) {
        for (const auto& term : sum.terms)
            if (bit_size(term.second) > max_known_bits) return fail(too_long);
        return sum;
    }

    static constexpr const char* too_long = "has numbers of too many digits";
    static constexpr std::size_t max_texts = 200; // definitions that are read within each other
    std::span<const ExactValue> formals_;
    const DefinitionScope& scope_;
    std::size_t work_ = 0; ///< instructions so far
    bool rounds_ = false;
    std::string reason_;
};

} // namespace

ExactResult exact_value(const Expression& expression, std::span<const ExactValue> formals,
                        const DefinitionScope& scope) {
    ExactOperations operations(formals, scope);
    ExactResult result;
    result.value = ExpressionVisitor(scope.definitions, operations).visit(expression);
    result.reason = operations.reason();
    if (result.value && std::holds_alternative<Rational>(*result.value) && operations.rounds()) {
        result.value.reset();
        result.reason = "computes with numbers that doubles round";
    }
    return result;
}

} // namespace internode
