// SPDX-License-Identifier: MIT

#include "internode/report/picture/panels.h"

#include "internode/report/picture/marks.h"
#include "internode/report/picture/polygon_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

constexpr double title_height = 44;
constexpr double flattest_shape = 0.1; // height over width
constexpr double tallest_shape = 1.6;
constexpr double vertex_diameter = 3.2;

} // namespace

Point2 PanelGrid::corner(std::size_t place) const {
    assert(columns > 0);
    const std::size_t panels_above = place / columns;
    const auto column = static_cast<double>(place % columns);
    const auto row = static_cast<double>(panels_above);
    return {.x = panel_margin + column * (size.x + panel_margin),
            .y = title_height + row * (size.y + panel_label_height + panel_margin)};
}

double PanelGrid::bottom(std::size_t panels) const {
    assert(panels > 0);
    const std::size_t rows = (panels + columns - 1) / columns;
    return corner(rows * columns).y;
}

Point2 PanelGrid::pixel(Point2 point) const {
    const Point2 exact = frame.pixel(point);
    return {.x = std::clamp(exact.x, -size.x, 2 * size.x), .y = std::clamp(exact.y, -size.y, 2 * size.y)};
}

std::vector<Point2> PanelGrid::pixels(std::span<const Point2> points) const {
    std::vector<Point2> made;
    made.reserve(points.size());
    for (const Point2& point : points) made.push_back(pixel(point));
    return made;
}

std::string PanelGrid::path(std::span<const Point2> polygon, bool closed) const {
    std::string data;
    append_polygon(data, pixels(polygon), closed);
    return data;
}

double panel_width(std::size_t columns) {
    assert(columns > 0);
    return (picture_width - panel_margin) / static_cast<double>(columns) - panel_margin;
}

double panel_height(double width, Point2 box, bool is_graph) {
    assert(width > 0);
    const bool has_shape = !is_graph && box.x > 0 && std::isfinite(box.y / box.x);
    return width * (has_shape ? std::clamp(box.y / box.x, flattest_shape, tallest_shape) : graph_shape);
}

PanelGrid panel_grid(std::size_t columns, double height, const PlaneBox& box, Point2 scale) {
    assert(!box.is_empty());
    const Point2 size{.x = panel_width(columns), .y = height};
    return {.columns = columns,
            .size = size,
            .frame = {.anchor = box.middle(), .at = {.x = size.x / 2, .y = size.y / 2}, .scale = scale}};
}

std::string shared_polygon(std::string_view id, const std::string& path) {
    return "<defs><path id=\"" + std::string(id) +
           "\" fill=\"none\" stroke=\"#9a9a9a\" stroke-width=\"0.8\" stroke-linejoin=\"round\" d=\"" + path +
           "\"/></defs>\n";
}

std::string marked_polygon(const PanelGrid& grid, std::span<const Point2> polygon, bool closed,
                           std::size_t most_marks) {
    std::string text = "<path fill=\"none\" stroke=\"" + std::string(panel_colour) +
                       "\" stroke-width=\"1\" stroke-linejoin=\"round\" d=\"" + grid.path(polygon, closed) + "\"/>\n";
    if (polygon.size() <= most_marks) text += dots(grid.pixels(polygon), panel_colour, vertex_diameter);
    return text;
}

std::string cut_panel(const PanelGrid& grid, std::size_t place, std::string_view shared, const std::string& content,
                      const std::string& label) {
    const Point2 corner = grid.corner(place);
    return "<svg" + attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", grid.size.x) +
           attribute("height", grid.size.y) + ">\n<use href=\"#" + std::string(shared) + "\"/>\n" + content +
           "</svg>\n" +
           caption(label, {.x = corner.x + grid.size.x / 2, .y = corner.y + grid.size.y + panel_label_height - 7});
}

} // namespace internode
