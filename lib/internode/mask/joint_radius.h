// SPDX-License-Identifier: MIT
//
// Proved bounds on how fast a difference scheme b grows or shrinks: d'_k = Σ_j b_{k-mj} d_j.
//
// S^k has the mask b(z) b(z^m) … b(z^{m^{k-1}}), and its norm is the largest sum of |coefficients| in a residue class
// modulo m^k. The joint spectral radius ϱ of the m matrices of b is lim ‖S^k‖^{1/k} = inf ‖S^k‖^{1/k}. Every product of
// k of these matrices has a spectral radius of at most ϱ^k (Daubechies and Lagarias 1992). So norms bound it from above
// and spectral radii from below, all of it in rationals.
//
// Let b be symmetric about a coefficient and its Fourier transform nowhere negative. Then no coefficient of S^k is
// larger than the one at the centre, and ϱ is the spectral radius of the one matrix (b_{j-mi}) around the centre.

#pragma once

#include "internode/algebra/rational.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace internode {

struct JointRadius {
    Rational lower; ///< lower <= ϱ <= upper; equal when ϱ is known exactly
    Rational upper;
    std::size_t steps = 0; ///< k of the smallest ‖S^k‖^{1/k} that was found
    Rational norm;         ///< ‖S^k‖, exactly
    /// The first k with ‖S^k‖ < 1, which proves that the scheme contracts; none was found up to the limit.
    std::optional<std::size_t> contracts_after;
    Rational contraction;  ///< that norm
    bool positive = false; ///< the Fourier transform is nowhere negative: both bounds are one spectral radius
};

/// Norms alone are cheap and leave `lower` at 0; spectral radii cost some characteristic polynomials.
enum class RadiusBounds { Norms, NormsAndSpectra };

/// Bounds for coefficients b_0 …, b_n of a scheme of arity m >= 2, at least one of them; of more than 128 bits, by
/// norms alone. Cost: bounded, about 0.1 s.
[[nodiscard]] JointRadius joint_radius(const std::vector<Rational>& coefficients, std::size_t arity,
                                       RadiusBounds bounds = RadiusBounds::NormsAndSpectra);

} // namespace internode
