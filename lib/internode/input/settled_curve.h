// SPDX-License-Identifier: MIT
//
// A control polygon, its word and its ends, as a file and a caller say them together, settled against a system.
//
// Knots in the file say the word and its lengths (curve/knot_vector.h), and leave nothing to the caller; beside a word
// of the file they must be its knots. The word: the caller's over the JSON's over the axiom; the last two must agree
// when both speak. Ends: the caller's, or the JSON's `closed`, or the word's own form, or open. The parameter begins at
// the file's origin, or its first knot, or 0.

#pragma once

#include "internode/curve/curve.h"
#include "internode/curve/homogeneous.h"
#include "internode/input/refusal.h"
#include "internode/io/polygon.h"

#include <optional>
#include <string>
#include <vector>

namespace internode {

/// How a caller says the ends of a polygon.
enum class EndsChoice { Unsaid, Open, Closed, Clamped };

/// What a caller says of a polygon, beside its file.
struct CurveOptions {
    std::optional<int> degree; ///< none: the file's
    std::string word;          ///< a word in the language of grammars; empty = the file's, or the axiom
    bool repeat = false;       ///< the letters are repeated, and cut at the N or N + d that the points need
    EndsChoice ends = EndsChoice::Unsaid;
    bool rational = false; ///< the last coordinate of each point is its weight
};

struct SettledCurve {
    Curve curve;
    std::vector<std::string> columns; ///< names of the coordinates, when the file gives them
    std::string source;               ///< the file's name without its folder
    Coordinates coordinates = Coordinates::Cartesian;
    std::string break_text{}; ///< the lines of a CSV that part the polygon from the one before

    /// Coordinates of a point in space.
    [[nodiscard]] std::size_t space_dimension() const {
        return curve.dimension() - (coordinates == Coordinates::Homogeneous ? 1 : 0);
    }
};

/// Points with weights become homogeneous. Cost: that of make_curve(), and with knots of fit_knots().
[[nodiscard]] Settled<SettledCurve> settle_curve(const IntervalSystem& system, InputPolygon polygon,
                                                 const CurveOptions& options);

/// The refusal of a polygon that is one of several: each error without a place is at the polygon's first line.
[[nodiscard]] Refusal placed(Refusal refusal, const InputPolygon& polygon);

} // namespace internode
