// SPDX-License-Identifier: MIT
//
// Knots on their way into JSON: lengths and origin as exact numbers, the knots themselves rounded.

#pragma once

#include "internode/curve/knots.h"
#include "internode/io/json/curve_json.h"

#include <vector>

namespace internode::cli {

/// The lengths of the letters at the step of the knots, a_i / ρ^s: with them a file reads back as the same knots.
[[nodiscard]] std::vector<CurveLength> current_lengths(const Knots& knots);

/// Where their parameter begins.
[[nodiscard]] CurveOrigin exact_origin(const Knots& knots);

/// t_0 … t_{N+d}, or t_0 … t_N of closed knots; none of more than 250 000 knots.
[[nodiscard]] std::vector<double> written_knots(const Knots& knots);

} // namespace internode::cli
