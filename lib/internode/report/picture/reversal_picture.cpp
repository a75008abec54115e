// SPDX-License-Identifier: MIT

#include "internode/report/picture/reversal_picture.h"

#include "internode/report/picture/marks.h"
#include "internode/report/picture/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

constexpr std::size_t most_columns = 3; // panels side by side

std::vector<Point2> plane(const std::vector<double>& points, std::size_t dimension) {
    assert(dimension > 0 && points.size() % dimension == 0);
    std::vector<Point2> polygon;
    const std::size_t count = points.size() / dimension;
    for (std::size_t i = 0; i < count; ++i) {
        const double place = static_cast<double>(i) / static_cast<double>(count);
        polygon.push_back(dimension == 1 ? Point2{.x = place, .y = points[i]}
                                         : Point2{.x = points[i * dimension], .y = points[i * dimension + 1]});
    }
    return polygon;
}

/// The box of the original, which approximations leave by little, fills a panel.
PanelGrid grid_around(const std::vector<Point2>& original, std::size_t columns, bool is_graph) {
    constexpr double border = 0.03; // part of the size, for lines and dots at the edge
    PlaneBox box;
    box.include(original);
    const Point2 size{.x = box.size().x * (1 + 2 * border), .y = box.size().y * (1 + 2 * border)};
    const double width = panel_width(columns);
    const double height = panel_height(width, size, is_graph);
    const Point2 scale = filling_scale(size, {.x = width, .y = height}, is_graph ? Units::Apart : Units::Equal);
    return panel_grid(columns, height, box, scale);
}

struct Panel {
    std::vector<Point2> polygon; ///< empty: the original alone
    std::string label;
};

std::vector<Panel> panels_of(const ReversalPicture& picture) {
    std::vector<Panel> panels{{{}, fmt::format("original: {} points", picture.original.size() / picture.dimension)}};
    for (const ReversalPicture::Phase& phase : picture.phases) {
        const std::size_t count = phase.points.size() / picture.dimension;
        panels.push_back({plane(phase.points, picture.dimension),
                          fmt::format("phase {}: {} {}", phase.phase, count, count == 1 ? "point" : "points")});
    }
    return panels;
}

} // namespace

std::string reversal_picture(const ReversalPicture& picture) {
    if (picture.dimension == 0 || picture.original.size() < picture.dimension)
        throw std::invalid_argument("reversal_picture: no point to draw");
    constexpr std::size_t few_points = 200; // vertices that are still marked
    const std::vector<Point2> original = plane(picture.original, picture.dimension);
    const bool is_graph = picture.dimension == 1;
    const std::vector<Panel> panels = panels_of(picture);
    const PanelGrid grid = grid_around(original, std::min(panels.size(), most_columns), is_graph);
    std::string text = svg_open({.width = picture_width,
                                 .height = grid.bottom(panels.size()),
                                 .title = picture.title,
                                 .description = "The original, and what is left of it in each phase of the ring.",
                                 .generator = picture.generator},
                                SvgPlace::File);
    text += shared_polygon("original", grid.path(original, !is_graph));
    text += title_text(picture.title, {.x = picture_width / 2, .y = 28});
    for (std::size_t place = 0; place < panels.size(); ++place) {
        const std::vector<Point2>& polygon = panels[place].polygon;
        const std::string drawn =
            polygon.empty() ? std::string() : marked_polygon(grid, polygon, !is_graph, few_points);
        text += cut_panel(grid, place, "original", drawn, panels[place].label);
    }
    return text + "</svg>\n";
}

} // namespace internode
