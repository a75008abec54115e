// SPDX-License-Identifier: MIT
//
// The loops of blossom_rows(), included by one source per instruction set. Everything here is in an unnamed namespace
// and uses nothing of the standard library that the linker could share with code compiled for another instruction set.

#pragma once

#include "internode/stencil/blossom_rows.h"
#include "internode/stencil/kernel.h"

#include <cstring>

namespace internode {

/// What the loops read of a piece.
struct PieceView {
    std::size_t degree;
    const double* knots_hi;
    const double* knots_lo;
    const double* reciprocals_hi;
    const double* reciprocals_lo;
};

/// Only where the build has AVX2: INTERNODE_HAS_AVX2.
[[nodiscard]] double blossom_rows_avx2(const PieceView& piece, const double* hi, const double* lo, std::size_t rows,
                                       double* weights);

namespace {

/// The same number in every lane.
template<typename Real>
inline PairOf<Real> in_every_lane(double hi, double lo) {
    return {hi - Real{}, lo - Real{}};
}

/// Numbers from one place on, one a lane.
template<typename Real>
inline PairOf<Real> load_lanes(const double* hi, const double* lo) {
    PairOf<Real> result;
    std::memcpy(&result.hi, hi, sizeof(Real));
    std::memcpy(&result.lo, lo, sizeof(Real));
    return result;
}

/// The row of each lane; `sums` become the largest of the sums of each level.
template<typename Real>
inline void blossom_row(const PieceView& piece, const double* hi, const double* lo, PairOf<Real>* row, Real& sums) {
    const std::size_t d = piece.degree;
    row[0] = in_every_lane<Real>(1, 0);
    for (std::size_t i = 1; i <= d; ++i) row[i] = {};
    for (std::size_t level = d; level >= 1; --level) {
        // Level l has d - l + 1 reciprocals.
        const std::size_t first = (level - 1) * (d + 1) - (level - 1) * level / 2;
        const auto x = load_lanes<Real>(hi + level - 1, lo + level - 1);
        // In place, from the right: entry i gives to i and i + 1.
        for (std::size_t i = d - level + 1; i-- > 0;) {
            const std::size_t knot = i + level - 1;
            const auto distance = x - in_every_lane<Real>(piece.knots_hi[knot], piece.knots_lo[knot]);
            const PairOf<Real> share =
                distance * in_every_lane<Real>(piece.reciprocals_hi[first + i], piece.reciprocals_lo[first + i]);
            const PairOf<Real> given = row[i] * share;
            row[i + 1] = row[i + 1] + given;
            row[i] = row[i] - given;
        }
        Real sum{};
        for (std::size_t i = 0; i <= d; ++i) sum += row[i].hi < 0 ? -row[i].hi : row[i].hi;
        sums = sum <= sums ? sums : sum;
    }
}

template<typename Real>
inline double blossom_rows_by_lanes(const PieceView& piece, const double* hi, const double* lo, std::size_t rows,
                                    double* weights) {
    constexpr std::size_t lanes = sizeof(Real) / sizeof(double);
    constexpr double smallest_weight = 0x1p-80; // one below it cannot be seen in a sum of d+1 products
    const std::size_t width = piece.degree + 1;
    double largest = 0;
    for (std::size_t first = 0; first < rows; first += lanes) {
        PairOf<Real> row[max_row_width];
        Real sums{};
        blossom_row(piece, hi + first, lo + first, row, sums);
        for (std::size_t lane = 0; lane < lanes && first + lane < rows; ++lane) {
            if (largest == largest && !(sums[lane] <= largest)) largest = sums[lane]; // not-a-number stays
            for (std::size_t i = 0; i < width; ++i) {
                const double weight = row[i].hi[lane];
                *weights++ = weight < smallest_weight && weight > -smallest_weight ? 0 : weight;
            }
        }
    }
    return largest;
}

} // namespace
} // namespace internode
