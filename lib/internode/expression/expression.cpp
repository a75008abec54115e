// SPDX-License-Identifier: MIT

#include "internode/expression/expression.h"

namespace internode {

std::size_t operand_count(Instruction instruction, std::size_t call_arity) {
    switch (instruction.operation) {
    case Operation::Number:
    case Operation::Formal:
    case Operation::Constant:
        return 0;
    case Operation::Negate:
    case Operation::Floor:
    case Operation::Absolute:
    case Operation::SquareRoot:
    case Operation::Coordinate:
    case Operation::Not:
        return 1;
    case Operation::Call:
        return call_arity;
    case Operation::Point:
        return instruction.operand;
    default:
        return 2;
    }
}

} // namespace internode
