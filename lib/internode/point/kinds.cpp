// SPDX-License-Identifier: MIT

#include "internode/point/kinds.h"

#include "internode/io/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

constexpr Kind number{};
constexpr Kind truth{true, 0};
constexpr std::array<char, 4> coordinate_names{'x', 'y', 'z', 'w'};

bool is_point(Kind kind) {
    return kind.extent > 0;
}

/// One value on the stack and the instruction that made it.
struct Operand {
    Kind kind;
    std::size_t instruction = 0;
};

class KindChecker {
public:
    KindChecker(const Expression& expression, const Formals& formals, const PointGrammar& grammar)
        : expression_(expression)
        , formals_(formals)
        , grammar_(grammar) {}

    std::optional<Kind> run() {
        for (at_ = 0; at_ < expression_.code.size() && message_.empty(); ++at_) step(expression_.code[at_]);
        if (!message_.empty()) return std::nullopt;
        assert(stack_.size() == 1);
        return stack_.back().kind;
    }
    [[nodiscard]] PointProblem problem() const { return {expression_.place, message_, hint_}; }

private:
    void step(Instruction instruction) {
        const Operation operation = instruction.operation;
        const std::size_t arity =
            operation == Operation::Call ? grammar_.definitions[instruction.operand].formals.size() : 0;
        const std::size_t count = operand_count(instruction, arity);
        assert(count <= stack_.size());
        const std::span<const Operand> operands(stack_.data() + (stack_.size() - count), count);
        const Kind result = operation == Operation::Formal ? Kind{false, formals_.extents[instruction.operand]}
                                                           : result_of(instruction, operands);
        stack_.resize(stack_.size() - count);
        stack_.push_back({result, at_});
    }

    Kind result_of(Instruction instruction, std::span<const Operand> operands) {
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
            return truth;
        case Operation::Less:
        case Operation::LessEqual:
        case Operation::Greater:
        case Operation::GreaterEqual:
        case Operation::Equal:
        case Operation::NotEqual:
            compare(operands[0], operands[1]);
            return truth;
        case Operation::Call:
            need_numbers(operands, fmt::format("`{}`", grammar_.definitions[instruction.operand].name));
            return number;
        default:
            need_numbers(operands, name_of(instruction.operation));
            return number;
        }
    }

    Kind negate(const Operand& operand) {
        if (operand.kind.truth) fail(fmt::format("the negative of {}", shown(operand)), "write `not`");
        return operand.kind;
    }

    Kind sum(const Operand& a, const Operand& b, bool added) {
        if (a.kind == b.kind && !a.kind.truth) return a.kind;
        std::string hint = "points are added to points of as many coordinates, numbers to numbers";
        fail(added ? fmt::format("{} and {} cannot be added", shown(a), shown(b))
                   : fmt::format("{} cannot be subtracted from {}", shown(b), shown(a)),
             std::move(hint));
        return a.kind;
    }

    Kind product(const Operand& a, const Operand& b) {
        if (a.kind.truth || b.kind.truth || (is_point(a.kind) && is_point(b.kind)))
            fail(fmt::format("{} times {} has no meaning", shown(a), shown(b)),
                 "a product is of two numbers or of a number and a point");
        return is_point(a.kind) ? a.kind : b.kind;
    }

    Kind quotient(const Operand& a, const Operand& b) {
        if (a.kind.truth || b.kind != number)
            fail(fmt::format("{} cannot be divided by {}", shown(a), shown(b)),
                 is_point(b.kind) ? "divide by a coordinate: `v.x`" : "");
        return a.kind;
    }

    Kind point(std::size_t size, std::span<const Operand> operands) {
        for (const Operand& operand : operands)
            if (operand.kind != number) {
                fail(fmt::format("{} as a coordinate of a point", shown(operand)), "coordinates are numbers");
                return number;
            }
        if (size > max_dimension)
            fail(fmt::format("a point of {} coordinates: {} are allowed", size, max_dimension), "");
        return {false, static_cast<Extent>(size)};
    }

    Kind coordinate(std::uint32_t index, const Operand& operand) {
        const char name = coordinate_names.at(index);
        if (!is_point(operand.kind))
            fail(fmt::format("`.{}` of {}", name, shown(operand)), "only points have coordinates");
        else if (index >= operand.kind.extent)
            fail(fmt::format("`.{}` of {}", name, shown(operand)), "");
        return number;
    }

    void compare(const Operand& a, const Operand& b) {
        if (a.kind == number && b.kind == number) return;
        fail(fmt::format("{} and {} cannot be compared", shown(a), shown(b)),
             is_point(a.kind) || is_point(b.kind) ? "compare coordinates: `u.x = v.x and u.y = v.y`"
                                                  : "only numbers are compared; combine truths by `and`, `or`, `not`");
    }

    void need_truth(const Operand& operand) {
        if (!operand.kind.truth)
            fail(fmt::format("{} where a truth is needed", shown(operand)), "compare it: `s != 0`");
    }

    void need_numbers(std::span<const Operand> operands, const std::string& what) {
        for (const Operand& operand : operands)
            if (operand.kind != number)
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
        const Instruction instruction = expression_.code[operand.instruction];
        if (instruction.operation == Operation::Formal)
            return fmt::format("{} (`{}`)", describe(operand.kind), formals_.names[instruction.operand]);
        if (instruction.operation == Operation::Constant)
            return fmt::format("{} (`{}`)", describe(operand.kind), grammar_.definitions[instruction.operand].name);
        return describe(operand.kind);
    }

    void fail(std::string message, std::string hint) {
        if (!message_.empty()) return;
        message_ = std::move(message);
        hint_ = std::move(hint);
    }

    const Expression& expression_;
    const Formals& formals_;
    const PointGrammar& grammar_;
    std::vector<Operand> stack_;
    std::size_t at_ = 0;
    std::string message_;
    std::string hint_;
};

} // namespace

std::string describe(Kind kind) {
    if (kind.truth) return "a truth";
    if (kind.extent == 0) return "a number";
    return fmt::format("a point of {} coordinate{}", kind.extent, kind.extent == 1 ? "" : "s");
}

std::optional<Kind> kind_of(const Expression& expression, const Formals& formals, const PointGrammar& grammar,
                            std::vector<PointProblem>& problems) {
    KindChecker checker(expression, formals, grammar);
    std::optional<Kind> kind = checker.run();
    if (!kind) problems.push_back(checker.problem());
    return kind;
}

bool expect_kind(Kind expected, const std::string& what, const Expression& expression, const Formals& formals,
                 const PointGrammar& grammar, std::vector<PointProblem>& problems) {
    const std::optional<Kind> kind = kind_of(expression, formals, grammar, problems);
    if (kind && *kind != expected)
        problems.push_back(
            {expression.place, fmt::format("{} is {}, not {}", what, describe(*kind), describe(expected)), ""});
    return kind == expected;
}

} // namespace internode
