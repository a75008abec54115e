// SPDX-License-Identifier: MIT

#include "internode/expression/operation.h"

#include "internode/algebra/fraction.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

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
    return fraction(sqrt(value.get_num()), sqrt(value.get_den()));
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
        assert(operation == Operation::Or && "an operation of numbers");
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

} // namespace

std::optional<Rational> apply_exactly(Operation operation, const Rational& first, const Rational& second) {
    switch (operation) {
    case Operation::Negate:
        return -first;
    case Operation::Floor:
        return floor_of(first);
    case Operation::Absolute:
        return abs(first);
    case Operation::SquareRoot:
        return root_of(first);
    case Operation::Not:
        return Rational(first == 0 ? 1 : 0);
    default:
        return apply_to_two(operation, first, second);
    }
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

std::size_t bit_size(const Rational& value) {
    return mpz_sizeinbase(value.get_num_mpz_t(), 2) + mpz_sizeinbase(value.get_den_mpz_t(), 2);
}

} // namespace internode
