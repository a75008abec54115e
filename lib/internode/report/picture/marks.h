// SPDX-License-Identifier: MIT
//
// Dots, titles and captions as all pictures draw them.

#pragma once

#include "internode/report/picture/svg.h"

#include <span>
#include <string>
#include <string_view>

namespace internode {

/// Dots of a diameter in pixels, as one path of lines without length and with round ends.
[[nodiscard]] std::string dots(std::span<const Point2> pixels, std::string_view colour, double diameter);

/// The title of a picture, plain text, centred at a pixel.
[[nodiscard]] std::string title_text(std::string_view title, Point2 at);

/// A small line of plain text, centred at a pixel.
[[nodiscard]] std::string caption(std::string_view text, Point2 at);

} // namespace internode
