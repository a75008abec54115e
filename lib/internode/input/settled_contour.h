// SPDX-License-Identifier: MIT
//
// A polygon that is to be taken apart: file and caller say its degree, its ends, the word of the coarse polygon and the
// levels between. It may have to be resampled or cut to a number of points that is possible.
//
// Knots of the file are those of the fine polygon. They say its ends and, where nobody says the coarse word, that too:
// the word whose rewriting they are (input/coarse_word.h).

#pragma once

#include "internode/curve/knots.h"
#include "internode/curve/reverse/resampling.h"
#include "internode/input/settled_curve.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace internode {

/// What may be done to a polygon whose number of points is not possible.
enum class FitChoice { Refuse, Resample, Cut };

struct ContourOptions {
    CurveOptions curve;                  ///< its word is that of the coarse polygon
    std::optional<std::uint64_t> levels; ///< none: the fewest that fit the word
    FitChoice fit = FitChoice::Refuse;
    bool unclamped = false; ///< open ends stay as they are
    std::uint64_t max_points = 100'000'000;
};

/// Beyond, a coarse word of one letter would be rewritten for ever.
inline constexpr std::uint64_t max_contour_levels = 100'000;

struct SettledContour {
    Knots coarse; ///< the knots of the coarse polygon
    int levels = 0;
    std::size_t dimension = 2;
    std::vector<double> points; ///< the fine points, as many as the knots ask for after the levels
    Fitting fitting;
    std::vector<std::string> columns; ///< names of the coordinates, when the file gives them
    std::string source;               ///< the file's name without its folder
};

/// Cost: linear in the points, and that of making knots.
[[nodiscard]] Settled<SettledContour> settle_contour(const IntervalSystem& system, const InputPolygon& polygon,
                                                     const ContourOptions& options);

} // namespace internode
