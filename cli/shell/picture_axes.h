// SPDX-License-Identifier: MIT
//
// --axes: which two coordinates of the points a picture shows.

#pragma once

#include "internode/report/picture/planar_curve.h"

#include <cstddef>
#include <string>

namespace internode::cli {

/// "1,3" as two different coordinates counted from 0; the first two for an empty text. \throw Failure (Usage)
[[nodiscard]] PictureAxes chosen_axes(const std::string& text, std::size_t dimension);

} // namespace internode::cli
