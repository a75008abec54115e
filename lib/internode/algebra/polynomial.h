// SPDX-License-Identifier: MIT
//
// Integer polynomials c_0 + c_1 x + … + c_d x^d as coefficient lists, low degree first, c_d != 0: factors over Q, and
// boxes that provably hold the complex roots. The only room beside number.cpp that knows FLINT.
//
// Roots are isolated for squarefree polynomials only (isolation does not end on a double root): factor first.

#pragma once

#include "internode/algebra/rational.h"

#include <utility>
#include <vector>

namespace internode {

using Polynomial = std::vector<Integer>;

/// The irreducible factors over Q, primitive with positive leading coefficient, and their multiplicities; constants are
/// left out. \throw std::invalid_argument for the zero polynomial
[[nodiscard]] std::vector<std::pair<Polynomial, std::size_t>> factor(const Polynomial& polynomial);

/// det(xI - M) of a dense square matrix, row by row. Cost: cubic and more; 0.003 s for 64 rows, seconds for 300.
[[nodiscard]] Polynomial characteristic_polynomial(const std::vector<std::vector<Integer>>& matrix);

/// The product.
[[nodiscard]] Polynomial multiply(const Polynomial& a, const Polynomial& b);

/// Where one root lies.
struct RootBox {
    bool real = false; ///< the root is real, which is certain; if not, it is certainly not
    Rational lower;    ///< lower <= real part <= upper
    Rational upper;
    Rational modulus_lower; ///< modulus_lower <= |root| <= modulus_upper
    Rational modulus_upper;
};

/// All d roots of a squarefree polynomial, real ones first and ascending, each with about `bits` correct bits. Boxes
/// of real roots do not overlap. \throw std::invalid_argument for a polynomial that is zero or not squarefree
[[nodiscard]] std::vector<RootBox> roots(const Polynomial& polynomial, int bits);

} // namespace internode
