// SPDX-License-Identifier: MIT
//
// The reversal of a polygon by a point grammar, as JSON.

#pragma once

#include "internode/report/reversal_report.h"

#include <string>

namespace internode {

/// "internode-reversal" version 1 (docs/json.md).
[[nodiscard]] std::string reversal_json(const ReversalReport& report);

} // namespace internode
