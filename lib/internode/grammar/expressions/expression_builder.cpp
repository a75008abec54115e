// SPDX-License-Identifier: MIT

#include "internode/grammar/expressions/expression_builder.h"

#include "internode/algebra/fraction.h"
#include "internode/expression/operation.h"
#include "internode/grammar/lexing/limits.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

bool is_comparison(Operation operation) {
    return operation >= Operation::Less && operation <= Operation::NotEqual;
}

bool is_logical(Operation operation) {
    return operation >= Operation::And;
}

bool is_folded(Operation operation) {
    return operation >= Operation::Negate && operation <= Operation::Divide;
}

/// Whether a number prints as digits that may be read again.
bool is_short(const Rational& value) {
    static const Integer limit = [] {
        Integer power;
        mpz_ui_pow_ui(power.get_mpz_t(), 10, max_digits);
        return power;
    }();
    return mpz_cmpabs(value.get_num_mpz_t(), limit.get_mpz_t()) < 0 &&
           mpz_cmpabs(value.get_den_mpz_t(), limit.get_mpz_t()) < 0;
}

/// Of + - * / and unary minus; the operands are sound.
ValueKind kind_of_value(ValueKind a, ValueKind b, Operation operation) {
    if (operation == Operation::Divide) return a;
    if (a == ValueKind::Point || b == ValueKind::Point) return ValueKind::Point;
    const bool is_product = operation == Operation::Multiply;
    if (is_product && a == ValueKind::Number) return b;
    if (!is_product && (a == ValueKind::Number || b == ValueKind::Number)) return ValueKind::Number;
    return is_product && b == ValueKind::Number ? a : ValueKind::NumberOrPoint;
}

constexpr std::string_view truth_hint = "a condition compares numbers: `x < 2`, `x == 0 and y != 1`";
constexpr std::string_view coordinate_hint = "`.x`, `.y`, `.z`, `.w` are the coordinates of a point";

} // namespace

bool ExpressionBuilder::refuse(std::string_view code, Place place, std::string message, std::string hint) {
    complaints_.add(code, place, std::move(message), std::move(hint));
    return false;
}

ExpressionBuilder::Place ExpressionBuilder::place_of_last(std::size_t count) const {
    assert(count > 0 && count <= operands_.size());
    const Place& first = operands_[operands_.size() - count].place;
    const Place& last = operands_.back().place;
    return {first.offset, last.offset + last.bytes - first.offset};
}

bool ExpressionBuilder::push(Instruction instruction, Operand operand) {
    if (++counted_ > max_expression_instructions)
        return refuse("expression.too-long", operand.place,
                      fmt::format("an expression of more than {} operations", max_expression_instructions));
    if (++budget_.instructions > max_point_instructions)
        return refuse("expression.too-many-operations", operand.place,
                      fmt::format("more than {} operations in one grammar", max_point_instructions));
    expression_.code.push_back(instruction);
    operands_.push_back(operand);
    return true;
}

bool ExpressionBuilder::replace(Instruction instruction, std::size_t count, Operand result) {
    result.place = place_of_last(count);
    assert(count <= operands_.size());
    operands_.resize(operands_.size() - count);
    return push(instruction, result);
}

bool ExpressionBuilder::number(Rational value, Place place) {
    assert(is_canonical(value));
    expression_.numbers.push_back(std::move(value));
    return push({Operation::Number, static_cast<std::uint32_t>(expression_.numbers.size() - 1)},
                {ValueKind::Number, true, false, 0, place});
}

bool ExpressionBuilder::formal(std::uint32_t index, Place place) {
    return push({Operation::Formal, index}, {ValueKind::NumberOrPoint, false, false, 0, place});
}

bool ExpressionBuilder::constant(std::uint32_t index, Place place) {
    return push({Operation::Constant, index}, {ValueKind::Number, false, false, 0, place});
}

bool ExpressionBuilder::are_values(std::size_t count, std::string_view hint) {
    for (std::size_t i = 0; i < count; ++i)
        if (operand(i).kind == ValueKind::Truth)
            return refuse("expression.truth-for-number", operand(i).place, "a truth where a number is wanted",
                          std::string(hint));
    return true;
}

bool ExpressionBuilder::are_numbers(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        if (operand(i).kind == ValueKind::Point)
            return refuse("expression.point-for-number", operand(i).place, "a point where a number is wanted",
                          std::string(coordinate_hint));
    return true;
}

bool ExpressionBuilder::are_truths(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        if (operand(i).kind != ValueKind::Truth)
            return refuse("expression.number-for-truth", operand(i).place, "a number where a truth is wanted",
                          std::string(truth_hint));
    return true;
}

bool ExpressionBuilder::has_sound_operands(Operation operation, Place place) {
    const std::size_t count = operand_count({operation, 0}, 0);
    if (is_logical(operation)) return are_truths(count);
    if (is_comparison(operation))
        return are_values(count, "comparisons are joined by `and`: `0 < x and x < 1`") && are_numbers(count);
    if (!are_values(count)) return false;
    if (!is_folded(operation)) return are_numbers(count);
    if (count == 1) return true;
    const Operand& a = operand(1);
    const Operand& b = operand(0);
    if (operation == Operation::Divide && b.kind == ValueKind::Point)
        return refuse("expression.division-by-point", b.place, "a division by a point", std::string(coordinate_hint));
    if (operation == Operation::Divide && b.literal && sgn(expression_.numbers.back()) == 0)
        return refuse("expression.division-by-zero", place_of_last(2), "a division by zero");
    if (operation == Operation::Multiply && a.kind == ValueKind::Point && b.kind == ValueKind::Point)
        return refuse("expression.product-of-points", place_of_last(2), "a product of two points",
                      std::string(coordinate_hint));
    const bool is_mixed = (a.kind == ValueKind::Number && b.kind == ValueKind::Point) ||
                          (a.kind == ValueKind::Point && b.kind == ValueKind::Number);
    if (is_mixed && (operation == Operation::Add || operation == Operation::Subtract))
        return refuse("expression.sum-of-number-and-point", place, "a sum of a number and a point",
                      std::string(coordinate_hint));
    return true;
}

bool ExpressionBuilder::fold(Operation operation, std::size_t count, Operand result) {
    std::vector<Rational>& numbers = expression_.numbers;
    assert(numbers.size() >= count && count >= 1 && count <= 2);
    const Rational last = numbers.back();
    if (count == 2) numbers.pop_back();
    numbers.back() = apply_exactly(operation, numbers.back(), last).value();
    expression_.code.resize(expression_.code.size() - count);
    if (!is_short(numbers.back()))
        return refuse("expression.too-many-digits", place_of_last(count),
                      fmt::format("a number of more than {} digits", max_digits));
    result.literal = true;
    result.quotient = false;
    return replace({Operation::Number, static_cast<std::uint32_t>(numbers.size() - 1)}, count, result);
}

bool ExpressionBuilder::apply(Operation operation, Place place) {
    if (!has_sound_operands(operation, place)) return false;
    const std::size_t count = operand_count({operation, 0}, 0);
    const bool all_literal = operand(0).literal && operand(count - 1).literal;
    Operand result;
    result.quotient = operation == Operation::Divide;
    if (is_comparison(operation) || is_logical(operation))
        result.kind = ValueKind::Truth;
    else if (is_folded(operation))
        result.kind = count == 1 ? operand(0).kind : kind_of_value(operand(1).kind, operand(0).kind, operation);
    if (all_literal && is_folded(operation)) return fold(operation, count, result);
    return replace({operation, 0}, count, result);
}

bool ExpressionBuilder::call(std::uint32_t definition, std::size_t arity) {
    if (!are_values(arity)) return false;
    return replace({Operation::Call, definition}, arity, {});
}

bool ExpressionBuilder::point(std::size_t coordinates, Place place) {
    if (coordinates > max_coordinates)
        return refuse("expression.too-many-coordinates", place,
                      fmt::format("a point of {} coordinates, more than {}", coordinates, max_coordinates));
    if (!are_values(coordinates) || !are_numbers(coordinates)) return false;
    const auto count = static_cast<std::uint32_t>(coordinates);
    return replace({Operation::Point, count}, coordinates, {ValueKind::Point, false, false, count, {}});
}

bool ExpressionBuilder::coordinate(std::uint32_t index, Place place) {
    const Operand& from = operand(0);
    if (from.kind == ValueKind::Number || from.kind == ValueKind::Truth)
        return refuse("expression.coordinate-of-number", place, "a coordinate of what is no point",
                      std::string(coordinate_hint));
    if (from.coordinates != 0 && index >= from.coordinates)
        return refuse("expression.coordinate-out-of-range", place,
                      fmt::format("coordinate {} of a point of {}", index + 1, from.coordinates));
    return replace({Operation::Coordinate, index}, 1, {});
}

void ExpressionBuilder::enclose(std::size_t begin, std::size_t end) {
    assert(!operands_.empty() && begin < end);
    operands_.back().quotient = false;
    operands_.back().place = {begin, end - begin};
}

Expression ExpressionBuilder::expression(Place place) && {
    assert(operands_.size() == 1);
    expression_.place = SourcePlace{place.offset, place.bytes};
    return std::move(expression_);
}

} // namespace internode
