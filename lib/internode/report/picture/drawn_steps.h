// SPDX-License-Identifier: MIT
//
// How many steps of a refinement a picture shows, and the memory that it takes.
//
// Steps change the control polygon and leave the curve as it is. Where the polygon has more points than an eye can tell
// apart, the picture is drawn after fewer steps, and says so.

#pragma once

#include "internode/curve/homogeneous.h"
#include "internode/curve/refinement.h"

#include <cstdint>
#include <span>
#include <string>

namespace internode {

/// Points of refined curves in a picture: a hundred for each pixel across. Given points are drawn however many.
inline constexpr std::uint64_t max_drawn_points = 100'000;

struct DrawnSteps {
    std::uint64_t steps = 0;  ///< steps that are drawn
    std::uint64_t asked = 0;  ///< steps that were asked for, at least as many
    std::uint64_t points = 0; ///< points of the curves after the drawn steps
};

/// The most of `steps` steps after which all curves of a picture together have at most max_drawn_points; 0 where they
/// have more from the start.
[[nodiscard]] DrawnSteps drawn_steps(std::span<const Curve* const> curves, std::uint64_t steps);
/// The same of a single curve.
[[nodiscard]] DrawnSteps drawn_steps(const Curve& curve, std::uint64_t steps);

/// One sentence for the picture; empty where all steps are drawn.
[[nodiscard]] std::string drawn_remark(const DrawnSteps& drawn);

/// An upper bound of what refining a curve by the steps that are drawn and drawing it take, in bytes. Curves of one
/// picture are all kept until it is drawn: their bounds add up.
[[nodiscard]] std::uint64_t curve_picture_bytes(const Curve& curve, std::uint64_t steps, Coordinates coordinates);

} // namespace internode
