// SPDX-License-Identifier: MIT
//
// The operations on one or two numbers, exactly and in doubles: one meaning for the reader, which folds literals, and
// for every evaluator. A truth is the number 1 or 0.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/expression/expression.h"

#include <cstddef>
#include <optional>

namespace internode {

/// The value of an operation that takes and gives numbers or truths: not Number, Formal, Constant, Call, Point or
/// Coordinate. None for a division by zero and for a root that is not rational. An operation of one number takes the
/// first.
[[nodiscard]] std::optional<Rational> apply_exactly(Operation operation, const Rational& first, const Rational& second);

/// The same in doubles, with infinities and NaN where they come.
[[nodiscard]] double apply_operation(Operation operation, double first, double second);

/// Bits of numerator and denominator together.
[[nodiscard]] std::size_t bit_size(const Rational& value);

} // namespace internode
