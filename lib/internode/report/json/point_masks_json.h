// SPDX-License-Identifier: MIT
//
// The masks of a point grammar and the automaton that says them for all polygons, as JSON (docs/json.md).

#pragma once

#include "internode/report/point_masks.h"

#include <string>

namespace internode {

/// "internode-point-masks" version 1.
[[nodiscard]] std::string point_masks_json(const PointMasks& masks);

/// "internode-cells" version 1: states with offsets and children, exact rows, start states.
[[nodiscard]] std::string cells_json(const CellExport& cells);

} // namespace internode
