// SPDX-License-Identifier: MIT
//
// The mask and the matrix of a point grammar, for a terminal.

#pragma once

#include "internode/report/point_masks.h"

#include <string>

namespace internode {

/// The mask, and the matrix row by row.
[[nodiscard]] std::string point_masks_text(const PointMasks& masks);

} // namespace internode
