// SPDX-License-Identifier: MIT
//
// Panels of one size in rows, in reading order, each with a label below it; above them the title of the picture.
//
// All panels show the plane in one frame. Panels that cut off what leaves them lie over a polygon that they share.

#pragma once

#include "internode/report/picture/frame.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace internode {

/// Pixels between panels, and round all of them.
inline constexpr double panel_margin = 14;
/// Pixels below a panel, for its label.
inline constexpr double panel_label_height = 22;
/// Height over width of a panel that shows numbers over their places.
inline constexpr double graph_shape = 0.45;
/// The colour of what a panel shows.
inline constexpr std::string_view panel_colour = "#cc3311";

struct PanelGrid {
    std::size_t columns = 1;
    Point2 size; ///< width and height of a panel without its label, in pixels
    Frame frame; ///< the way from the plane into a panel

    /// The upper left corner of the panel at this place in reading order.
    [[nodiscard]] Point2 corner(std::size_t place) const;
    /// Where the last row of so many panels ends, label and margin included.
    [[nodiscard]] double bottom(std::size_t panels) const;
    /// Where a point stands, from the corner of its panel. What is far away is drawn just outside.
    [[nodiscard]] Point2 pixel(Point2 point) const;
    /// The pixels of several points.
    [[nodiscard]] std::vector<Point2> pixels(std::span<const Point2> points) const;
    /// Path data of a polygon, from the corner of its panel.
    [[nodiscard]] std::string path(std::span<const Point2> polygon, bool closed) const;
};

/// The width of a panel where so many stand side by side.
[[nodiscard]] double panel_width(std::size_t columns);

/// The height of a panel that is as wide and shows a box of this size: of the box's shape, neither flat nor tall.
[[nodiscard]] double panel_height(double width, Point2 box, bool is_graph);

/// A grid whose panels show the box in their middle.
[[nodiscard]] PanelGrid panel_grid(std::size_t columns, double height, const PlaneBox& box, Point2 scale);

/// The definition of the grey polygon that lies under all panels, to be used by its id.
[[nodiscard]] std::string shared_polygon(std::string_view id, const std::string& path);

/// A polygon in red, its vertices marked where they are at most so many.
[[nodiscard]] std::string marked_polygon(const PanelGrid& grid, std::span<const Point2> polygon, bool closed,
                                         std::size_t most_marks);

/// The panel at a place: the shared polygon of this id, `content` over it, both cut at its border; the label below.
[[nodiscard]] std::string cut_panel(const PanelGrid& grid, std::size_t place, std::string_view shared,
                                    const std::string& content, const std::string& label);

} // namespace internode
