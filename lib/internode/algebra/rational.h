// SPDX-License-Identifier: MIT
//
// Exact rationals. `0.25` is 1/4 everywhere in a grammar, a length, a weight: decimal text never passes through a
// double on its way in.

#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>

namespace internode {

using Integer = mpz_class;
using Rational = mpq_class;

/// Reads "3", "-3/2", "0.25", ".5", "1.5e-3": the whole text or nothing. Empty for anything else, for a zero
/// denominator, for a leading "+", a point without digits after it, more than max_digits digits and for an exponent
/// beyond ±max_exponent.
[[nodiscard]] std::optional<Rational> parse_rational(std::string_view text);

inline constexpr std::size_t max_digits = 1000;
inline constexpr int max_exponent = 400;

/// "3/2", "-7".
[[nodiscard]] std::string to_string(const Rational& value);

/// The nearest double, ties to even; ±infinity beyond the largest. Zero has no sign.
[[nodiscard]] double to_double(const Rational& value);

/// The exact value of a finite double. \throw std::invalid_argument otherwise
[[nodiscard]] Rational to_rational(double value);

} // namespace internode
