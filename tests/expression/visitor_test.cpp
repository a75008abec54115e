// SPDX-License-Identifier: MIT

#include "internode/expression/visitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace internode {
namespace {

/// Values as texts in full parentheses: the walk is seen in them.
class TextOperations : public PlainOperations {
public:
    using Value = std::string;

    [[nodiscard]] bool admits(std::size_t texts) {
        most_texts = std::max(most_texts, texts);
        return ++instructions <= most_instructions;
    }
    [[nodiscard]] const Definition* written_out(Instruction instruction) const {
        return writes_out ? &definitions[instruction.operand] : nullptr;
    }
    static std::optional<std::string> number(const Rational& number) { return to_string(number); }
    [[nodiscard]] static std::optional<std::string> formal(std::uint32_t index) {
        return std::string("f") + std::to_string(index);
    }
    [[nodiscard]] std::optional<std::string> apply(Instruction instruction,
                                                   std::span<const std::string> operands) const {
        if (instruction.operation == refused) return std::nullopt;
        std::string text = std::to_string(static_cast<int>(instruction.operation)) + "(";
        for (const std::string& operand : operands) text += (text.back() == '(' ? "" : " ") + operand;
        return text + ")";
    }

    std::vector<Definition> definitions;
    bool writes_out = false;
    std::size_t most_instructions = 100;
    std::optional<Operation> refused;
    std::size_t instructions = 0;
    std::size_t most_texts = 0;
};

std::string named(Operation operation) {
    return std::to_string(static_cast<int>(operation));
}

/// half = 1/2 and mean(a, b) = half * (a + b).
std::vector<Definition> definitions() {
    const Expression half{{{Operation::Number, 0}}, {Rational(1, 2)}, {}};
    const Expression mean{{{Operation::Constant, 0},
                           {Operation::Formal, 0},
                           {Operation::Formal, 1},
                           {Operation::Add, 0},
                           {Operation::Multiply, 0}},
                          {},
                          {}};
    return {{"half", {}, half, {}}, {"mean", {"a", "b"}, mean, {}}};
}

/// mean(f1, 7) - f0.
Expression call() {
    return {{{Operation::Formal, 1},
             {Operation::Number, 0},
             {Operation::Call, 1},
             {Operation::Formal, 0},
             {Operation::Subtract, 0}},
            {Rational(7)},
            {}};
}

TEST(ExpressionVisitor, AppliesOperationsToTheirOperandsInOrder) {
    TextOperations operations;
    operations.definitions = definitions();
    const auto text = ExpressionVisitor(std::span<const Definition>(operations.definitions), operations).visit(call());
    EXPECT_EQ(text, named(Operation::Subtract) + "(" + named(Operation::Call) + "(f1 7) f0)");
    EXPECT_EQ(operations.most_texts, 1U);
    EXPECT_EQ(operations.instructions, 5U);
}

TEST(ExpressionVisitor, WritesOutWhatTheOperationsAskFor) {
    TextOperations operations;
    operations.definitions = definitions();
    operations.writes_out = true;
    const auto text = ExpressionVisitor(std::span<const Definition>(operations.definitions), operations).visit(call());
    EXPECT_EQ(text, named(Operation::Subtract) + "(" + named(Operation::Multiply) + "(1/2 " + named(Operation::Add) +
                        "(f1 7)) f0)");
    EXPECT_EQ(operations.most_texts, 3U) << "the expression, mean in it, half in mean";
    EXPECT_EQ(operations.instructions, 5U + 5U + 1U);
}

TEST(ExpressionVisitor, EndsWhereTheOperationsEndIt) {
    TextOperations operations;
    operations.definitions = definitions();
    operations.refused = Operation::Subtract;
    ExpressionVisitor visitor(std::span<const Definition>(operations.definitions), operations);
    EXPECT_EQ(visitor.visit(call()), std::nullopt);
    operations.refused.reset();
    EXPECT_NE(visitor.visit(call()), std::nullopt) << "and begins anew";
    operations.most_instructions = operations.instructions + 4;
    EXPECT_EQ(visitor.visit(call()), std::nullopt);
}

} // namespace
} // namespace internode
