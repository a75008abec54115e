// SPDX-License-Identifier: MIT
//
// What the symbol a(z) = Σ a_k z^k of a uniform scheme of arity m says about it, exactly.
//
// With s(z) = 1 + z + … + z^{m-1}: polynomials of degree d are generated (sequences of degree d give sequences of
// degree d) iff s(z)^{d+1} divides a(z). With τ = a'(1)/m, samples π(j) of polynomials of degree d give the samples
// π((k - τ)/m) iff, besides, a^{(k)}(1) = m τ(τ-1)…(τ-k+1) for k <= d (Conti and Hormann 2011, for every arity).
// The limit of the unit impulse lives on [first/(m-1), last/(m-1)].

#pragma once

#include "internode/mask/uniform_mask.h"

#include <optional>
#include <string>
#include <vector>

namespace internode {

/// Where the axis of symmetry lies.
enum class MaskSymmetry {
    None,
    Odd, ///< The axis lies on a coefficient: an odd number of them, a primal scheme.
    Even ///< The axis lies between two: an even number, a dual scheme.
};

struct MaskProperties {
    std::string symbol;             ///< "1/4 z^-1 (1 + z)^3"
    std::size_t factor_power = 0;   ///< L, the largest with s(z)^L | a(z)
    std::vector<Rational> quotient; ///< a(z) / (z^first s(z)^L), low degree first
    std::vector<Rational> sums;     ///< sums of the m residue classes of k, the class of k = 0 first
    bool sums_are_one = false;      ///< all of them, which convergence needs
    std::optional<std::size_t> generation_degree;
    std::optional<std::size_t> reproduction_degree; ///< none when not even constants are
    Rational shift;                                 ///< τ
    bool interpolatory = false;                     ///< one residue class is a single 1: every old point stays
    MaskSymmetry symmetry = MaskSymmetry::None;
    Rational support_first; ///< where the limit of the unit impulse begins
    Rational support_last;
};

/// \throw std::invalid_argument for a mask of arity below 2 or without coefficients. Cost: quadratic in the mask.
[[nodiscard]] MaskProperties mask_properties(const UniformMask& mask);

/// coefficients / s(z), low degree first, when it divides them; none otherwise.
[[nodiscard]] std::optional<std::vector<Rational>> divide_by_factor(const std::vector<Rational>& coefficients,
                                                                    std::size_t arity);

} // namespace internode
