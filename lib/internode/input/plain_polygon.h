// SPDX-License-Identifier: MIT
//
// What can be settled of a polygon before any grammar: its weights, and whether a closed one is closed twice.

#pragma once

#include "internode/input/refusal.h"
#include "internode/io/polygon.h"

namespace internode {

/// The last coordinate of each point becomes its weight. Refused: weights of the file's own, points of one number,
/// weights outside of the bounds of curve/homogeneous.h.
[[nodiscard]] Settled<InputPolygon> with_weights(InputPolygon polygon);

/// What to say of a closed polygon whose last point is the first again; no errors when it is not.
[[nodiscard]] Refusal repeated_point(const InputPolygon& polygon);

/// The file's name without its folder.
[[nodiscard]] std::string base_name(const std::string& source);

} // namespace internode
