// SPDX-License-Identifier: MIT

#include "internode/expression/known_number.h"

#include "internode/point/limits.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

std::size_t bits(const Rational& value) {
    return mpz_sizeinbase(value.get_num_mpz_t(), 2) + mpz_sizeinbase(value.get_den_mpz_t(), 2);
}

Rational floor_of(const Rational& value) {
    Integer quotient;
    mpz_fdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
    return quotient;
}

/// In lowest terms a rational is a square iff its numerator and its denominator are.
std::optional<Rational> root_of(const Rational& value) {
    if (value < 0 || mpz_perfect_square_p(value.get_num_mpz_t()) == 0 ||
        mpz_perfect_square_p(value.get_den_mpz_t()) == 0)
        return std::nullopt;
    return Rational(sqrt(value.get_num()), sqrt(value.get_den()));
}

std::optional<Rational> apply_to_one(Operation operation, const Rational& a) {
    switch (operation) {
    case Operation::Negate:
        return -a;
    case Operation::Floor:
        return floor_of(a);
    case Operation::Absolute:
        return abs(a);
    case Operation::SquareRoot:
        return root_of(a);
    case Operation::Not:
        return Rational(a == 0 ? 1 : 0);
    default:
        assert(false && "an operation of two numbers");
        return std::nullopt;
    }
}

bool holds(Operation operation, const auto& a, const auto& b) {
    switch (operation) {
    case Operation::Less:
        return a < b;
    case Operation::LessEqual:
        return a <= b;
    case Operation::Greater:
        return a > b;
    case Operation::GreaterEqual:
        return a >= b;
    case Operation::Equal:
        return a == b;
    case Operation::NotEqual:
        return a != b;
    case Operation::And:
        return a != 0 && b != 0;
    default:
        assert(operation == Operation::Or);
        return a != 0 || b != 0;
    }
}

std::optional<Rational> apply_to_two(Operation operation, const Rational& a, const Rational& b) {
    switch (operation) {
    case Operation::Add:
        return a + b;
    case Operation::Subtract:
        return a - b;
    case Operation::Multiply:
        return a * b;
    case Operation::Divide:
        if (b == 0) return std::nullopt;
        return a / b;
    case Operation::Minimum:
        return std::min(a, b);
    case Operation::Maximum:
        return std::max(a, b);
    default:
        return Rational(holds(operation, a, b) ? 1 : 0);
    }
}

std::optional<Rational> apply_exactly(Operation operation, std::span<const KnownNumber> arguments) {
    for (const KnownNumber& argument : arguments)
        if (!argument.exact) return std::nullopt;
    std::optional<Rational> value = arguments.size() == 1
                                        ? apply_to_one(operation, *arguments[0].exact)
                                        : apply_to_two(operation, *arguments[0].exact, *arguments[1].exact);
    if (value && bits(*value) > max_known_bits) return std::nullopt;
    return value;
}

} // namespace

double nearest(const KnownNumber& number) {
    return number.exact ? to_double(*number.exact) : number.value;
}

KnownNumber apply_operation(Operation operation, std::span<const KnownNumber> arguments) {
    if (std::optional<Rational> exact = apply_exactly(operation, arguments)) return {std::move(exact), 0};
    const double first = nearest(arguments.front());
    return {std::nullopt, apply_operation(operation, first, nearest(arguments.back()))};
}

double apply_operation(Operation operation, double first, double second) {
    switch (operation) {
    case Operation::Negate:
        return -first;
    case Operation::Floor:
        return std::floor(first);
    case Operation::Absolute:
        return std::abs(first);
    case Operation::SquareRoot:
        return std::sqrt(first);
    case Operation::Not:
        return first == 0 ? 1 : 0;
    case Operation::Add:
        return first + second;
    case Operation::Subtract:
        return first - second;
    case Operation::Multiply:
        return first * second;
    case Operation::Divide:
        return first / second;
    case Operation::Minimum:
        // NaN is passed on, whichever side it is on: a stored NaN is refused, a lost one would be a wrong number.
        return first <= second || std::isnan(first) ? first : second;
    case Operation::Maximum:
        return first >= second || std::isnan(first) ? first : second;
    default:
        return holds(operation, first, second) ? 1 : 0;
    }
}

} // namespace internode
