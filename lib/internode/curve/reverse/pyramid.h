// SPDX-License-Identifier: MIT
//
// A pyramid: a coarse polygon and the details of every step back to the fine one (Bartels and Samavati 2000;
// Prusinkiewicz et al. 2003, section 7; Nivoliers et al. 2012, 3.4).
//
// Analysis takes n steps backwards (curve/reverse/reverse_step.h), polygon n first; synthesis takes them forwards. A
// pyramid has exactly as many coarse points and detail vectors as the fine polygon has points. Leaving out short
// details compresses: what that costs is measured, not estimated.

#pragma once

#include "internode/curve/curve.h"
#include "internode/curve/reverse/details.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace internode {

/// The step from polygon `level` to polygon `level` + 1, level being the place in Pyramid::levels.
struct PyramidLevel {
    std::size_t points = 0;   ///< points of the finer polygon
    std::size_t inserted = 0; ///< how many of them stand for inserted knots: details at most
    Details details;          ///< those that were kept
};

struct Pyramid {
    Curve coarse;
    ReverseOptions options;           ///< the left inverse that the details belong to
    std::vector<PyramidLevel> levels; ///< the levels from coarse to fine
};

struct Analysis {
    Pyramid pyramid;
    std::vector<std::vector<double>> polygons; ///< the points of every level, 0 … n; the last is the fine polygon
    /// G of every level: the largest coordinate over that of the fine polygon, both from the middle of its box. Errors
    /// of a synthesis grow to about G times rounding.
    std::vector<double> gains;
};

/// Coordinates up to here take part: sums of squares stay finite.
inline constexpr double largest_coordinate = 1e150;

/// `levels` steps down from `fine`, rows of `dimension` coordinates: as many points as the refined knots ask for.
/// \throw std::invalid_argument for another number of points or a coordinate beyond largest_coordinate,
/// std::range_error when a coarse point is (only unclamped ends are conditioned so badly)
/// On two threads or more (0: all that there are) a step is prepared while the one before it is taken: the same bytes.
[[nodiscard]] Analysis analyse(const Knots& coarse, int levels, std::size_t dimension, std::span<const double> fine,
                               const ReverseOptions& options = {}, int threads = 1);

/// The polygons of all levels, 0 … n, from the coarse one and the details.
[[nodiscard]] std::vector<std::vector<double>> synthesise(const Pyramid& pyramid);

/// Only the details of at least this length.
[[nodiscard]] Pyramid thresholded(const Pyramid& pyramid, double least_length);

/// Only the `count` longest details; of equal ones those of the coarser level, then those that come first.
[[nodiscard]] Pyramid with_longest(const Pyramid& pyramid, std::size_t count);

/// How many details a pyramid holds.
[[nodiscard]] std::size_t detail_count(const Pyramid& pyramid);

/// The length of each vector.
[[nodiscard]] std::vector<double> lengths_of(const Details& details, std::size_t dimension);

struct PolygonError {
    double largest = 0;          ///< distance of a point from its counterpart
    double root_mean_square = 0; ///< root mean square of all these distances
};

/// Between two polygons of as many points. \throw std::invalid_argument
[[nodiscard]] PolygonError polygon_error(std::span<const double> a, std::span<const double> b, std::size_t dimension);

/// Whether the polygon is open and its ends are not clamped: the first and last points are then ill-conditioned by
/// nature, and G tells by how much.
[[nodiscard]] bool has_loose_ends(const Knots& knots);

struct CheckedPyramid {
    std::optional<Pyramid> pyramid;    ///< the pyramid, when everything fits
    std::vector<std::string> problems; ///< what does not fit, each a sentence with the numbers
};

/// Checks the sizes of levels against the knots of `coarse`, and details: ascending, at points that are there, finite.
/// Cost: linear in the details; nothing is refined.
[[nodiscard]] CheckedPyramid make_pyramid(Curve coarse, const ReverseOptions& options,
                                          std::vector<PyramidLevel> levels);

} // namespace internode
