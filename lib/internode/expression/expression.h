// SPDX-License-Identifier: MIT
//
// An expression of a point grammar: a number, a point or a truth, as a postfix program.
//
// `1/4 u + 3/4 v` is the program [1/4, u, *, 3/4, v, *, +]. A program has no depth: it is copied, compared, evaluated
// and destroyed without recursion, whatever a text contains. What a formal stands for, a number or a point, is not
// known here: point/point_system.h says it, from the input, the axiom and the rules.

#pragma once

#include "internode/algebra/rational.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace internode {

/// Where something stands in the text.
struct SourcePlace {
    std::size_t offset = 0;
    std::size_t bytes = 0;
    friend bool operator==(const SourcePlace&, const SourcePlace&) = default;
};

/// A place beside a value and no part of it: two values that stand at different places compare equal, so that
/// parse(print(g)) == g.
struct IncidentalPlace : SourcePlace {
    constexpr IncidentalPlace() = default;
    constexpr IncidentalPlace(SourcePlace place) // NOLINT(google-explicit-constructor): a place becomes incidental
        : SourcePlace(place) {}
    friend bool operator==(const IncidentalPlace&, const IncidentalPlace&) { return true; }
};

enum class Operation : std::uint8_t {
    Number,   ///< pushes numbers[operand]
    Formal,   ///< pushes the formal number `operand` of the rule, the definition or the input
    Constant, ///< pushes the value of the definition number `operand`, which has no formals
    Call,     ///< pops the arguments of the definition number `operand`, pushes its value

    Negate,   ///< pops a number or a point
    Add,      ///< pops two numbers or two points
    Subtract, ///< the same
    Multiply, ///< pops two numbers, or a number and a point in any order
    Divide,   ///< divides a number or a point by a number
    Minimum,  ///< pops two numbers; min of more is a chain
    Maximum,
    Floor,      ///< pushes the largest integer that is not larger
    Absolute,   ///< pops a number
    SquareRoot, ///< pops a number
    Point,      ///< pops `operand` >= 2 numbers, pushes the point with these coordinates
    Coordinate, ///< pops a point, pushes its coordinate number `operand`: `v.x` is 0, `v.y` 1, `v.z` 2, `v.w` 3

    Less, ///< pops two numbers, like the next five
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And, ///< pops two truths, both evaluated
    Or,
    Not,
};

struct Instruction {
    Operation operation = Operation::Number;
    std::uint32_t operand = 0; ///< 0 where the operation has none
    friend bool operator==(const Instruction&, const Instruction&) = default;
};

struct Expression {
    std::vector<Instruction> code; ///< leaves exactly one value; at least one instruction
    std::vector<Rational> numbers; ///< the literals, in the order of the text, each used once
    IncidentalPlace place;
    friend bool operator==(const Expression&, const Expression&) = default;
};

/// How many values an operation pops; Call pops as many as its definition has formals: `call_arity`.
[[nodiscard]] std::size_t operand_count(Instruction instruction, std::size_t call_arity);

} // namespace internode
