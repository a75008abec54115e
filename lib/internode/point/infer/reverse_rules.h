// SPDX-License-Identifier: MIT
//
// Local reverse rules (Bartels and Samavati 2000; Prusinkiewicz et al. 2003, section 7): coarse points from fine ones,
//
//     c_j = Σ_k b_{k-mj} f_k,   exact for fine points that a scheme of arity m made:   A P = I,
//
// where P is the scheme's matrix, p'_k = Σ_j a_{k-mj} p_j. The window of fine points that a coarse one is made of is
// centred on those that depend on it, a_first … a_last, so that neither side weighs more for a symmetric scheme. It is
// the narrowest such window in which an exact solution exists. Of several solutions the one of least norm is taken. S0
// eq. 38 is this for Chaikin. (Two points alone, 3/2 and -1/2, are exact too: an extrapolation from one side.)

#pragma once

#include "internode/mask/uniform_mask.h"
#include "internode/point/infer/production.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace internode {

struct ReverseRule {
    std::size_t arity = 2;         ///< m fine points become one coarse point
    std::ptrdiff_t first = 0;      ///< k of weights[0]; fine points 0 … m-1 are those that replaced the coarse one
    std::vector<Rational> weights; ///< b_first …, the whole window; sum 1 where the scheme is affine
};

/// The rule of the narrowest window, or of one with `wider` more fine points on each side (up to
/// max_reverse_window in all), which amplifies noise less.
/// None when no window up to max_reverse_window has a solution: new points that cannot tell their old ones.
/// Cost: cubic in the window. \throw std::invalid_argument for arity 0, a mask without coefficients
[[nodiscard]] std::optional<ReverseRule> reverse_rule(const UniformMask& mask, std::size_t wider = 0);

/// Fine points of a window: a wider one is not looked for.
inline constexpr std::size_t max_reverse_window = 64;

/// The rule of the narrowest window of at least `fine_points`, at most max_reverse_window. None as reverse_rule().
[[nodiscard]] std::optional<ReverseRule> reverse_rule_of_window(const UniformMask& mask, std::uint64_t fine_points);

/// Σ |b_k|: by so much an error of the fine points can grow in a coarse one, at most.
[[nodiscard]] Rational gain(const ReverseRule& rule);

/// The pseudo-L-system production: m strict predecessors and their contexts become one point.
[[nodiscard]] PointProduction production_of(const ReverseRule& rule);

/// The grammar of a closed curve with this one production.
[[nodiscard]] PointGrammar reverse_grammar(std::string name, const ReverseRule& rule);

} // namespace internode
