// SPDX-License-Identifier: MIT

#include "internode/point/evaluation.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

std::uint32_t width_of(Extent extent) {
    return extent == 0 ? 1 : extent;
}

} // namespace

/// One expression on its way to a program: the stack of types, with the values that are known already.
class ProgramMaker::Compilation {
public:
    Compilation(ProgramMaker& maker, const Expression& expression, std::span<const Extent> formals)
        : maker_(maker)
        , expression_(expression)
        , extents_(formals) {
        std::uint32_t offset = 0;
        for (const Extent extent : formals) {
            offsets_.push_back(offset);
            offset += width_of(extent);
        }
    }

    Program run() {
        for (const Instruction& instruction : expression_.code) take(instruction);
        assert(stack_.size() == 1);
        program_.type_ = stack_.back().type;
        return std::move(program_);
    }

private:
    using Code = Program::Code;

    struct Operand {
        ExpressionType type;
        std::size_t first_step = 0;
        std::size_t first_number = 0;
        std::vector<KnownNumber> known; ///< all coordinates or none
    };

    void take(Instruction instruction) {
        switch (instruction.operation) {
        case Operation::Number:
            push_known({}, {{expression_.numbers[instruction.operand], 0}});
            break;
        case Operation::Constant:
            push_known({}, {maker_.constants_[instruction.operand]});
            break;
        case Operation::Formal:
            push_formal(instruction.operand);
            break;
        default:
            combine(instruction);
        }
    }

    void push_known(ExpressionType type, std::vector<KnownNumber> known) {
        const auto first = static_cast<std::uint32_t>(program_.numbers_.size());
        stack_.push_back({type, program_.steps_.size(), first, {}});
        for (const KnownNumber& one : known) program_.numbers_.push_back(nearest(one));
        add_step({Code::Push, static_cast<std::uint32_t>(known.size()), first, 0});
        stack_.back().known = std::move(known);
        grow(width_of(type.extent));
    }

    void push_formal(std::uint32_t formal) {
        const ExpressionType type{false, extents_[formal]};
        stack_.push_back({type, program_.steps_.size(), program_.numbers_.size(), {}});
        add_step({Code::PushFormal, width_of(type.extent), offsets_[formal], 0});
        grow(width_of(type.extent));
    }

    void combine(Instruction instruction) {
        const std::size_t count =
            operand_count(instruction, instruction.operation == Operation::Call
                                           ? maker_.grammar_.definitions[instruction.operand].formals.size()
                                           : 0);
        const std::span<Operand> operands = std::span(stack_).last(count);
        const bool known = std::ranges::none_of(operands, [](const Operand& one) { return one.known.empty(); });
        if (known && fold(instruction, operands)) return;
        const ExpressionType type = emit(instruction, operands);
        const Operand first{type, operands.front().first_step, operands.front().first_number, {}};
        replace(count, first);
    }

    void replace(std::size_t count, Operand result) {
        for (const Operand& one : std::span(stack_).last(count)) height_ -= width_of(one.type.extent);
        stack_.resize(stack_.size() - count);
        grow(width_of(result.type.extent));
        stack_.push_back(std::move(result));
    }

    /// Computes what is known and takes the steps of the operands back.
    bool fold(Instruction instruction, std::span<Operand> operands) {
        ExpressionType type;
        std::vector<KnownNumber> known;
        if (instruction.operation == Operation::Call) {
            const std::uint64_t cost = maker_.costs_[instruction.operand];
            if (cost > maker_.budget_) return false;
            maker_.budget_ -= cost;
            std::vector<KnownNumber> arguments;
            for (const Operand& one : operands) arguments.push_back(one.known.front());
            known.push_back(evaluate_known(maker_.grammar_.definitions[instruction.operand].value, std::move(arguments),
                                           maker_.grammar_, maker_.constants_));
        } else {
            known = fold_operation(instruction, operands, type);
        }
        program_.steps_.resize(operands.front().first_step);
        program_.numbers_.resize(operands.front().first_number);
        for (const Operand& one : operands) height_ -= width_of(one.type.extent);
        stack_.resize(stack_.size() - operands.size());
        push_known(type, std::move(known));
        return true;
    }

    static std::vector<KnownNumber> fold_operation(Instruction instruction, std::span<const Operand> operands,
                                                   ExpressionType& type) {
        std::vector<KnownNumber> known;
        if (instruction.operation == Operation::Coordinate) return {operands[0].known[instruction.operand]};
        if (instruction.operation == Operation::Point) {
            for (const Operand& one : operands) known.push_back(one.known.front());
            type.extent = instruction.operand;
            return known;
        }
        type = result_type(instruction.operation, operands);
        // A number stands beside each coordinate of a point.
        const auto at = [](const Operand& one, std::size_t i) { return one.known[one.known.size() == 1 ? 0 : i]; };
        for (std::size_t i = 0; i < width_of(type.extent); ++i) {
            std::vector<KnownNumber> arguments;
            for (const Operand& one : operands) arguments.push_back(at(one, i));
            known.push_back(apply_operation(instruction.operation, arguments));
        }
        return known;
    }

    static ExpressionType result_type(Operation operation, std::span<const Operand> operands) {
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

    ExpressionType emit(Instruction instruction, std::span<const Operand> operands) {
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
    void add_sum(const Operand& second, std::uint32_t width) {
        Program::Step& last = program_.steps_.back();
        if (last.code == Code::PushScaled && program_.steps_.size() == second.first_step + 1)
            last.code = Code::AddScaled;
        else
            add_step({Code::Add, width, 0, 0});
    }

    /// `3/4 v` is one step.
    void add_product(std::span<const Operand> operands, std::uint32_t width) {
        std::vector<Program::Step>& steps = program_.steps_;
        if (operands[0].type.extent > 0) {
            add_step({Code::TopTimesNumber, width, 0, 0});
            return;
        }
        const bool single = steps.size() == operands[0].first_step + 2;
        if (single && !operands[0].known.empty() && steps.back().code == Code::PushFormal) {
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
    const Expression& expression_;
    std::span<const Extent> extents_;
    std::vector<std::uint32_t> offsets_; ///< of each formal among the doubles
    std::vector<Operand> stack_;
    std::size_t height_ = 0; ///< doubles on the stack
    Program program_;
};

ProgramMaker::ProgramMaker(const PointGrammar& grammar, std::span<const KnownNumber> constants)
    : grammar_(grammar)
    , constants_(constants)
    , costs_(definition_costs(grammar)) {
    functions_.reserve(grammar.definitions.size());
    for (const Definition& definition : grammar.definitions) {
        const std::vector<Extent> numbers(definition.formals.size(), 0);
        functions_.push_back(definition.formals.empty() ? Program() : make(definition.value, numbers));
    }
}

Program ProgramMaker::make(const Expression& expression, std::span<const Extent> formals) {
    return Compilation(*this, expression, formals).run();
}

void Evaluator::push(const Program& program, std::span<const double> formals) {
    if (stack_.size() < top_ + program.depth_) stack_.resize(top_ + program.depth_);
    run({&program, 0, formals.data(), top_});
}

double Evaluator::number(const Program& program, std::span<const double> formals) {
    clear();
    push(program, formals);
    return stack_.front();
}

void Evaluator::run(Frame frame) {
    frames_.clear();
    while (true) {
        const std::vector<Program::Step>& steps = frame.program->steps_;
        while (frame.next < steps.size() && steps[frame.next].code != Program::Code::Call)
            step(*frame.program, steps[frame.next++], frame.formals);
        if (frame.next < steps.size()) {
            const Program::Step& call = steps[frame.next++];
            const std::size_t base = top_ - call.width;
            frames_.push_back(frame);
            frame = {&functions_[call.a], 0, stack_.data() + base, base};
        } else if (frames_.empty()) {
            return;
        } else {
            stack_[frame.base] = stack_[top_ - 1];
            top_ = frame.base + 1;
            frame = frames_.back();
            frames_.pop_back();
        }
    }
}

void Evaluator::step(const Program& program, const Program::Step& step, const double* formals) {
    using Code = Program::Code;
    ++work_;
    const std::size_t width = step.width;
    double* const top = stack_.data() + top_;
    switch (step.code) {
    case Code::Push:
        std::copy_n(program.numbers_.data() + step.a, width, top);
        top_ += width;
        break;
    case Code::PushFormal:
        std::copy_n(formals + step.a, width, top);
        top_ += width;
        break;
    case Code::PushScaled:
        for (std::size_t i = 0; i < width; ++i) top[i] = program.numbers_[step.b] * formals[step.a + i];
        top_ += width;
        break;
    case Code::AddScaled:
        for (std::size_t i = 0; i < width; ++i) (top - width)[i] += program.numbers_[step.b] * formals[step.a + i];
        break;
    case Code::Add:
        for (std::size_t i = 0; i < width; ++i) (top - 2 * width)[i] += (top - width)[i];
        top_ -= width;
        break;
    case Code::Subtract:
        for (std::size_t i = 0; i < width; ++i) (top - 2 * width)[i] -= (top - width)[i];
        top_ -= width;
        break;
    case Code::Negate:
        for (std::size_t i = 0; i < width; ++i) (top - width)[i] = -(top - width)[i];
        break;
    default:
        other_step(step, top);
    }
}

/// Steps in which a point meets a number.
void Evaluator::other_step(const Program::Step& step, double* top) {
    using Code = Program::Code;
    const std::size_t width = step.width;
    switch (step.code) {
    case Code::NumberTimesTop: {
        double* const number = top - width - 1;
        const double factor = *number;
        for (std::size_t i = 0; i < width; ++i) number[i] = factor * number[i + 1];
        --top_;
        break;
    }
    case Code::TopTimesNumber:
        for (std::size_t i = 0; i < width; ++i) (top - 1 - width)[i] *= top[-1];
        --top_;
        break;
    case Code::TopDividedBy:
        for (std::size_t i = 0; i < width; ++i) (top - 1 - width)[i] /= top[-1];
        --top_;
        break;
    case Code::TakeCoordinate:
        (top - width)[0] = (top - width)[step.a];
        top_ -= width - 1;
        break;
    case Code::ApplyOne:
        top[-1] = apply_operation(static_cast<Operation>(step.a), top[-1], 0);
        break;
    default:
        assert(step.code == Code::ApplyTwo);
        top[-2] = apply_operation(static_cast<Operation>(step.a), top[-2], top[-1]);
        --top_;
    }
}

} // namespace internode
