// SPDX-License-Identifier: MIT

#include "internode/expression/program_run.h"

#include "internode/expression/operation.h"

#include <algorithm>
#include <cassert>

namespace internode {

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
