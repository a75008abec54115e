// SPDX-License-Identifier: MIT
//
// Derivation as the papers define it, by recursion on sentences: no speed, no code of the library but the grammar's
// own data. Literals must be exact in doubles.

#pragma once

#include "internode/grammar/points/point_grammar.h"

#include "tests/reference/slow_matching.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace internode::reference {

struct SlowValue {
    bool is_point = false;
    std::vector<double> coordinates;
};

struct SlowModule {
    Symbol letter{};
    std::vector<SlowValue> parameters;
};

using Sentence = std::vector<SlowModule>;

inline SlowValue a_number(double value) {
    return {false, {value}};
}

inline SlowValue combine(Operation operation, const SlowValue& a, const SlowValue& b) {
    const double x = a.coordinates[0];
    const double y = b.coordinates[0];
    switch (operation) {
    case Operation::Less:
        return a_number(x < y ? 1 : 0);
    case Operation::LessEqual:
        return a_number(x <= y ? 1 : 0);
    case Operation::Greater:
        return a_number(x > y ? 1 : 0);
    case Operation::GreaterEqual:
        return a_number(x >= y ? 1 : 0);
    case Operation::Equal:
        return a_number(x == y ? 1 : 0);
    case Operation::NotEqual:
        return a_number(x != y ? 1 : 0);
    case Operation::And:
        return a_number(x != 0 && y != 0 ? 1 : 0);
    case Operation::Or:
        return a_number(x != 0 || y != 0 ? 1 : 0);
    case Operation::Minimum:
        return a_number(std::min(x, y));
    case Operation::Maximum:
        return a_number(std::max(x, y));
    default:
        break;
    }
    SlowValue result{a.is_point || b.is_point, {}};
    for (std::size_t i = 0; i < std::max(a.coordinates.size(), b.coordinates.size()); ++i) {
        const double left = a.is_point ? a.coordinates[i] : x;
        const double right = b.is_point ? b.coordinates[i] : y;
        result.coordinates.push_back(operation == Operation::Add        ? left + right
                                     : operation == Operation::Subtract ? left - right
                                     : operation == Operation::Multiply ? left * right
                                                                        : left / right);
    }
    return result;
}

inline SlowValue change(Operation operation, SlowValue a) {
    for (double& x : a.coordinates)
        x = operation == Operation::Negate     ? -x
            : operation == Operation::Floor    ? std::floor(x)
            : operation == Operation::Absolute ? std::abs(x)
            : operation == Operation::Not      ? (x == 0 ? 1 : 0)
                                               : std::sqrt(x);
    return a;
}

inline SlowValue evaluate(const Expression& expression, const std::vector<SlowValue>& formals,
                          const PointGrammar& grammar) {
    std::vector<SlowValue> stack;
    for (const Instruction& instruction : expression.code) {
        if (instruction.operation == Operation::Number) {
            stack.push_back(a_number(expression.numbers[instruction.operand].get_d()));
        } else if (instruction.operation == Operation::Formal) {
            stack.push_back(formals[instruction.operand]);
        } else if (instruction.operation == Operation::Constant) {
            stack.push_back(evaluate(grammar.definitions[instruction.operand].value, {}, grammar));
        } else {
            const bool calls = instruction.operation == Operation::Call;
            const std::size_t arity = calls ? grammar.definitions[instruction.operand].formals.size() : 0;
            const std::size_t count = operand_count(instruction, arity);
            const std::vector<SlowValue> operands(stack.end() - static_cast<std::ptrdiff_t>(count), stack.end());
            stack.resize(stack.size() - count);
            if (calls) {
                stack.push_back(evaluate(grammar.definitions[instruction.operand].value, operands, grammar));
            } else if (instruction.operation == Operation::Point) {
                stack.push_back({true, {}});
                for (const SlowValue& one : operands) stack.back().coordinates.push_back(one.coordinates[0]);
            } else if (instruction.operation == Operation::Coordinate) {
                stack.push_back(a_number(operands[0].coordinates[instruction.operand]));
            } else if (count == 1) {
                stack.push_back(change(instruction.operation, operands[0]));
            } else {
                stack.push_back(combine(instruction.operation, operands[0], operands[1]));
            }
        }
    }
    return stack.back();
}

/// The letters of a sentence as a text, by the first characters of their names, which differ.
inline std::string text_of(const Sentence& sentence, const PointGrammar& grammar) {
    std::string text;
    for (const SlowModule& one : sentence) text += grammar.letters.name(one.letter).front();
    return text;
}

/// The values of the rule's formals when its letters fit with its strict predecessor at i.
inline std::optional<std::vector<SlowValue>> match(const PointRule& rule, const Sentence& sentence,
                                                   const PointGrammar& grammar, std::size_t i) {
    const std::string text = text_of(sentence, grammar);
    const auto spelled = [&](const std::vector<Symbol>& letters) {
        std::string name;
        for (const Symbol letter : letters) name += grammar.letters.name(letter).front();
        return name;
    };
    if (!fits(text, grammar.ring, i, spelled(rule.left), spelled(rule.predecessor), spelled(rule.right)))
        return std::nullopt;
    std::vector<std::size_t> modules;
    for (std::size_t k = 0, at = i; k < rule.left.size(); ++k)
        modules.insert(modules.begin(), at = *module_before(text, grammar.ring, at));
    for (std::size_t k = 0; k < rule.predecessor.size(); ++k) modules.push_back(i + k);
    for (std::size_t k = 0; k < rule.right.size(); ++k)
        modules.push_back(*module_after(text, grammar.ring, modules.back()));
    std::vector<SlowValue> values;
    for (const std::size_t at : modules)
        values.insert(values.end(), sentence[at].parameters.begin(), sentence[at].parameters.end());
    return values;
}

/// What the sentence from module i on becomes, under the rules of a table.
inline Sentence derive_from(std::size_t i, const Sentence& sentence, const PointGrammar& grammar,
                            std::optional<std::uint32_t> table) {
    if (i >= sentence.size()) return {};
    Sentence result{sentence[i]};
    std::size_t consumed = 1;
    for (const PointRule& rule : grammar.rules) {
        if (rule.table && rule.table != table) continue;
        const auto values = match(rule, sentence, grammar, i);
        if (!values) continue;
        if (rule.condition && evaluate(*rule.condition, *values, grammar).coordinates[0] == 0) continue;
        result.clear();
        for (const ModuleTemplate& one : rule.successor) {
            result.push_back({one.letter, {}});
            for (const Expression& argument : one.arguments)
                result.back().parameters.push_back(evaluate(argument, *values, grammar));
        }
        consumed = rule.predecessor.size();
        break;
    }
    const Sentence rest = derive_from(i + consumed, sentence, grammar, table);
    result.insert(result.end(), rest.begin(), rest.end());
    return result;
}

inline Sentence axiom_sentence(const PointGrammar& grammar) {
    Sentence sentence;
    for (const ModuleTemplate& one : *grammar.axiom) {
        sentence.push_back({one.letter, {}});
        for (const Expression& argument : one.arguments)
            sentence.back().parameters.push_back(evaluate(argument, {}, grammar));
    }
    return sentence;
}

} // namespace internode::reference
