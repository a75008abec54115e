// SPDX-License-Identifier: MIT
//
// The lengths of intervals on their way into JSON.

#pragma once

#include "internode/curve/knots.h"
#include "internode/io/json/curve_json.h"

#include <vector>

namespace internode::cli {

/// The lengths of the letters at the step of the knots, a_i / ρ^s: with them a file reads back as the same knots.
[[nodiscard]] std::vector<CurveLength> current_lengths(const Knots& knots);

} // namespace internode::cli
