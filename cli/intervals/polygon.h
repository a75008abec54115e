// SPDX-License-Identifier: MIT
//
// A control polygon, its word and its ends, as the file and the command line say them together.
//
// Knots in the file say the word and its lengths (curve/knot_vector.h), and leave nothing to say on the command line.
// The word: --word over the JSON's over the axiom; the last two must agree when both speak. Ends: an option, or the
// JSON's `closed`, or the word's own form, or open. --repeat repeats the letters and cuts at the N or N + d needed.

#pragma once

#include "cli/arguments/options.h"
#include "internode/curve/curve.h"
#include "internode/curve/homogeneous.h"
#include "internode/io/polygon.h"

#include <string>
#include <vector>

namespace internode::cli {

struct LoadedCurve {
    Curve curve;
    std::vector<std::string> columns; ///< names of the coordinates, when the file gives them
    std::string source;               ///< for titles: the base name of the file
    Coordinates coordinates = Coordinates::Cartesian;

    /// Coordinates of a point in space.
    [[nodiscard]] std::size_t space_dimension() const {
        return curve.dimension() - (coordinates == Coordinates::Homogeneous ? 1 : 0);
    }
};

/// The polygon of a file alone, with the weights that --rational finds in it. \throw Failure: File, Refused
[[nodiscard]] InputPolygon load_polygon(const PolygonOptions& options);

/// \throw Failure (Refused) for a closed polygon whose last point is the first again
void refuse_repeated_point(const InputPolygon& polygon);

/// The file's name without its folder.
[[nodiscard]] std::string base_name(const std::string& source);

/// Points with weights become homogeneous. \throw Failure: File, Refused with what does not fit, Usage for a degree
/// that is missing
[[nodiscard]] LoadedCurve load_curve(const IntervalSystem& system, const PolygonOptions& options);

/// The same for commands whose mathematics knows no weights. \throw Failure: Refused for points with weights
[[nodiscard]] LoadedCurve load_polynomial_curve(const IntervalSystem& system, const PolygonOptions& options);

} // namespace internode::cli
