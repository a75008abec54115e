// SPDX-License-Identifier: MIT
//
// The one walk over the postfix program of an expression. What the values are, and what an operation does to them, the
// walk asks its operations: types, exact numbers, combinations of points, quotients of polynomials, steps of a program.
//
// Operations are a class with
//     Value                                      what the stack holds
//     bool admits(std::size_t texts)             before each instruction: false ends the walk. `texts`: how many are
//                                                being read within each other, the expression itself is the first
//     const Definition* written_out(Instruction) of a Constant or a Call: the definition whose text is read in its
//     place;
//                                                none: it is applied like an operation
//     std::optional<Value> number(const Rational&)
//     std::optional<Value> formal(std::uint32_t) of the expression itself; the formals of calls are on the stack
//     std::optional<Value> apply(Instruction, std::span<Value> operands)
// A value that is not there ends the walk. Calls have a stack of their own: no text recurses.

#pragma once

#include "internode/expression/definition.h"

#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace internode {

template<typename T>
concept ExpressionOperations = requires(T& operations, Instruction instruction, const Rational& number,
                                        std::span<typename T::Value> operands) {
    { operations.admits(std::size_t{}) } -> std::same_as<bool>;
    { operations.written_out(instruction) } -> std::same_as<const Definition*>;
    { operations.number(number) } -> std::same_as<std::optional<typename T::Value>>;
    { operations.formal(std::uint32_t{}) } -> std::same_as<std::optional<typename T::Value>>;
    { operations.apply(instruction, operands) } -> std::same_as<std::optional<typename T::Value>>;
};

/// For operations that admit every text and write nothing out: a base class.
struct PlainOperations {
    static bool admits(std::size_t /*texts*/) { return true; }
    static const Definition* written_out(Instruction /*instruction*/) { return nullptr; }
};

template<ExpressionOperations Operations>
class ExpressionVisitor {
public:
    using Value = typename Operations::Value;

    /// Both must outlive the visitor.
    ExpressionVisitor(std::span<const Definition> definitions, Operations& operations)
        : definitions_(definitions)
        , operations_(operations) {}

    /// The value of the expression; none where the operations ended the walk. Cost: an operation per instruction.
    std::optional<Value> visit(const Expression& expression) {
        values_.clear();
        texts_.assign(1, {&expression, 0, 0});
        while (!texts_.empty()) {
            Text& text = texts_.back();
            if (text.next == text.expression->code.size())
                leave();
            else if (!operations_.admits(texts_.size()) || !step(*text.expression, text.expression->code[text.next++]))
                return std::nullopt;
        }
        assert(values_.size() == 1 && "an expression leaves one value");
        return std::move(values_.back());
    }

private:
    /// A text that is being read: the expression, or the value of a definition that it names.
    struct Text {
        const Expression* expression = nullptr;
        std::size_t next = 0;      ///< index of the instruction that comes next
        std::size_t arguments = 0; ///< where the arguments of the definition begin on the stack of values
    };

    bool step(const Expression& expression, Instruction instruction) {
        switch (instruction.operation) {
        case Operation::Number:
            assert(instruction.operand < expression.numbers.size());
            return push(operations_.number(expression.numbers[instruction.operand]));
        case Operation::Formal:
            return push(formal(instruction.operand));
        case Operation::Constant:
        case Operation::Call:
            if (const Definition* const definition = operations_.written_out(instruction)) {
                assert(definition->formals.size() == arity(instruction));
                texts_.push_back({&definition->value, 0, values_.size() - definition->formals.size()});
                return true;
            }
            return apply(instruction);
        default:
            return apply(instruction);
        }
    }

    std::optional<Value> formal(std::uint32_t index) {
        if (texts_.size() == 1) return operations_.formal(index);
        assert(texts_.back().arguments + index < values_.size());
        return Value(values_[texts_.back().arguments + index]);
    }

    [[nodiscard]] std::size_t arity(Instruction instruction) const {
        return instruction.operation == Operation::Call ? definitions_[instruction.operand].formals.size() : 0;
    }

    bool apply(Instruction instruction) {
        const std::size_t count = operand_count(instruction, arity(instruction));
        assert(count <= values_.size());
        std::optional<Value> value = operations_.apply(instruction, std::span(values_).last(count));
        drop(values_.size() - count);
        return push(std::move(value));
    }

    /// The arguments of a call give way to its value.
    void leave() {
        const std::size_t arguments = texts_.back().arguments;
        texts_.pop_back();
        std::optional<Value> value = std::move(values_.back());
        drop(arguments);
        push(std::move(value));
    }

    bool push(std::optional<Value> value) {
        if (!value) return false;
        values_.push_back(*std::move(value));
        return true;
    }

    void drop(std::size_t size) { values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(size), values_.end()); }

    std::span<const Definition> definitions_;
    Operations& operations_;
    std::vector<Value> values_;
    std::vector<Text> texts_;
};

} // namespace internode
