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
#include <string>

namespace internode {

/// Points of a refined curve in a picture: a hundred for each pixel across. Given points are drawn however many.
inline constexpr std::uint64_t max_drawn_points = 100'000;

struct DrawnSteps {
    std::uint64_t steps = 0;  ///< steps that are drawn
    std::uint64_t asked = 0;  ///< steps that were asked for, at least as many
    std::uint64_t points = 0; ///< points of the curve after the drawn steps
};

/// The most of `steps` steps after which the curve has at most max_drawn_points; 0 where it has more from the start.
[[nodiscard]] DrawnSteps drawn_steps(const Curve& curve, std::uint64_t steps);

/// One sentence for the picture; empty where all steps are drawn.
[[nodiscard]] std::string drawn_remark(const DrawnSteps& drawn);

/// An upper bound of what refining by the drawn steps and drawing the curve take, in bytes.
[[nodiscard]] std::uint64_t curve_picture_bytes(const Curve& curve, const DrawnSteps& drawn, Coordinates coordinates);

} // namespace internode
