// SPDX-License-Identifier: MIT
//
// A pyramid as JSON, from which its fine polygon can be put together again.

#pragma once

#include "internode/report/generator.h"
#include "internode/report/pyramid_report.h"

#include <string>

namespace internode {

/// Format "internode-pyramid" of the kept details (docs/json.md).
[[nodiscard]] std::string pyramid_json(const PyramidReport& report, const Generator& generator);

} // namespace internode
