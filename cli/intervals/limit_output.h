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

/// --limit: the parameter in front of each point in CSV and NPY, the points alone in OBJ; `names` of the coordinates.
/// Homogeneous points are divided by their weights, which are left out.
void write_limit(Sink& sink, const std::string& format, const Refinement& refinement, Coordinates coordinates,
                 const std::vector<std::string>& names);

/// --limit --derivatives, in CSV and NPY: t, x …, dx …, ddx …, tx … (unit tangent), curvature. Where the curve has no
/// tangent the last ones are empty in CSV and NaN in NPY. \throw Failure (Refused) for what doubles cannot hold
void write_limit_frames(Sink& sink, const std::string& format, const Refinement& refinement,
                        const std::vector<std::string>& names);

} // namespace internode::cli
