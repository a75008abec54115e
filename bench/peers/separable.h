// SPDX-License-Identifier: MIT
//
// A grid of points in space by two plain loops over masks computed beforehand: rows along v, then columns along u.

#pragma once

#include "bench/peers/oslo.h"

namespace internode::bench {

/// `points`: coarse rows of coarse columns; `between`: coarse rows of fine columns; `out`: fine rows of fine columns.
void refine_separable(const CubicRows& u, const CubicRows& v, std::span<const double> points, std::span<double> between,
                      std::span<double> out);

} // namespace internode::bench
