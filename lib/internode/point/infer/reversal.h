// SPDX-License-Identifier: MIT
//
// A closed polygon taken apart by a local reverse rule, level by level: c = A f. The residual f - P c tells how far the
// scheme's own polygon is from the one that was there (Prusinkiewicz et al. 2003, section 7 and Fig. 9).
//
// Coarse point j is made of the fine points round phase + m j … phase + m j + m - 1. Each of the m phases is another
// partition of the ring; a polygon that the scheme made comes back, without residual, in one of them.

#pragma once

#include "internode/mask/uniform_mask.h"
#include "internode/point/infer/reverse_rules.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace internode {

struct ReversedLevel {
    std::vector<double> points; ///< the coarse polygon, rows of coordinates
    double largest_error = 0;   ///< the largest Euclidean length in f - P c, over the fine points
    double rms_error = 0;       ///< the root of the mean of the squares of these lengths
};

struct ReversalOptions {
    std::size_t dimension = 2;
    std::uint64_t levels = 1;
    std::uint64_t phase = 0; ///< the phase of every level, counted round the ring
};

/// The levels from the finest coarse polygon down. Sums run in the order of the window. Cost: linear.
/// \throw std::invalid_argument for a number of points that the arity does not divide in some level, rows that are not
/// whole, a rule of another arity
[[nodiscard]] std::vector<ReversedLevel> reversed(const UniformMask& mask, const ReverseRule& rule,
                                                  std::span<const double> points, const ReversalOptions& options);

/// m^levels, none beyond 2^62: numbers of points that can go so many levels down are its multiples.
[[nodiscard]] std::optional<std::uint64_t> points_per_coarse_point(std::size_t arity, std::uint64_t levels);

/// Numbers of points round a measured one that can go so many levels down; 0 where there is none.
struct RingSizes {
    std::uint64_t measured = 0;
    std::uint64_t below = 0; ///< the largest that is not above `measured`
    std::uint64_t above = 0; ///< the smallest that is larger
    [[nodiscard]] bool exact() const { return below == measured; }
    /// The nearer one, the smaller of two; 0 when there is none.
    [[nodiscard]] std::uint64_t nearest() const;
};
[[nodiscard]] RingSizes ring_sizes(std::uint64_t measured, std::size_t arity, std::uint64_t levels);

} // namespace internode
