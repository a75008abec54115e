// SPDX-License-Identifier: MIT
//
// The exact matrix of one step of a linear point grammar without tables, by rewriting words whose points are rows:
// slow, and nothing but the definition.

#pragma once

#include "internode/algebra/rational_matrix.h"
#include "internode/grammar/points/point_grammar.h"
#include "internode/point/matching.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

namespace internode::tests {

struct RowValue {
    Rational number;           ///< of a number
    std::vector<Rational> row; ///< of a point: its weights over the old points; empty for a number
};

inline RowValue row_sum(RowValue a, const RowValue& b, int sign) {
    a.number += sign * b.number;
    for (std::size_t i = 0; i < a.row.size(); ++i) a.row[i] += sign * b.row.at(i);
    return a;
}

inline RowValue row_product(const RowValue& a, const RowValue& b) {
    const RowValue& factor = a.row.empty() ? a : b;
    RowValue result = a.row.empty() ? b : a;
    if (!factor.row.empty()) throw std::logic_error("a product of two points");
    result.number *= factor.number;
    for (Rational& weight : result.row) weight *= factor.number;
    return result;
}

inline RowValue row_value(const Expression& expression, const std::vector<RowValue>& formals) {
    std::vector<RowValue> stack;
    const auto pop = [&stack] {
        RowValue value = stack.at(stack.size() - 1);
        stack.pop_back();
        return value;
    };
    for (const Instruction& instruction : expression.code) {
        if (instruction.operation == Operation::Number) {
            stack.push_back({expression.numbers.at(instruction.operand), {}});
        } else if (instruction.operation == Operation::Formal) {
            stack.push_back(formals.at(instruction.operand));
        } else if (instruction.operation == Operation::Negate) {
            stack.push_back(row_product({-1, {}}, pop()));
        } else {
            const RowValue b = pop();
            const RowValue a = pop();
            const bool is_product = instruction.operation == Operation::Multiply;
            const bool is_sum = instruction.operation == Operation::Add;
            if (!is_product && !is_sum && instruction.operation != Operation::Subtract)
                throw std::logic_error("not a linear expression");
            stack.push_back(is_product ? row_product(a, b) : row_sum(a, b, is_sum ? 1 : -1));
        }
    }
    return stack.at(0);
}

struct RowModule {
    Symbol letter{};
    std::vector<RowValue> values; ///< none or one
};

/// What a polygon of `points` points becomes: P, or the grammar's input.
inline std::vector<RowModule> row_input(const PointGrammar& grammar, std::size_t points) {
    std::vector<RowModule> word;
    for (std::size_t i = 0; i < points; ++i) {
        RowValue point{0, std::vector<Rational>(points)};
        point.row[i] = 1;
        if (!grammar.input) {
            word.push_back({grammar.letters.find("P").value(), {point}});
            continue;
        }
        const PointInput& input = *grammar.input;
        for (const ModuleTemplate& module : i == 0 ? input.first : i + 1 == points ? input.last : input.each) {
            word.push_back({module.letter, {}});
            for (const Expression& argument : module.arguments)
                word.back().values.push_back(row_value(argument, {point}));
        }
    }
    return word;
}

/// One step; strict predecessors of several modules from the first module on.
inline std::vector<RowModule> row_step(const PointGrammar& grammar, const std::vector<RowModule>& old) {
    std::vector<Symbol> letters;
    for (const RowModule& module : old) letters.push_back(module.letter);
    const WordShape shape(letters, grammar);
    std::vector<RowModule> word;
    for (std::size_t i = 0; i < old.size();) {
        std::vector<std::size_t> read;
        const auto applied =
            std::ranges::find_if(grammar.rules, [&](const PointRule& rule) { return shape.fits(rule, i, read); });
        if (applied == grammar.rules.end()) {
            word.push_back(old[i++]);
            continue;
        }
        std::vector<RowValue> formals;
        for (const std::size_t module : read)
            formals.insert(formals.end(), old[module].values.begin(), old[module].values.end());
        for (const ModuleTemplate& module : applied->successor) {
            word.push_back({module.letter, {}});
            for (const Expression& argument : module.arguments)
                word.back().values.push_back(row_value(argument, formals));
        }
        i += applied->predecessor.size();
    }
    return word;
}

/// New points = matrix * old points, for so many old points (at least 2 when the grammar's input has ends).
inline RationalMatrix row_matrix(const PointGrammar& grammar, std::size_t points) {
    RationalMatrix matrix{points, {}};
    for (const RowModule& module : row_step(grammar, row_input(grammar, points))) {
        if (module.values.empty()) continue;
        RationalRow& row = matrix.rows.emplace_back();
        for (std::size_t column = 0; column < points; ++column)
            if (module.values[0].row.at(column) != 0) row.push_back({column, module.values[0].row[column]});
    }
    return matrix;
}

/// Row i of the result is row i + by of the matrix, round its end.
inline RationalMatrix rotated_rows(const RationalMatrix& matrix, std::ptrdiff_t by) {
    RationalMatrix result{matrix.columns, {}};
    const auto rows = static_cast<std::ptrdiff_t>(matrix.rows.size());
    for (std::ptrdiff_t i = 0; i < rows; ++i)
        result.rows.push_back(matrix.rows[static_cast<std::size_t>(((i + by) % rows + rows) % rows)]);
    return result;
}

inline RationalMatrix row_product(const RationalMatrix& a, const RationalMatrix& b) {
    RationalMatrix result{b.columns, {}};
    for (const RationalRow& row : a.rows) {
        std::vector<Rational> sums(b.columns);
        for (const RationalEntry& outer : row)
            for (const RationalEntry& inner : b.rows.at(outer.column)) sums[inner.column] += outer.value * inner.value;
        RationalRow& product = result.rows.emplace_back();
        for (std::size_t column = 0; column < b.columns; ++column)
            if (sums[column] != 0) product.push_back({column, sums[column]});
    }
    return result;
}

inline RationalMatrix row_identity(std::size_t size) {
    RationalMatrix result{size, {}};
    for (std::size_t i = 0; i < size; ++i) result.rows.push_back({{i, 1}});
    return result;
}

} // namespace internode::tests
