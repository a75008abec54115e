// SPDX-License-Identifier: MIT

#include "internode/expression/type.h"

#include "internode/expression/visitor.h"
#include "internode/text/limits.h"

#include <fmt/format.h>

#include <array>
#include <cassert>

namespace internode {

namespace {

constexpr ExpressionType number_type{};
constexpr ExpressionType truth_type{true, 0};
constexpr std::array<char, 4> coordinate_names{'x', 'y', 'z', 'w'};

bool is_point(ExpressionType type) {
    return type.extent > 0;
}

/// One value on the stack and the instruction that made it.
struct Operand {
    ExpressionType type;
    Instruction made_by;
};

/// Types as values: every operation says what it makes of the types of its operands, or what is wrong with them.
class TypeOperations : public PlainOperations {
public:
    using Value = Operand;

    TypeOperations(const Formals& formals, std::span<const Definition> definitions)
        : formals_(formals)
        , definitions_(definitions) {
        assert(formals.names.size() == formals.extents.size());
    }

    static std::optional<Operand> number(const Rational& /*number*/) {
        return Operand{number_type, {Operation::Number, 0}};
    }
    std::optional<Operand> formal(std::uint32_t index) const {
        assert(index < formals_.extents.size());
        return Operand{{false, formals_.extents[index]}, {Operation::Formal, index}};
    }
    std::optional<Operand> apply(Instruction instruction, std::span<const Operand> operands) {
        const ExpressionType type = result_of(instruction, operands);
        if (!message_.empty()) return std::nullopt;
        return Operand{type, instruction};
    }
    [[nodiscard]] ExpressionProblem problem(const Expression& expression) const {
        return {expression.place, message_, hint_};
    }

private:
    ExpressionType result_of(Instruction instruction, std::span<const Operand> operands) {
        switch (instruction.operation) {
        case Operation::Negate:
            return negate(operands[0]);
        case Operation::Add:
        case Operation::Subtract:
            return sum(operands[0], operands[1], instruction.operation == Operation::Add);
        case Operation::Multiply:
            return product(operands[0], operands[1]);
        case Operation::Divide:
            return quotient(operands[0], operands[1]);
        case Operation::Point:
            return point(instruction.operand, operands);
        case Operation::Coordinate:
            return coordinate(instruction.operand, operands[0]);
        case Operation::And:
        case Operation::Or:
        case Operation::Not:
            for (const Operand& operand : operands) need_truth(operand);
            return truth_type;
        case Operation::Less:
        case Operation::LessEqual:
        case Operation::Greater:
        case Operation::GreaterEqual:
        case Operation::Equal:
        case Operation::NotEqual:
            compare(operands[0], operands[1]);
            return truth_type;
        case Operation::Call:
            need_numbers(operands, fmt::format("`{}`", definitions_[instruction.operand].name));
            return number_type;
        default:
            need_numbers(operands, name_of(instruction.operation));
            return number_type;
        }
    }

    ExpressionType negate(const Operand& operand) {
        if (operand.type.truth) fail(fmt::format("the negative of {}", shown(operand)), "write `not`");
        return operand.type;
    }

    ExpressionType sum(const Operand& a, const Operand& b, bool added) {
        if (a.type == b.type && !a.type.truth) return a.type;
        std::string hint = "points are added to points of as many coordinates, numbers to numbers";
        fail(added ? fmt::format("{} and {} cannot be added", shown(a), shown(b))
                   : fmt::format("{} cannot be subtracted from {}", shown(b), shown(a)),
             std::move(hint));
        return a.type;
    }

    ExpressionType product(const Operand& a, const Operand& b) {
        if (a.type.truth || b.type.truth || (is_point(a.type) && is_point(b.type)))
            fail(fmt::format("{} times {} has no meaning", shown(a), shown(b)),
                 "a product is of two numbers or of a number and a point");
        return is_point(a.type) ? a.type : b.type;
    }

    ExpressionType quotient(const Operand& a, const Operand& b) {
        if (a.type.truth || b.type != number_type)
            fail(fmt::format("{} cannot be divided by {}", shown(a), shown(b)),
                 is_point(b.type) ? "divide by a coordinate: `v.x`" : "");
        return a.type;
    }

    ExpressionType point(std::size_t size, std::span<const Operand> operands) {
        for (const Operand& operand : operands)
            if (operand.type != number_type) {
                fail(fmt::format("{} as a coordinate of a point", shown(operand)), "coordinates are numbers");
                return number_type;
            }
        if (size > max_dimension)
            fail(fmt::format("a point of {} coordinates: {} are allowed", size, max_dimension), "");
        return {false, static_cast<Extent>(size)};
    }

    ExpressionType coordinate(std::uint32_t index, const Operand& operand) {
        const char name = coordinate_names.at(index);
        if (!is_point(operand.type))
            fail(fmt::format("`.{}` of {}", name, shown(operand)), "only points have coordinates");
        else if (index >= operand.type.extent)
            fail(fmt::format("`.{}` of {}", name, shown(operand)), "");
        return number_type;
    }

    void compare(const Operand& a, const Operand& b) {
        if (a.type == number_type && b.type == number_type) return;
        fail(fmt::format("{} and {} cannot be compared", shown(a), shown(b)),
             is_point(a.type) || is_point(b.type) ? "compare coordinates: `u.x = v.x and u.y = v.y`"
                                                  : "only numbers are compared; combine truths by `and`, `or`, `not`");
    }

    void need_truth(const Operand& operand) {
        if (!operand.type.truth)
            fail(fmt::format("{} where a truth is needed", shown(operand)), "compare it: `s != 0`");
    }

    void need_numbers(std::span<const Operand> operands, const std::string& what) {
        for (const Operand& operand : operands)
            if (operand.type != number_type)
                fail(fmt::format("{} of {}", what, shown(operand)), fmt::format("{} takes numbers", what));
    }

    static std::string name_of(Operation operation) {
        switch (operation) {
        case Operation::Minimum:
            return "`min`";
        case Operation::Maximum:
            return "`max`";
        case Operation::Floor:
            return "`floor`";
        case Operation::Absolute:
            return "`abs`";
        default:
            return "`sqrt`";
        }
    }

    /// "`v`, a point of 2 coordinates," where the operand has a name.
    [[nodiscard]] std::string shown(const Operand& operand) const {
        const Instruction instruction = operand.made_by;
        if (instruction.operation == Operation::Formal)
            return fmt::format("{} (`{}`)", describe(operand.type), formals_.names[instruction.operand]);
        if (instruction.operation == Operation::Constant)
            return fmt::format("{} (`{}`)", describe(operand.type), definitions_[instruction.operand].name);
        return describe(operand.type);
    }

    void fail(std::string message, std::string hint) {
        if (!message_.empty()) return;
        message_ = std::move(message);
        hint_ = std::move(hint);
    }

    const Formals& formals_;
    std::span<const Definition> definitions_;
    std::string message_;
    std::string hint_;
};

} // namespace

std::string describe(ExpressionType type) {
    if (type.truth) return "a truth";
    if (type.extent == 0) return "a number";
    return fmt::format("a point of {} coordinate{}", type.extent, type.extent == 1 ? "" : "s");
}

std::optional<ExpressionType> type_of(const Expression& expression, const Formals& formals,
                                      std::span<const Definition> definitions,
                                      std::vector<ExpressionProblem>& problems) {
    TypeOperations operations(formals, definitions);
    const std::optional<Operand> value = ExpressionVisitor(definitions, operations).visit(expression);
    if (value) return value->type;
    problems.push_back(operations.problem(expression));
    return std::nullopt;
}

bool expect_type(ExpressionType expected, const std::string& what, const Expression& expression, const Formals& formals,
                 std::span<const Definition> definitions, std::vector<ExpressionProblem>& problems) {
    const std::optional<ExpressionType> type = type_of(expression, formals, definitions, problems);
    if (type && *type != expected)
        problems.push_back(
            {expression.place, fmt::format("{} is {}, not {}", what, describe(*type), describe(expected)), ""});
    return type == expected;
}

} // namespace internode
