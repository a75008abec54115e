// SPDX-License-Identifier: MIT
//
// A rational from two integers. Every Rational is in lowest terms: this is what makes it so, and what asserts it.

#pragma once

#include "internode/algebra/rational.h"

namespace internode {

/// numerator / denominator in lowest terms; denominator != 0. The only way from two integers to a Rational: the
/// constructor of mpq_class keeps 15/100 as it is, and comparisons are wrong then.
[[nodiscard]] Rational fraction(const Integer& numerator, const Integer& denominator);

/// Whether numerator and denominator have no common divisor and the denominator is positive: what every function
/// takes for granted. Cost: a greatest common divisor.
[[nodiscard]] bool is_canonical(const Rational& value);

} // namespace internode
