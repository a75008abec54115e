// SPDX-License-Identifier: MIT

#include "internode/report/picture/levels_picture.h"

#include "internode/report/markup.h"
#include "internode/report/picture/polygon_path.h"
#include "internode/report/picture/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace internode {

namespace {

constexpr double picture_width = 960;
constexpr double title_height = 44;
constexpr double legend_height = 40;
constexpr double margin = 14;
constexpr double inset = 8; // of a panel: lines and dots at its edge
constexpr double label_height = 22;
constexpr double graph_shape = 0.45;  // height over width of a panel that shows a function
constexpr double tallest_panel = 560; // pixels
constexpr std::size_t few_points = 120;
constexpr std::size_t many_points = 600; // beyond, dots would hide the lines

/// A level in the plane; coordinates are quarters, so that no difference of finite numbers overflows.
struct PlaneLevel {
    std::size_t number = 0;
    std::vector<Point2> points;
    std::vector<PointStrands::Strand> strands;
    std::vector<Point2> lines; ///< pairs
};

std::vector<Point2> plane_points(const std::vector<double>& rows, std::size_t dimension, PictureAxes axes) {
    std::vector<Point2> points;
    if (dimension == 0) return points;
    const std::size_t count = rows.size() / dimension;
    if (dimension > 1 && std::max(axes.right, axes.up) >= dimension)
        throw std::invalid_argument("levels_picture: no such coordinate");
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double place = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
        points.push_back(
            dimension == 1 ? Point2{.x = place / 4, .y = rows[i] / 4}
                           : Point2{.x = rows[i * dimension + axes.right] / 4, .y = rows[i * dimension + axes.up] / 4});
    }
    return points;
}

std::vector<PlaneLevel> plane_levels(const LevelsPicture& picture) {
    std::vector<PlaneLevel> levels;
    for (const PictureLevel& level : picture.levels)
        levels.push_back({level.number, plane_points(level.strands.points, level.strands.dimension, picture.axes),
                          level.strands.strands,
                          plane_points(level.strands.lines, level.strands.dimension, picture.axes)});
    return levels;
}

struct Box {
    Point2 least{.x = std::numeric_limits<double>::max(), .y = std::numeric_limits<double>::max()};
    Point2 most{.x = std::numeric_limits<double>::lowest(), .y = std::numeric_limits<double>::lowest()};

    void include(const std::vector<Point2>& points) {
        for (const Point2& point : points) {
            least = {.x = std::min(least.x, point.x), .y = std::min(least.y, point.y)};
            most = {.x = std::max(most.x, point.x), .y = std::max(most.y, point.y)};
        }
    }
    [[nodiscard]] bool is_empty() const { return least.x > most.x; }
};

Box box_of(const std::vector<PlaneLevel>& levels) {
    Box box;
    for (const PlaneLevel& level : levels) {
        box.include(level.points);
        box.include(level.lines);
    }
    if (box.is_empty()) throw std::invalid_argument("levels_picture: no points");
    return box;
}

/// Panels of one size in rows, and the way from the plane into a panel.
struct Grid {
    std::size_t columns = 1;
    double width = 0;  ///< of a panel
    double height = 0; ///< of a panel, without its label
    Point2 scale;      ///< pixels per unit
    Box box;

    [[nodiscard]] double top(std::size_t row) const {
        return title_height + static_cast<double>(row) * (height + label_height + margin);
    }
    [[nodiscard]] Point2 corner(std::size_t panel) const {
        return {.x = margin + static_cast<double>(panel % columns) * (width + margin), .y = top(panel / columns)};
    }
    [[nodiscard]] Point2 pixel(Point2 point) const {
        return {.x = width / 2 + (point.x - (box.least.x / 2 + box.most.x / 2)) * scale.x,
                .y = height / 2 - (point.y - (box.least.y / 2 + box.most.y / 2)) * scale.y};
    }
};

/// Pixels per unit that fill `pixels`; 0 for an extent that is nothing.
double filling(double pixels, double extent) {
    constexpr double nothing = 1e-300;
    return extent > nothing ? pixels / extent : 0;
}

std::size_t columns_for(std::size_t panels) {
    if (panels <= 3) return panels;
    return panels == 4 ? 2 : panels <= 9 ? 3 : 4;
}

Grid grid_for(std::size_t panels, const Box& box, bool is_graph) {
    Grid grid;
    grid.box = box;
    grid.columns = columns_for(panels);
    grid.width = (picture_width - margin) / static_cast<double>(grid.columns) - margin;
    const Point2 size{.x = box.most.x - box.least.x, .y = box.most.y - box.least.y};
    const double room = grid.width - 2 * inset;
    const double across = filling(room, size.x);
    if (is_graph) {
        grid.height = grid.width * graph_shape;
        grid.scale = {.x = across, .y = filling(grid.height - 2 * inset, size.y)};
        return grid;
    }
    const double up = filling(tallest_panel - 2 * inset, size.y);
    const double scale = across == 0 ? up : up == 0 ? across : std::min(across, up);
    grid.scale = {.x = scale, .y = scale};
    grid.height = std::max(size.y * scale, 30.0) + 2 * inset;
    return grid;
}

void append_strand(std::string& path, const PlaneLevel& level, const PointStrands::Strand& strand, const Grid& grid) {
    std::vector<Point2> pixels;
    for (const std::size_t point : strand.points) pixels.push_back(grid.pixel(level.points[point]));
    append_polygon(path, pixels, strand.closed);
}

std::string lines_of(const PlaneLevel& level, const Grid& grid) {
    std::string path;
    for (std::size_t i = 0; i + 1 < level.lines.size(); i += 2) {
        path += 'M';
        append_point(path, grid.pixel(level.lines[i]));
        path += 'L';
        append_point(path, grid.pixel(level.lines[i + 1]));
    }
    if (level.lines.empty())
        for (const PointStrands::Strand& strand : level.strands) append_strand(path, level, strand, grid);
    return path;
}

constexpr std::string_view dot_style = "fill=\"none\" stroke=\"#cc3311\" stroke-linecap=\"round\"";
constexpr std::string_view line_style = "fill=\"none\" stroke=\"#222222\" stroke-linejoin=\"round\"";
constexpr std::string_view control_style = "fill=\"none\" stroke=\"#a8a8a8\" stroke-width=\"0.9\"";

std::string dots(const PlaneLevel& level, const Grid& grid) {
    if (level.points.size() > many_points) return {};
    std::string text = "<path " + std::string(dot_style) +
                       attribute("stroke-width", level.points.size() > few_points ? 2.2 : 3.6) + " d=\"";
    for (const Point2& point : level.points) {
        text += 'M';
        append_point(text, grid.pixel(point));
        text += "h0";
    }
    return text + "\"/>\n";
}

std::string counted(std::size_t count, std::string_view thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string panel(const PlaneLevel& level, const Grid& grid, std::size_t place, bool over_control) {
    const Point2 corner = grid.corner(place);
    std::string text = "<g id=\"level-" + std::to_string(level.number) + "\" transform=\"translate(" + fixed(corner.x) +
                       " " + fixed(corner.y) + ")\">\n";
    if (over_control) text += "<use href=\"#control\"/>\n";
    text += "<path " + std::string(line_style) +
            attribute("stroke-width", level.points.size() > many_points ? 0.7 : 1) + " d=\"" + lines_of(level, grid) +
            "\"/>\n" + dots(level, grid);
    text += "<text" + attribute("x", grid.width / 2) + attribute("y", grid.height + label_height - 6) +
            " font-size=\"12\" text-anchor=\"middle\" fill=\"currentColor\">level " + std::to_string(level.number) +
            ": " + counted(level.points.size(), "point");
    if (!level.lines.empty()) text += ", " + counted(level.lines.size() / 2, "edge");
    return text + "</text>\n</g>\n";
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
        entries.push_back({"<path d=\"M17 0h0\" " + std::string(dot_style) + " stroke-width=\"3.6\"/>", "point", 80});
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

} // namespace

std::string levels_picture(const LevelsPicture& picture) {
    if (picture.levels.empty() || picture.levels.size() > max_level_panels)
        throw std::invalid_argument("levels_picture: from 1 to 12 levels");
    const std::vector<PlaneLevel> levels = plane_levels(picture);
    const Grid grid = grid_for(levels.size(), box_of(levels), picture.levels.front().strands.dimension == 1);
    const std::size_t rows = (levels.size() + grid.columns - 1) / grid.columns;
    std::string text = svg_open({.width = picture_width,
                                 .height = grid.top(rows) + legend_height - margin,
                                 .title = picture.title,
                                 .description = "A panel for the polygon of every level.",
                                 .generator = picture.generator},
                                SvgPlace::File);
    if (picture.has_control)
        text += "<defs><path id=\"control\" " + std::string(control_style) + " d=\"" + lines_of(levels.front(), grid) +
                "\"/></defs>\n";
    text += "<text" + attribute("x", picture_width / 2) + attribute("y", 28) +
            " font-size=\"18\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"currentColor\">" +
            markup(picture.title) + "</text>\n";
    for (std::size_t place = 0; place < levels.size(); ++place)
        text += panel(levels[place], grid, place, picture.has_control && place > 0);
    const bool has_dots = std::ranges::any_of(
        levels, [](const PlaneLevel& level) { return !level.points.empty() && level.points.size() <= many_points; });
    return text + legend(grid.top(rows) + 10, picture.has_control, has_dots) + "</svg>\n";
}

} // namespace internode
