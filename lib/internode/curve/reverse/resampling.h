// SPDX-License-Identifier: MIT
//
// A measured polygon brought to another number of points.
//
// Resampling puts points at equal steps of chord length along the polygon (linear interpolation), from its first point
// on; an open polygon keeps both ends. Numbers on a line (dimension 1), and points that are all the same, have no chord
// length to speak of: there the steps are equal in the index. Cutting keeps the first points and drops the others.

#pragma once

#include "internode/word/symbol.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace internode {

enum class Spacing { ChordLength, Index };

struct ResampledPolygon {
    std::vector<double> points; ///< rows of the same dimension
    Spacing spacing = Spacing::ChordLength;
};

/// `count` >= 1 points. \throw std::invalid_argument for no point, no whole rows, count 0
[[nodiscard]] ResampledPolygon resampled(std::span<const double> points, std::size_t dimension, Ends ends,
                                         std::size_t count);

/// The first `count` points. \throw as resampled(), and for more points than there are
[[nodiscard]] std::vector<double> cut(std::span<const double> points, std::size_t dimension, std::size_t count);

enum class Fit { AsMeasured, Resampled, Cut };

/// What was done to a measured polygon: belongs into whatever is said about the result.
struct Fitting {
    Fit fit = Fit::AsMeasured;
    std::size_t measured = 0; ///< points before
    std::size_t points = 0;   ///< points after
    Spacing spacing = Spacing::ChordLength;
    bool clamped = false; ///< and the same curve with clamped ends took its place (curve/clamping.h)
};

struct FittedPolygon {
    std::vector<double> points; ///< rows of the same dimension
    Fitting fitting;
};

/// The polygon with `count` points, cut or resampled as `fit` says; as it is where it has so many already.
/// \throw as resampled() and cut()
[[nodiscard]] FittedPolygon fitted(std::span<const double> points, std::size_t dimension, Ends ends, Fit fit,
                                   std::size_t count);

/// "4821 points, resampled to 4816 at equal steps of chord length".
[[nodiscard]] std::string to_string(const Fitting& fitting);

} // namespace internode
