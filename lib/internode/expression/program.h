// SPDX-License-Identifier: MIT
//
// Expressions compiled for doubles: the types are known, so a point is so many doubles on a flat stack.
//
// What does not depend on a formal is folded: computed exactly (known_number.h) and rounded once. Everything else is
// done as written, left to right, in doubles; truths are 1 and 0, both operands of `and` and `or` are evaluated.
// `1/4 u + 3/4 v` becomes two steps: push 0.25 u, add 0.75 v.

#pragma once

#include "internode/expression/definition_scope.h"
#include "internode/expression/limits.h"
#include "internode/expression/type.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace internode {

class Program {
public:
    [[nodiscard]] ExpressionType type() const { return type_; }
    /// The doubles of the value.
    [[nodiscard]] std::size_t width() const { return type_.extent == 0 ? 1 : type_.extent; }

private:
    friend class ProgramMaker;
    friend class Evaluator;

    enum class Code : std::uint8_t {
        Push,           ///< Pushes numbers[a] … numbers[a + width).
        PushFormal,     ///< Pushes formals[a] … formals[a + width).
        PushScaled,     ///< Pushes numbers[b] times these formals.
        AddScaled,      ///< Adds numbers[b] times these formals to the top.
        Add,            ///< Adds two values of width doubles.
        Subtract,       ///< Subtracts the top from the value below, width doubles each.
        Negate,         ///< Negates the top, width doubles.
        NumberTimesTop, ///< Takes a number and width doubles on it, leaves their product.
        TopTimesNumber, ///< Takes width doubles and a number on them, leaves their product.
        TopDividedBy,   ///< Takes width doubles and a number on them, leaves their quotient.
        TakeCoordinate, ///< Takes width doubles, leaves number a of them.
        ApplyOne,       ///< Applies the operation a to one number.
        ApplyTwo,       ///< Applies the operation a to two numbers.
        Call,           ///< Calls the function a, whose arguments are the top width doubles.
    };
    struct Step {
        Code code;
        std::uint32_t width = 1;
        std::uint32_t a = 0;
        std::uint32_t b = 0;
    };

    std::vector<Step> steps_;
    std::vector<double> numbers_;
    ExpressionType type_;
    std::size_t depth_ = 0; ///< doubles that the stack needs at most, those of called functions included
};

/// What programs are made with: the definitions that they may name.
class ProgramMaker {
public:
    /// What the scope views must outlive the maker.
    explicit ProgramMaker(const DefinitionScope& scope);

    /// One per definition; those without formals are empty.
    [[nodiscard]] const std::vector<Program>& functions() const { return functions_; }
    /// Precondition: type_of() accepts the expression. `formals`: the extent of each.
    [[nodiscard]] Program make(const Expression& expression, std::span<const Extent> formals);

private:
    class Compilation;
    DefinitionScope scope_;
    std::vector<std::uint64_t> costs_; ///< operations that one use of each definition costs
    std::vector<Program> functions_;
    /// Operations that may still be spent on folding calls; when it is used up calls stay calls.
    std::uint64_t budget_ = max_constant_operations;
};

} // namespace internode
