// SPDX-License-Identifier: MIT
//
// Arithmetic on numbers that do not depend on a word: exact as long as all operations are rational.
//
// A square root is exact where its argument is the square of a rational. Any other root, a division by zero and a
// result of more than max_known_bits bits (expression/limits.h) go on as doubles, with the same operations as the
// interpreter's. A truth is the number 1 or 0.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/expression/operation.h"

#include <optional>
#include <span>

namespace internode {

struct KnownNumber {
    std::optional<Rational> exact;
    double value = 0; ///< where exact is empty; may be infinite or NaN
};

/// The nearest double.
[[nodiscard]] double nearest(const KnownNumber& number);

/// The value of an operation that takes and gives numbers or truths: not Number, Formal, Constant, Call, Point or
/// Coordinate. `arguments`: one or two.
[[nodiscard]] KnownNumber apply_operation(Operation operation, std::span<const KnownNumber> arguments);

} // namespace internode
