// SPDX-License-Identifier: MIT
//
// The rows of several steps, many side by side: blossoms of one interval's piece in pairs of doubles.
//
// One source (blossom_loops.h), compiled for every machine and once more with AVX2 and without FMA. A lane does the
// operations that it would do alone, so the bytes do not depend on which one runs (docs/promises.md, P10).

#pragma once

#include "internode/algebra/double_double.h"
#include "internode/stencil/isa.h"

#include <cstddef>
#include <vector>

namespace internode {

/// Pairs of doubles, low and high parts apart so that lanes can be read from any place.
struct PairArray {
    std::vector<double> hi;
    std::vector<double> lo;

    void reserve(std::size_t size) {
        hi.reserve(size);
        lo.reserve(size);
    }
    void clear() {
        hi.clear();
        lo.clear();
    }
    void push_back(DoubleDouble value) {
        hi.push_back(value.hi);
        lo.push_back(value.lo);
    }
};

/// The blossom over one window, as spline/blossom.h has it in K.
struct BlossomPiece {
    std::size_t degree; ///< d, 1 … 12
    PairArray knots;    ///< 2d, ascending; the middle two differ
};

/// Arguments behind the last one that blossom_rows() may read.
inline constexpr std::size_t blossom_padding = 7;

/// The d+1 weights of the blossom at arguments r … r+d-1, for every row r of `rows`, width d+1 a row. `arguments` has
/// rows + d - 1 of them and blossom_padding more. Weights below 2^-80 are what is left of an exact 0, and are 0.
/// Returns the largest sum of the absolute values of an intermediate row.
[[nodiscard]] double blossom_rows(const BlossomPiece& piece, const PairArray& arguments, std::size_t rows,
                                  double* weights, Isa isa = Isa::Best);

} // namespace internode
