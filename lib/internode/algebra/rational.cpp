// SPDX-License-Identifier: MIT
//
// The nearest double is found in integers: the quotient scaled so that its last bit is the unit in the last place, then
// rounded to even once. No step rounds twice, and subnormals need no case of their own.

#include "internode/algebra/rational.h"

#include "internode/algebra/fraction.h"
#include "internode/text/ascii.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace internode {

namespace {

constexpr int mantissa_bits = std::numeric_limits<double>::digits;
constexpr long lowest_exponent = std::numeric_limits<double>::min_exponent - mantissa_bits; // 2^-1074 is the least

/// Takes the digits at the front of a text.
std::string_view take_digits(std::string_view& text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_ascii_digit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    return digits;
}

bool take(std::string_view& text, char character) {
    if (text.empty() || text.front() != character) return false;
    text.remove_prefix(1);
    return true;
}

Integer to_integer(std::string_view digits) {
    assert(std::ranges::all_of(digits, is_ascii_digit));
    return digits.empty() ? Integer(0) : Integer(std::string(digits), 10);
}

Rational power_of_ten(int exponent) {
    Integer power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
    return exponent < 0 ? fraction(1, power) : Rational(power);
}

/// The exponent after "e": empty if malformed or out of bounds.
std::optional<int> take_exponent(std::string_view& text) {
    const bool negative = take(text, '-');
    if (!negative) take(text, '+');
    const std::string_view digits = take_digits(text);
    if (digits.empty()) return std::nullopt;
    int exponent = 0;
    for (const char digit : digits) {
        exponent = 10 * exponent + (digit - '0');
        if (exponent > max_exponent) return std::nullopt;
    }
    return negative ? -exponent : exponent;
}

/// ".25e-3" after the integer part.
std::optional<Rational> take_decimal(std::string_view whole, std::string_view text) {
    std::string_view fraction;
    if (take(text, '.')) {
        fraction = take_digits(text);
        if (fraction.empty()) return std::nullopt;
    }
    int exponent = 0;
    if (take(text, 'e') || take(text, 'E')) {
        const auto given = take_exponent(text);
        if (!given) return std::nullopt;
        exponent = *given;
    }
    if (!text.empty() || whole.size() + fraction.size() > max_digits) return std::nullopt;
    const Integer digits = to_integer(std::string(whole) + std::string(fraction));
    return Rational(digits) * power_of_ten(exponent - static_cast<int>(fraction.size()));
}

std::optional<Rational> take_fraction(std::string_view whole, std::string_view denominator) {
    const std::string_view digits = take_digits(denominator);
    if (digits.empty() || !denominator.empty() || whole.size() + digits.size() > max_digits) return std::nullopt;
    const Integer divisor = to_integer(digits);
    if (divisor == 0) return std::nullopt;
    return fraction(to_integer(whole), divisor);
}

/// floor(log2(value)) of a positive rational.
long floor_log2(const Rational& value) {
    assert(value > 0);
    const Integer& numerator = value.get_num();
    const Integer& denominator = value.get_den();
    const long guess = static_cast<long>(mpz_sizeinbase(numerator.get_mpz_t(), 2)) -
                       static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
    const auto shift = static_cast<mp_bitcnt_t>(std::labs(guess));
    const bool reached = guess >= 0 ? numerator >= (denominator << shift) : (numerator << shift) >= denominator;
    return reached ? guess : guess - 1;
}

/// The nearest integer, ties to even, of numerator / denominator > 0.
Integer round_quotient(const Integer& numerator, const Integer& denominator) {
    assert(numerator >= 0 && denominator > 0);
    Integer quotient;
    Integer remainder;
    mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
    const int half = cmp(Integer(2 * remainder), denominator);
    if (half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()) != 0)) ++quotient;
    return quotient;
}

} // namespace

std::optional<Rational> parse_rational(std::string_view text) {
    const bool negative = take(text, '-');
    const std::string_view whole = take_digits(text);
    std::optional<Rational> value;
    if (!whole.empty() && take(text, '/'))
        value = take_fraction(whole, text);
    else if (!whole.empty() || (!text.empty() && text.front() == '.'))
        value = take_decimal(whole, text);
    if (value && negative) *value = -*value;
    return value;
}

std::string to_string(const Rational& value) {
    assert(is_canonical(value));
    return value.get_str();
}

double to_double(const Rational& value) {
    assert(is_canonical(value));
    if (value == 0) return 0;
    const Rational magnitude = abs(value);
    const long log2 = floor_log2(magnitude);
    if (log2 >= std::numeric_limits<double>::max_exponent)
        return value < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
    // The unit in the last place; a value below half the least double rounds to 0 like any other.
    const long unit = std::max(log2 - (mantissa_bits - 1), lowest_exponent);
    const auto shift = static_cast<mp_bitcnt_t>(std::labs(unit));
    const Integer mantissa = unit < 0 ? round_quotient(magnitude.get_num() << shift, magnitude.get_den())
                                      : round_quotient(magnitude.get_num(), magnitude.get_den() << shift);
    if (mantissa == 0) return 0;
    // At most 2^53: the conversion and the scaling are exact, or overflow to infinity as they should.
    const double result = std::ldexp(mantissa.get_d(), static_cast<int>(unit));
    return value < 0 ? -result : result;
}

Rational to_rational(double value) {
    if (!std::isfinite(value)) throw std::invalid_argument("only a finite number has a rational value");
    return Rational(value);
}

} // namespace internode
