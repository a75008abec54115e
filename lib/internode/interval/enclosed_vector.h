// SPDX-License-Identifier: MIT
//
// Certified bounds on the positive vector a, M a = ρ a, of an n x n matrix too large for exact numbers.
//
// With M' = M without row and column k and m = column k without row k, a_k = x_k fixes the scale and
// a' = (ρI − M')^{-1} m x_k, where the inverse is >= 0 once ρ(M') < ρ. So for λ <= ρ, x near a and any w > 0 with
// g = (λI − M') w > 0, the vector x + δ w is an upper bound as soon as δ g >= M x − λ x. The lower bound likewise with
// λ >= ρ. The residuals and g are exact rationals; floating point only finds x and w. (M-matrices: Berman and Plemmons,
// ch. 6.)

#pragma once

#include "internode/algebra/perron.h"

#include <optional>
#include <vector>

namespace internode {

struct RationalBounds {
    Rational lower; ///< > 0
    Rational upper;
};

/// For a matrix whose graph has one final class, the only basic one, that every node leads to; `final` = its nodes.
/// The smallest entry of x becomes 1. Empty when the iterations do not come close enough.
[[nodiscard]] std::optional<std::vector<RationalBounds>> enclose_vector(const SparseMatrix& matrix,
                                                                        const std::vector<std::uint32_t>& final);

/// Divides by entry `unit` and multiplies by `value`, which that entry becomes.
void rescale(std::vector<RationalBounds>& bounds, std::size_t unit, const Rational& value);

[[nodiscard]] Enclosure to_enclosure(const RationalBounds& bounds);

} // namespace internode
