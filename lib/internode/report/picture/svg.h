// SPDX-License-Identifier: MIT
//
// The few words of SVG that the pictures are written in, with numbers that are the same bytes everywhere.
//
// Coordinates are pixels, x to the right and y down. Logarithms and angles are computed here in plain IEEE arithmetic:
// libm differs between machines in the last place, and a picture must not.

#pragma once

#include "internode/report/generator.h"

#include <string>
#include <string_view>
#include <vector>

namespace internode {

struct Point2 {
    double x = 0;
    double y = 0;
};

/// Fixed decimals, rounded, without trailing zeros and without "-0".
void append_fixed(std::string& text, double value, int decimals = 2);
[[nodiscard]] std::string fixed(double value, int decimals = 2);

/// ` name="value"`, value in fixed decimals.
[[nodiscard]] std::string attribute(std::string_view name, double value);

/// "x y" of a path.
void append_point(std::string& path, Point2 point, int decimals = 2);

/// Whether a picture is a file of its own or a part of a page, which brings fonts and ground.
enum class SvgPlace { File, Page };

struct SvgHead {
    double width = 0;
    double height = 0;
    std::string title;       ///< plain text, for the <title>
    std::string description; ///< plain text, for the <desc>
    Generator generator;     ///< metadata of a file
};

/// The opening of the document, its title, description and metadata, and the white ground of a file.
[[nodiscard]] std::string svg_open(const SvgHead& head, SvgPlace place);

/// `count` points of the unit circle, the first at the top, clockwise on the screen.
[[nodiscard]] std::vector<Point2> points_on_circle(std::size_t count);

} // namespace internode
