// SPDX-License-Identifier: MIT
//
// Programs run in doubles: what a derivation does for every parameter of every module.

#pragma once

#include "internode/expression/program.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace internode {

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
