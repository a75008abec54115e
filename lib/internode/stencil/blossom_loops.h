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

    /// Groups of rows that are computed side by side, for an operation waits for the one before it.
    static constexpr std::size_t groups = 2;
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

template<typename Real>
inline void store_lanes(const PairOf<Real>& value, double* hi, double* lo) {
    std::memcpy(hi, &value.hi, sizeof(Real));
    std::memcpy(lo, &value.lo, sizeof(Real));
}

/// 1/(u_{i+d} - u_{i+l-1}) for level l = 1 … d and i = 0 … d-l, one level behind the other.
class KnotReciprocals {
public:
    template<typename Real>
    void set(const PieceView& piece, Real) {
        constexpr std::size_t lanes = sizeof(Real) / sizeof(double);
        const std::size_t d = piece.degree;
        double knots_hi[2 * (max_row_width - 1) + lanes];
        double knots_lo[2 * (max_row_width - 1) + lanes];
        for (std::size_t i = 0; i < 2 * d + lanes; ++i) {
            knots_hi[i] = i < 2 * d ? piece.knots_hi[i] : 0;
            knots_lo[i] = i < 2 * d ? piece.knots_lo[i] : 0;
        }
        std::size_t count = 0;
        for (std::size_t level = 1; level <= d; ++level) {
            for (std::size_t i = 0; i + level <= d; i += lanes) {
                const auto distance = load_lanes<Real>(knots_hi + d + i, knots_lo + d + i) -
                                      load_lanes<Real>(knots_hi + level - 1 + i, knots_lo + level - 1 + i);
                store_lanes(distance, hi_ + count + i, lo_ + count + i);
            }
            count += d - level + 1;
        }
        for (std::size_t i = 0; i + 1 < lanes; ++i) {
            hi_[count + i] = 1;
            lo_[count + i] = 0;
        }
        for (std::size_t i = 0; i < count; i += lanes) {
            const auto quotient = in_every_lane<Real>(1, 0) / load_lanes<Real>(hi_ + i, lo_ + i);
            store_lanes(quotient, hi_ + i, lo_ + i);
        }
    }

    template<typename Real>
    [[nodiscard]] PairOf<Real> at(std::size_t i) const {
        return in_every_lane<Real>(hi_[i], lo_[i]);
    }

private:
    static constexpr std::size_t most = max_row_width * (max_row_width - 1) / 2 + 3;
    double hi_[most];
    double lo_[most];
};

/// The rows of each lane of each group; `sums` become the largest of the sums of each level.
template<typename Real>
inline void blossom_group_rows(const PieceView& piece, const KnotReciprocals& reciprocals, const double* hi,
                               const double* lo, PairOf<Real> (*rows)[PieceView::groups], Real* sums) {
    constexpr std::size_t lanes = sizeof(Real) / sizeof(double);
    const std::size_t d = piece.degree;
    for (std::size_t level = d; level >= 1; --level) {
        // Level l has d - l + 1 reciprocals.
        const std::size_t first = (level - 1) * (d + 1) - (level - 1) * level / 2;
        const std::size_t last = d - level;
        PairOf<Real> x[PieceView::groups];
        Real sum[PieceView::groups]{};
        for (std::size_t g = 0; g < PieceView::groups; ++g)
            x[g] = load_lanes<Real>(hi + level - 1 + g * lanes, lo + level - 1 + g * lanes);
        // In place, from the right: entry i gives to i and i + 1, which is empty where i is the last.
        for (std::size_t i = last + 1; i-- > 0;) {
            const std::size_t knot = i + level - 1;
            const auto start = in_every_lane<Real>(piece.knots_hi[knot], piece.knots_lo[knot]);
            const auto reciprocal = reciprocals.at<Real>(first + i);
            for (std::size_t g = 0; g < PieceView::groups; ++g) {
                const PairOf<Real> share = quick_sum(x[g], -start) * reciprocal;
                const PairOf<Real> present = level == d ? in_every_lane<Real>(1, 0) : rows[i][g];
                const PairOf<Real> given = level == d ? share : present * share;
                rows[i + 1][g] = i == last ? given : quick_sum(rows[i + 1][g], given);
                rows[i][g] = quick_sum(present, -given);
            }
        }
        for (std::size_t i = 0; i <= last + 1; ++i)
            for (std::size_t g = 0; g < PieceView::groups; ++g)
                sum[g] += rows[i][g].hi < 0 ? -rows[i][g].hi : rows[i][g].hi;
        for (std::size_t g = 0; g < PieceView::groups; ++g) sums[g] = sum[g] <= sums[g] ? sums[g] : sum[g];
    }
}

template<typename Real>
inline double blossom_rows_by_lanes(const PieceView& piece, const double* hi, const double* lo, std::size_t rows,
                                    double* weights) {
    constexpr std::size_t lanes = sizeof(Real) / sizeof(double);
    constexpr double smallest_weight = 0x1p-80; // one below it cannot be seen in a sum of d+1 products
    const std::size_t width = piece.degree + 1;
    KnotReciprocals reciprocals;
    reciprocals.set(piece, Real{});
    double largest = 0;
    PairOf<Real> group[max_row_width][PieceView::groups];
    for (std::size_t first = 0; first < rows; first += PieceView::groups * lanes) {
        Real sums[PieceView::groups]{};
        blossom_group_rows(piece, reciprocals, hi + first, lo + first, group, sums);
        for (std::size_t at = 0; at < PieceView::groups * lanes && first + at < rows; ++at) {
            const std::size_t g = at / lanes;
            const std::size_t lane = at % lanes;
            if (largest == largest && !(sums[g][lane] <= largest)) largest = sums[g][lane]; // not-a-number stays
            for (std::size_t i = 0; i < width; ++i) {
                const double weight = group[i][g].hi[lane];
                *weights++ = weight < smallest_weight && weight > -smallest_weight ? 0 : weight;
            }
        }
    }
    return largest;
}

} // namespace
} // namespace internode
