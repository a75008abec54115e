// SPDX-License-Identifier: MIT
//
// Masks and window stencils for a person at a terminal: weights like `2φ−3 ≈ 0.2361`, the ratio named and defined in
// the first lines, persistent words marked.

#pragma once

#include "internode/report/mask_table.h"

#include <string>

namespace internode {

[[nodiscard]] std::string masks_text(const MaskTable& table);

} // namespace internode
