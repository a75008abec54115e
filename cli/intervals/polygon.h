// SPDX-License-Identifier: MIT
//
// The polygons of a file, and the curves that they are under a system (input/settled_curve.h).

#pragma once

#include "cli/requests/options.h"
#include "internode/input/plain_polygon.h"
#include "internode/input/settled_curve.h"

#include <vector>

namespace internode::cli {

/// The only polygon of a file, or that of --element, with the weights that --rational finds. \throw Failure: File,
/// Refused
[[nodiscard]] InputPolygon load_polygon(const PolygonOptions& options);

/// All polygons of a file, or that of --element, with the weights that --rational finds. \throw Failure: File, Refused
[[nodiscard]] std::vector<InputPolygon> load_polygons(const PolygonOptions& options);

/// \throw Failure (Refused) for a closed polygon whose last point is the first again
void refuse_repeated_point(const InputPolygon& polygon);

/// What the command line says of a polygon.
[[nodiscard]] CurveOptions curve_options(const PolygonOptions& options);

/// A curve for each polygon of the file. \throw Failure: File, Refused with what does not fit, Usage for a degree that
/// is missing
[[nodiscard]] std::vector<SettledCurve> load_curves(const IntervalSystem& system, const PolygonOptions& options);

/// The only one, for commands whose mathematics knows no weights. \throw Failure: Refused for points with weights
[[nodiscard]] SettledCurve load_polynomial_curve(const IntervalSystem& system, const PolygonOptions& options);

} // namespace internode::cli
