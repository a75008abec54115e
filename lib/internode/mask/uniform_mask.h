// SPDX-License-Identifier: MIT
//
// The mask of a uniform stationary scheme of arity m: p'_k = Σ_j a_{k-mj} p_j, a finitely supported, each of its m
// residue classes with sum 1. Its symbol is a(z) = Σ a_k z^k (Dyn and Levin 2002).

#pragma once

#include "internode/algebra/rational.h"

#include <cstddef>
#include <vector>

namespace internode {

struct UniformMask {
    std::size_t arity = 2;              ///< m >= 1
    std::ptrdiff_t first = 0;           ///< k of coefficients[0]
    std::vector<Rational> coefficients; ///< a_first …, first and last not zero
};

} // namespace internode
