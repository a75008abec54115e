// SPDX-License-Identifier: MIT
//
// Puts an expression together from its operations in postfix order: counts, folds literals, and refuses what can have
// no value whatever the formals are.
//
// Literals are folded exactly: `1 - 1/4` is the number 3/4. So no operation + - * / or unary minus of a program has
// numbers only for its operands, and a number prints as one literal. A formal may be a number or a point; what else an
// operand is, is certain: a point literal, a truth of a comparison.

#pragma once

#include "internode/expression/expression.h"
#include "internode/grammar/lexing/complaints.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

enum class ValueKind {
    Number,
    Point,
    NumberOrPoint,
    Truth,
};

/// What a whole grammar has used of its limits.
struct PointBudget {
    std::size_t modules = 0;
    std::size_t instructions = 0; ///< operations, before literals are folded
};

/// Every operation returns false after a complaint; nothing may be asked of the builder then.
class ExpressionBuilder {
public:
    ExpressionBuilder(PointBudget& budget, Complaints& complaints)
        : budget_(budget)
        , complaints_(complaints) {}

    using Place = Complaints::Place;

    [[nodiscard]] bool number(Rational value, Place place);
    [[nodiscard]] bool formal(std::uint32_t index, Place place);
    [[nodiscard]] bool constant(std::uint32_t index, Place place);
    /// An operation with a fixed number of operands, written at `place`; Minimum and Maximum of two numbers.
    [[nodiscard]] bool apply(Operation operation, Place place);
    [[nodiscard]] bool call(std::uint32_t definition, std::size_t arity);
    [[nodiscard]] bool point(std::size_t coordinates, Place place);
    [[nodiscard]] bool coordinate(std::uint32_t index, Place place);

    /// Says that the last operand is in parentheses which begin and end there.
    void enclose(std::size_t begin, std::size_t end);
    /// Whether the last operand is a quotient without parentheses around it: `a/b`.
    [[nodiscard]] bool ends_in_quotient() const { return operands_.back().quotient; }
    [[nodiscard]] Place last_place() const { return operands_.back().place; }

    /// What the only operand left is.
    [[nodiscard]] ValueKind kind() const { return operands_.back().kind; }
    [[nodiscard]] Expression expression(Place place) &&;

private:
    struct Operand {
        ValueKind kind = ValueKind::Number;
        bool literal = false;          ///< one Number instruction
        bool quotient = false;         ///< its last operation, not in parentheses, is a division
        std::uint32_t coordinates = 0; ///< how many a point literal has; 0 where that is not known
        Place place;
    };

    [[nodiscard]] bool push(Instruction instruction, Operand operand);
    /// Puts an operation in the place of its operands, the last `count`.
    [[nodiscard]] bool replace(Instruction instruction, std::size_t count, Operand result);
    [[nodiscard]] bool fold(Operation operation, std::size_t count, Operand result);
    [[nodiscard]] bool has_sound_operands(Operation operation, Place place);
    [[nodiscard]] bool are_truths(std::size_t count);
    [[nodiscard]] bool are_numbers(std::size_t count);
    [[nodiscard]] bool are_values(std::size_t count, std::string_view hint = {});
    [[nodiscard]] bool refuse(std::string_view code, Place place, std::string message, std::string hint = {});
    [[nodiscard]] Operand& operand(std::size_t from_last) { return operands_[operands_.size() - 1 - from_last]; }
    [[nodiscard]] Place place_of_last(std::size_t count) const;

    PointBudget& budget_;
    Complaints& complaints_;
    Expression expression_;
    std::vector<Operand> operands_;
    std::size_t counted_ = 0;
};

} // namespace internode
