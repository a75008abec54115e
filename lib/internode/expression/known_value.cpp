// SPDX-License-Identifier: MIT

#include "internode/expression/known_value.h"

#include "internode/expression/limits.h"
#include "internode/expression/visitor.h"

#include <cassert>

namespace internode {

namespace {

/// Arithmetic on known numbers (expression/known_number.h); functions are written out.
class KnownOperations : public PlainOperations {
public:
    using Value = KnownNumber;

    KnownOperations(std::span<const KnownNumber> arguments, const DefinitionScope& scope)
        : arguments_(arguments)
        , scope_(scope) {}

    const Definition* written_out(Instruction instruction) const {
        return instruction.operation == Operation::Call ? &scope_.definitions[instruction.operand] : nullptr;
    }
    static std::optional<KnownNumber> number(const Rational& number) { return KnownNumber{number, 0}; }
    std::optional<KnownNumber> formal(std::uint32_t index) const {
        assert(index < arguments_.size());
        return arguments_[index];
    }
    std::optional<KnownNumber> apply(Instruction instruction, std::span<const KnownNumber> operands) const {
        if (instruction.operation != Operation::Constant) return apply_operation(instruction.operation, operands);
        assert(instruction.operand < scope_.constants.size());
        return scope_.constants[instruction.operand];
    }

private:
    std::span<const KnownNumber> arguments_;
    const DefinitionScope& scope_;
};

} // namespace

KnownNumber evaluate_known(const Expression& expression, std::span<const KnownNumber> arguments,
                           const DefinitionScope& scope) {
    KnownOperations operations(arguments, scope);
    return ExpressionVisitor(scope.definitions, operations).visit(expression).value();
}

std::uint64_t operations(const Expression& expression, std::span<const std::uint64_t> definition_costs) {
    std::uint64_t sum = 0;
    for (const Instruction& instruction : expression.code) {
        sum += instruction.operation == Operation::Call ? 1 + definition_costs[instruction.operand] : 1;
        if (sum > max_expression_operations) return max_expression_operations + 1;
    }
    return sum;
}

std::vector<std::uint64_t> definition_costs(std::span<const Definition> definitions) {
    std::vector<std::uint64_t> costs;
    for (const Definition& definition : definitions) costs.push_back(operations(definition.value, costs));
    return costs;
}

} // namespace internode
