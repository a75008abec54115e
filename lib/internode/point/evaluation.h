// SPDX-License-Identifier: MIT
//
// Expressions compiled for doubles: the types are known, so a point is so many doubles on a flat stack.
//
// What does not depend on a formal is folded: computed exactly (known_number.h) and rounded once. Everything else is
// done as written, left to right, in doubles; truths are 1 and 0, both operands of `and` and `or` are evaluated.
// `1/4 u + 3/4 v` becomes two steps: push 0.25 u, add 0.75 v.

#pragma once

#include "internode/point/constants.h"
#include "internode/point/kinds.h"

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
        Push,           ///< numbers[a] … numbers[a + width)
        PushFormal,     ///< formals[a] … formals[a + width)
        PushScaled,     ///< numbers[b] times the formal
        AddScaled,      ///< the same, added to the top
        Add,            ///< of width doubles
        Subtract,       ///< of width doubles
        Negate,         ///< of width doubles
        NumberTimesTop, ///< a number, then width doubles
        TopTimesNumber, ///< width doubles, then a number
        TopDividedBy,   ///< width doubles, then a number
        TakeCoordinate, ///< number a of width doubles
        ApplyOne,       ///< an operation a of one number
        ApplyTwo,       ///< an operation a of two numbers
        Call,           ///< the function a, whose arguments are the top `width` doubles
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

/// What programs are made with: the grammar's definitions.
class ProgramMaker {
public:
    /// Both must outlive the maker.
    ProgramMaker(const PointGrammar& grammar, std::span<const KnownNumber> constants);

    /// One per definition; those without formals are empty.
    [[nodiscard]] const std::vector<Program>& functions() const { return functions_; }
    /// Precondition: type_of() accepts the expression. `formals`: the extent of each.
    [[nodiscard]] Program make(const Expression& expression, std::span<const Extent> formals);

private:
    class Compilation;
    const PointGrammar& grammar_;
    std::span<const KnownNumber> constants_;
    std::vector<std::uint64_t> costs_;
    std::vector<Program> functions_;
    /// Operations that may still be spent on folding calls; when it is used up calls stay calls.
    std::uint64_t budget_ = max_constant_operations;
};

/// A stack of values. Not to be shared between threads.
class Evaluator {
public:
    /// `functions` of the maker of all programs; must outlive the evaluator.
    explicit Evaluator(std::span<const Program> functions)
        : functions_(functions) {}

    void clear() { top_ = 0; }
    /// Puts the value of the program on top. `formals`: the doubles of all formals, one after the other.
    void push(const Program& program, std::span<const double> formals);
    /// All values pushed since clear().
    [[nodiscard]] std::span<const double> values() const { return {stack_.data(), top_}; }
    /// The value of a number or a truth.
    [[nodiscard]] double number(const Program& program, std::span<const double> formals);
    /// Steps done so far.
    [[nodiscard]] std::uint64_t work() const { return work_; }

private:
    struct Frame {
        const Program* program = nullptr;
        std::size_t next = 0;
        const double* formals = nullptr;
        std::size_t base = 0; ///< where the value goes: the place of the first argument
    };
    void run(Frame frame);
    void step(const Program& program, const Program::Step& step, const double* formals);
    void other_step(const Program::Step& step, double* top);

    std::span<const Program> functions_;
    std::vector<double> stack_;
    std::vector<Frame> frames_;
    std::size_t top_ = 0;
    std::uint64_t work_ = 0;
};

} // namespace internode
