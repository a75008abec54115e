// SPDX-License-Identifier: MIT
//
// The parameter line of a curve in doubles: knots and Greville abscissae.
//
// Lengths a_i / ρ^s are taken from their exact values and summed in double-double, so that a knot is off by about one
// unit in the last place however many intervals lie before it. The domain starts at Knots::origin().

#pragma once

#include "internode/curve/curve.h"

#include <vector>

namespace internode {

/// t_0 … t_{N+d} of an open curve, t_d its origin; t_0 … t_N of a closed one, t_0 its origin, t_N a period later.
[[nodiscard]] std::vector<double> knot_positions(const Curve& curve);
[[nodiscard]] std::vector<double> knot_positions(const Knots& knots);

/// ξ_0 … ξ_{N-1}, ξ_k = (t_{k+1} + … + t_{k+d}) / d; of a closed curve ascending, past the period where need be.
[[nodiscard]] std::vector<double> greville_abscissae(const Curve& curve);

/// The length of the interval of a symbol at the curve's step; 0 for `0`.
[[nodiscard]] double interval_length(const Curve& curve, Symbol symbol);

/// The longest interval of the domain at the curve's step.
[[nodiscard]] double largest_interval(const Curve& curve);

} // namespace internode
