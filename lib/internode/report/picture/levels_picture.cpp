// SPDX-License-Identifier: MIT

#include "internode/report/picture/levels_picture.h"

#include "internode/point/strands.h"
#include "internode/report/markup.h"
#include "internode/report/picture/marks.h"
#include "internode/report/picture/panels.h"
#include "internode/report/picture/polygon_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <span>
#include <stdexcept>

namespace internode {

namespace {

constexpr double legend_height = 40;
constexpr double inset = 8;           // pixels for lines and dots at the edge of a panel
constexpr double tallest_panel = 560; // pixels
constexpr double lowest_panel = 30;   // pixels within the inset
constexpr std::size_t few_points = 120;
constexpr std::size_t many_points = 600; // beyond, dots would hide the lines

/// A part of a level in the plane.
struct PlanePart {
    std::vector<Point2> points;
    std::span<const PointStrands::Strand> strands;
    std::vector<Point2> lines; ///< pairs
};

/// A level in the plane.
struct PlaneLevel {
    std::size_t number = 0;
    std::vector<PlanePart> parts;

    [[nodiscard]] std::size_t point_count() const {
        std::size_t count = 0;
        for (const PlanePart& part : parts) count += part.points.size();
        return count;
    }
    [[nodiscard]] std::size_t line_count() const {
        std::size_t count = 0;
        for (const PlanePart& part : parts) count += part.lines.size() / 2;
        return count;
    }
};

std::vector<Point2> plane_points(const std::vector<double>& rows, std::size_t dimension, PictureAxes axes) {
    std::vector<Point2> points;
    if (dimension == 0) return points;
    assert(rows.size() % dimension == 0);
    const std::size_t count = rows.size() / dimension;
    if (dimension > 1 && std::max(axes.right, axes.up) >= dimension)
        throw std::invalid_argument("levels_picture: no such coordinate");
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double place = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
        points.push_back(dimension == 1
                             ? Point2{.x = place, .y = rows[i]}
                             : Point2{.x = rows[i * dimension + axes.right], .y = rows[i * dimension + axes.up]});
    }
    return points;
}

std::vector<PlaneLevel> plane_levels(const LevelsPicture& picture) {
    std::vector<PlaneLevel> levels;
    for (const PictureLevel& level : picture.levels) {
        PlaneLevel& plane = levels.emplace_back();
        plane.number = level.number;
        for (const PointStrands& part : level.parts)
            plane.parts.push_back({plane_points(part.points, part.dimension, picture.axes), part.strands,
                                   plane_points(part.lines, part.dimension, picture.axes)});
    }
    return levels;
}

PlaneBox box_of(const std::vector<PlaneLevel>& levels) {
    PlaneBox box;
    for (const PlaneLevel& level : levels)
        for (const PlanePart& part : level.parts) {
            box.include(part.points);
            box.include(part.lines);
        }
    if (box.is_empty()) throw std::invalid_argument("levels_picture: no points");
    return box;
}

std::size_t columns_for(std::size_t panels) {
    assert(panels >= 1 && panels <= max_level_panels);
    if (panels <= 3) return panels;
    return panels == 4 ? 2 : panels <= 9 ? 3 : 4;
}

PanelGrid grid_for(std::size_t panels, const PlaneBox& box, bool is_graph) {
    const std::size_t columns = columns_for(panels);
    const double width = panel_width(columns);
    const double graph_height = width * graph_shape;
    const Point2 room{.x = width - 2 * inset, .y = (is_graph ? graph_height : tallest_panel) - 2 * inset};
    const Point2 scale = filling_scale(box.size(), room, is_graph ? Units::Apart : Units::Equal);
    const double height = is_graph ? graph_height : std::max(box.size().y * scale.y, lowest_panel) + 2 * inset;
    return panel_grid(columns, height, box, scale);
}

void append_strand(std::string& path, const PlanePart& part, const PointStrands::Strand& strand,
                   const PanelGrid& grid) {
    std::vector<Point2> pixels;
    pixels.reserve(strand.points.size());
    for (const std::size_t point : strand.points) {
        assert(point < part.points.size());
        pixels.push_back(grid.pixel(part.points[point]));
    }
    append_polygon(path, pixels, strand.closed);
}

/// The lines that a part has of its own, or else its strands.
void append_part(std::string& path, const PlanePart& part, const PanelGrid& grid) {
    assert(part.lines.size() % 2 == 0);
    for (std::size_t i = 0; i + 1 < part.lines.size(); i += 2) {
        path += 'M';
        append_point(path, grid.pixel(part.lines[i]));
        path += 'L';
        append_point(path, grid.pixel(part.lines[i + 1]));
    }
    if (part.lines.empty())
        for (const PointStrands::Strand& strand : part.strands) append_strand(path, part, strand, grid);
}

std::string lines_of(const PlaneLevel& level, const PanelGrid& grid) {
    std::string path;
    for (const PlanePart& part : level.parts) append_part(path, part, grid);
    return path;
}

constexpr std::string_view line_style = "fill=\"none\" stroke=\"#222222\" stroke-linejoin=\"round\"";
constexpr std::string_view control_style = "fill=\"none\" stroke=\"#a8a8a8\" stroke-width=\"0.9\"";

std::string level_dots(const PlaneLevel& level, const PanelGrid& grid) {
    const std::size_t count = level.point_count();
    if (count > many_points) return {};
    std::vector<Point2> pixels;
    for (const PlanePart& part : level.parts)
        for (const Point2& point : part.points) pixels.push_back(grid.pixel(point));
    return dots(pixels, panel_colour, count > few_points ? 2.2 : 3.6);
}

std::string counted(std::size_t count, std::string_view thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string panel_label(const PlaneLevel& level) {
    std::string text = fmt::format("level {}: {}", level.number, counted(level.point_count(), "point"));
    if (level.line_count() > 0) text += ", " + counted(level.line_count(), "edge");
    return level.parts.size() > 1 ? text + " in " + counted(level.parts.size(), "part") : text;
}

std::string panel(const PlaneLevel& level, const PanelGrid& grid, std::size_t place, bool over_control) {
    const Point2 corner = grid.corner(place);
    std::string text = "<g id=\"level-" + std::to_string(level.number) + "\" transform=\"translate(" + fixed(corner.x) +
                       " " + fixed(corner.y) + ")\">\n";
    if (over_control) text += "<use href=\"#control\"/>\n";
    text += "<path " + std::string(line_style) +
            attribute("stroke-width", level.point_count() > many_points ? 0.7 : 1) + " d=\"" + lines_of(level, grid) +
            "\"/>\n" + level_dots(level, grid);
    return text + caption(panel_label(level), {.x = grid.size.x / 2, .y = grid.size.y + panel_label_height - 6}) +
           "</g>\n";
}

std::string legend(double top, bool has_control, bool has_dots) {
    struct Entry {
        std::string sample;
        std::string_view label;
        double width; ///< pixels
    };
    std::vector<Entry> entries;
    if (has_control)
        entries.push_back({"<path d=\"M0 0H34\" " + std::string(control_style) + "/>", "control polygon", 190});
    entries.push_back({"<path d=\"M0 0H34\" " + std::string(line_style) + "/>", "polygon of the level", 210});
    if (has_dots)
        entries.push_back({"<path d=\"M17 0h0\" fill=\"none\" stroke=\"" + std::string(panel_colour) +
                               "\" stroke-linecap=\"round\" stroke-width=\"3.6\"/>",
                           "point", 80});
    double x = picture_width / 2;
    for (const Entry& entry : entries) x -= entry.width / 2;
    std::string text = "<g id=\"legend\" font-size=\"12\">\n";
    for (const Entry& entry : entries) {
        text += "<g transform=\"translate(" + fixed(x) + " " + fixed(top) + ")\">" + entry.sample +
                "<text x=\"42\" y=\"4\" fill=\"currentColor\">" + std::string(entry.label) + "</text></g>\n";
        x += entry.width;
    }
    return text + "</g>\n";
}

bool is_graph(const LevelsPicture& picture) {
    const std::vector<PointStrands>& parts = picture.levels.front().parts;
    const auto drawn = [](const PointStrands& part) { return part.dimension > 0; };
    const auto first = std::ranges::find_if(parts, drawn);
    if (first == parts.end()) return false;
    const bool graph = first->dimension == 1;
    for (const PointStrands& part : parts)
        if (drawn(part) && (part.dimension == 1) != graph)
            throw std::invalid_argument("levels_picture: numbers beside points");
    return graph;
}

} // namespace

std::string levels_picture(const LevelsPicture& picture) {
    if (picture.levels.empty() || picture.levels.size() > max_level_panels)
        throw std::invalid_argument("levels_picture: from 1 to 12 levels");
    const std::vector<PlaneLevel> levels = plane_levels(picture);
    const PanelGrid grid = grid_for(levels.size(), box_of(levels), is_graph(picture));
    const double bottom = grid.bottom(levels.size());
    std::string text = svg_open({.width = picture_width,
                                 .height = bottom + legend_height - panel_margin,
                                 .title = picture.title,
                                 .description = "A panel for the polygon of every level.",
                                 .generator = picture.generator},
                                SvgPlace::File);
    if (picture.has_control)
        text += "<defs><path id=\"control\" " + std::string(control_style) + " d=\"" + lines_of(levels.front(), grid) +
                "\"/></defs>\n";
    text += title_text(picture.title, {.x = picture_width / 2, .y = 28});
    for (std::size_t place = 0; place < levels.size(); ++place)
        text += panel(levels[place], grid, place, picture.has_control && place > 0);
    const bool has_dots = std::ranges::any_of(
        levels, [](const PlaneLevel& level) { return level.point_count() > 0 && level.point_count() <= many_points; });
    return text + legend(bottom + 10, picture.has_control, has_dots) + "</svg>\n";
}

} // namespace internode
