// SPDX-License-Identifier: MIT
//
// Points of the curve itself on their way out, with or without what its derivatives say.

#pragma once

#include "internode/curve/homogeneous.h"
#include "internode/curve/refinement.h"
#include "internode/io/file/sink.h"

#include <string>
#include <vector>

namespace internode::cli {

/// --limit in CSV and NPY: the parameter in front of each point; `names` of the coordinates.
/// Homogeneous points are divided by their weights, which are left out.
/// `threads` make text, here and below.
void write_limit(Sink& sink, const std::string& format, const Refinement& refinement, Coordinates coordinates,
                 const std::vector<std::string>& names, int threads);

/// --limit in OBJ: the points alone, behind `before` vertices that stand in the file already; how many it wrote.
std::size_t write_limit_obj(Sink& sink, const Refinement& refinement, Coordinates coordinates, std::size_t before,
                            int threads);

/// --limit --derivatives of the given curve at the knots of its refinement, in CSV and NPY: t, x …, dx …, ddx …, tx …
/// (unit tangent), curvature. Where the curve has no tangent the last ones are empty in CSV and NaN in NPY. \throw
/// Failure (Refused) for what doubles cannot hold
void write_limit_frames(Sink& sink, const std::string& format, const Curve& given, const Refinement& refinement,
                        const std::vector<std::string>& names, int threads);

} // namespace internode::cli
