// SPDX-License-Identifier: MIT
//
// Does a uniform scheme converge, and how smooth are its limits? Proved bounds.
//
// With s(z) = 1 + … + z^{m-1} and a(z) = s(z)^l m^{1-l} b_l(z), b_l is the scheme of the l-th differences, scaled as
// derivatives of order l - 1. The scheme converges iff b_1 contracts; limits have l - 1 continuous derivatives when b_l
// contracts (Dyn 1992). With the joint spectral radius ϱ_l of b_l they are of Hölder class l - 1 - log_m ϱ_l, up to any
// ε > 0, for every l. For the largest l there is no smoother, when the integer translates of the limit are stable, as
// they are for interpolatory schemes and B-splines (Daubechies and Lagarias 1992; Rioul 1992).

#pragma once

#include "internode/mask/joint_radius.h"
#include "internode/mask/uniform_mask.h"

#include <optional>
#include <string>
#include <vector>

namespace internode {

enum class SchemeConvergence { Proved, Refuted, NotDecided };

struct DifferenceScheme {
    std::size_t order = 1;              ///< the order l of the differences
    std::vector<Rational> coefficients; ///< the coefficients of b_l, low degree first
    JointRadius radius;
};

struct Smoothness {
    SchemeConvergence convergence = SchemeConvergence::NotDecided;
    std::string reason; ///< "the sums of the mask are not 1", "‖S²‖ = 3/4 < 1 for the first differences"
    std::vector<DifferenceScheme> differences; ///< orders 1 … L
    std::optional<std::size_t> derivatives;    ///< proved to be continuous; none when convergence is not proved
    std::optional<double> holder_lower;        ///< proved: limits are of every Hölder class below it
    std::optional<double> holder_upper;        ///< some limit is of no Hölder class above it
    bool upper_is_proved = false;              ///< otherwise it rests on stable integer translates
};

inline constexpr std::size_t max_smoothness_coefficients = 64;
inline constexpr std::size_t max_smoothness_arity = 8;

/// None for longer masks and larger arities than that. \throw std::invalid_argument as mask_properties
/// Cost: bounded, about a second for the longest masks.
[[nodiscard]] std::optional<Smoothness> smoothness(const UniformMask& mask);

} // namespace internode
