// SPDX-License-Identifier: MIT
//
// An open curve with clamped ends: the same curve over the same domain, its end knots inserted until they have
// multiplicity d+1 outside. It then begins and ends at its first and last control point.
//
// As many points as before: what lies outside the domain goes. Only the first and last d-1 points change; each is the
// blossom of the piece over an interval of the domain at the knots after it, exact rows (spline/blossom.h).

#pragma once

#include "internode/curve/curve.h"

namespace internode {

/// Knots with the same domain, origin too, and d zeros at each end, lengths those of step 0. \throw
/// std::invalid_argument when closed
[[nodiscard]] Knots clamped(const Knots& knots);

/// N rows of `dimension` coordinates over clamped(knots), from as many over `knots`: the same curve.
/// \throw std::invalid_argument when closed, or for another number of points
[[nodiscard]] std::vector<double> clamped_points(const Knots& knots, std::size_t dimension,
                                                 const std::vector<double>& points);

} // namespace internode
