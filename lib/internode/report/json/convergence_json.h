// SPDX-License-Identifier: MIT
//
// A convergence measurement as JSON: format "internode-convergence", docs/schema/convergence.schema.json.

#pragma once

#include "internode/curve/convergence.h"
#include "internode/report/generator.h"

#include <string>

namespace internode {

/// `system` is the one whose curve was measured: its field holds the exact numbers.
[[nodiscard]] std::string convergence_json(const Convergence& convergence, const IntervalSystem& system,
                                           const Generator& generator);

} // namespace internode
