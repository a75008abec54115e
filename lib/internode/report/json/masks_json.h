// SPDX-License-Identifier: MIT
//
// Masks and window stencils as JSON: format "internode-masks", docs/schema/masks.schema.json.

#pragma once

#include "internode/report/generator.h"
#include "internode/report/mask_table.h"

#include <string>

namespace internode {

[[nodiscard]] std::string masks_json(const MaskTable& table, const Generator& generator);

/// "reachable", "persistent", "all" as JSON says it.
[[nodiscard]] std::string_view to_string(WordChoice choice);

} // namespace internode
