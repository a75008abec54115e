// SPDX-License-Identifier: MIT
//
// One walk whose values are types and whose side effect are steps. Operands that are known take their steps back when
// their result is folded; a call is folded while the budget of operations lasts. A product or sum looks at the steps
// before it: a number times a formal is one step, and adding it one too.

#include "internode/expression/program.h"

#include "internode/expression/known_value.h"
#include "internode/expression/visitor.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

std::uint32_t width_of(Extent extent) {
    return extent == 0 ? 1 : extent;
}

/// What an instruction leaves on the stack: its type, where its steps begin, and its value where that is known already.
struct CompiledOperand {
    ExpressionType type;
    std::size_t first_step = 0;
    std::size_t first_number = 0;
    std::vector<KnownNumber> known; ///< all coordinates or none
};

} // namespace

/// One expression on its way to a program: the values of the walk are types, its side effect are steps.
class ProgramMaker::Compilation : public PlainOperations {
public:
    using Value = CompiledOperand;

    Compilation(ProgramMaker& maker, std::span<const Extent> formals)
        : maker_(maker)
        , extents_(formals) {
        std::uint32_t offset = 0;
        for (const Extent extent : formals) {
            offsets_.push_back(offset);
            offset += width_of(extent);
        }
    }

    std::optional<CompiledOperand> number(const Rational& number) { return push_known({}, {{number, 0}}); }

    std::optional<CompiledOperand> formal(std::uint32_t index) {
        assert(index < extents_.size());
        const ExpressionType type{false, extents_[index]};
        CompiledOperand operand{type, program_.steps_.size(), program_.numbers_.size(), {}};
        add_step({Code::PushFormal, width_of(type.extent), offsets_[index], 0});
        grow(width_of(type.extent));
        return operand;
    }

    std::optional<CompiledOperand> apply(Instruction instruction, std::span<CompiledOperand> operands) {
        if (instruction.operation == Operation::Constant)
            return push_known({}, {maker_.scope_.constants[instruction.operand]});
        const bool known = std::ranges::none_of(operands, [](const auto& one) { return one.known.empty(); });
        if (known && pays(instruction)) return fold(instruction, operands);
        const ExpressionType type = emit(instruction, operands);
        release(operands);
        grow(width_of(type.extent));
        return CompiledOperand{type, operands.front().first_step, operands.front().first_number, {}};
    }

    Program finish(ExpressionType type) {
        program_.type_ = type;
        return std::move(program_);
    }

private:
    using Code = Program::Code;

    CompiledOperand push_known(ExpressionType type, std::vector<KnownNumber> known) {
        assert(known.size() == width_of(type.extent));
        const auto first = static_cast<std::uint32_t>(program_.numbers_.size());
        const std::size_t first_step = program_.steps_.size();
        for (const KnownNumber& one : known) program_.numbers_.push_back(nearest(one));
        add_step({Code::Push, static_cast<std::uint32_t>(known.size()), first, 0});
        grow(width_of(type.extent));
        return {type, first_step, first, std::move(known)};
    }

    /// Takes the operands from the stack of doubles.
    void release(std::span<const CompiledOperand> operands) {
        for (const CompiledOperand& one : operands) {
            assert(width_of(one.type.extent) <= height_);
            height_ -= width_of(one.type.extent);
        }
    }

    /// Whether there is still work to spend on a call.
    bool pays(Instruction instruction) {
        if (instruction.operation != Operation::Call) return true;
        const std::uint64_t cost = maker_.costs_[instruction.operand];
        if (cost > maker_.budget_) return false;
        maker_.budget_ -= cost;
        return true;
    }

    /// Computes what is known and takes the steps of the operands back.
    CompiledOperand fold(Instruction instruction, std::span<const CompiledOperand> operands) {
        ExpressionType type;
        std::vector<KnownNumber> known;
        if (instruction.operation == Operation::Call) {
            std::vector<KnownNumber> arguments;
            for (const CompiledOperand& one : operands) arguments.push_back(one.known.front());
            known.push_back(
                evaluate_known(maker_.scope_.definitions[instruction.operand].value, arguments, maker_.scope_));
        } else {
            known = fold_operation(instruction, operands, type);
        }
        program_.steps_.resize(operands.front().first_step);
        program_.numbers_.resize(operands.front().first_number);
        release(operands);
        return push_known(type, std::move(known));
    }

    static std::vector<KnownNumber> fold_operation(Instruction instruction, std::span<const CompiledOperand> operands,
                                                   ExpressionType& type) {
        std::vector<KnownNumber> known;
        if (instruction.operation == Operation::Coordinate) return {operands[0].known[instruction.operand]};
        if (instruction.operation == Operation::Point) {
            for (const CompiledOperand& one : operands) known.push_back(one.known.front());
            type.extent = instruction.operand;
            return known;
        }
        type = result_type(instruction.operation, operands);
        // A number stands beside each coordinate of a point.
        const auto at = [](const CompiledOperand& one, std::size_t i) {
            return one.known[one.known.size() == 1 ? 0 : i];
        };
        for (std::size_t i = 0; i < width_of(type.extent); ++i) {
            std::vector<KnownNumber> arguments;
            for (const CompiledOperand& one : operands) arguments.push_back(at(one, i));
            known.push_back(apply_operation(instruction.operation, arguments));
        }
        return known;
    }

    static ExpressionType result_type(Operation operation, std::span<const CompiledOperand> operands) {
        switch (operation) {
        case Operation::Negate:
        case Operation::Add:
        case Operation::Subtract:
        case Operation::Divide:
            return operands[0].type;
        case Operation::Multiply:
            return operands[0].type.extent > 0 ? operands[0].type : operands[1].type;
        default:
            return {operation >= Operation::Less, 0};
        }
    }

    ExpressionType emit(Instruction instruction, std::span<const CompiledOperand> operands) {
        const ExpressionType type = result_type(instruction.operation, operands);
        const std::uint32_t width = width_of(type.extent);
        switch (instruction.operation) {
        case Operation::Point:
            return {false, instruction.operand}; // its coordinates are there already
        case Operation::Coordinate:
            add_step({Code::TakeCoordinate, operands[0].type.extent, instruction.operand, 0});
            return {};
        case Operation::Call:
            grow(maker_.functions_[instruction.operand].depth_, 0);
            add_step({Code::Call, static_cast<std::uint32_t>(operands.size()), instruction.operand, 0});
            return {};
        case Operation::Negate:
            add_step({Code::Negate, width, 0, 0});
            break;
        case Operation::Add:
            add_sum(operands[1], width);
            break;
        case Operation::Subtract:
            add_step({Code::Subtract, width, 0, 0});
            break;
        case Operation::Multiply:
            add_product(operands, width);
            break;
        case Operation::Divide:
            add_step({Code::TopDividedBy, width, 0, 0});
            break;
        default:
            add_step({operands.size() == 1 ? Code::ApplyOne : Code::ApplyTwo, 1,
                      static_cast<std::uint32_t>(instruction.operation), 0});
        }
        return type;
    }

    /// `… + 3/4 v` adds in one step.
    void add_sum(const CompiledOperand& second, std::uint32_t width) {
        Program::Step& last = program_.steps_.back();
        if (last.code == Code::PushScaled && program_.steps_.size() == second.first_step + 1)
            last.code = Code::AddScaled;
        else
            add_step({Code::Add, width, 0, 0});
    }

    /// `3/4 v` is one step.
    void add_product(std::span<const CompiledOperand> operands, std::uint32_t width) {
        std::vector<Program::Step>& steps = program_.steps_;
        if (operands[0].type.extent > 0) {
            add_step({Code::TopTimesNumber, width, 0, 0});
            return;
        }
        const bool single = steps.size() == operands[0].first_step + 2;
        if (single && !operands[0].known.empty()) {
            assert(steps.back().code == Code::PushFormal && "what is known and no formal has been folded");
            const Program::Step formal = steps.back();
            const std::uint32_t number = steps[steps.size() - 2].a;
            steps.resize(steps.size() - 2);
            add_step({Code::PushScaled, width, formal.a, number});
        } else {
            add_step({Code::NumberTimesTop, width, 0, 0});
        }
    }

    void add_step(const Program::Step& step) { program_.steps_.push_back(step); }

    /// `needed` doubles more on the stack, of which `kept` stay.
    void grow(std::size_t needed, std::size_t kept) {
        program_.depth_ = std::max(program_.depth_, height_ + needed);
        height_ += kept;
    }
    void grow(std::size_t needed) { grow(needed, needed); }

    ProgramMaker& maker_;
    std::span<const Extent> extents_;    ///< the extents of the formals
    std::vector<std::uint32_t> offsets_; ///< where the doubles of each formal begin
    std::size_t height_ = 0;             ///< doubles on the stack
    Program program_;
};

ProgramMaker::ProgramMaker(const DefinitionScope& scope)
    : scope_(scope)
    , costs_(definition_costs(scope.definitions)) {
    functions_.reserve(scope.definitions.size());
    for (const Definition& definition : scope.definitions) {
        const std::vector<Extent> numbers(definition.formals.size(), 0);
        functions_.push_back(definition.formals.empty() ? Program() : make(definition.value, numbers));
    }
}

Program ProgramMaker::make(const Expression& expression, std::span<const Extent> formals) {
    Compilation compilation(*this, formals);
    const std::optional<CompiledOperand> value = ExpressionVisitor(scope_.definitions, compilation).visit(expression);
    assert(value && "type_of() accepts the expression");
    return compilation.finish(value->type);
}

} // namespace internode
