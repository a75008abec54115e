// SPDX-License-Identifier: MIT

#include "internode/report/pyramid_report.h"

#include "internode/curve/parameter.h"
#include "internode/curve/refinement.h"
#include "internode/report/markup.h"
#include "internode/report/picture/polygon_path.h"
#include "internode/report/picture/svg.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace internode {

namespace {

constexpr double picture_width = 960;
constexpr double title_height = 44;
constexpr double margin = 14;
constexpr double label_height = 22;
constexpr double graph_shape = 0.45;    // height over width of a panel that shows a function
constexpr double tallest_shape = 1.6;   // of a panel
constexpr std::size_t few_points = 150; // vertices that are still marked

/// The levels as plane polygons: two coordinates, or numbers over their Greville abscissae.
std::vector<std::vector<Point2>> plane_polygons(const PyramidReport& report) {
    const std::size_t dimension = report.kept.coarse.dimension();
    std::vector<std::vector<Point2>> polygons;
    for (std::size_t level = 0; level < report.analysis.polygons.size(); ++level) {
        const std::vector<double>& points = report.analysis.polygons[level];
        std::vector<Point2>& polygon = polygons.emplace_back();
        if (dimension > 1) {
            for (std::size_t row = 0; row < points.size(); row += dimension)
                polygon.push_back({.x = points[row], .y = points[row + 1]});
            continue;
        }
        const Knots knots = refined_knots(report.kept.coarse.knots(), static_cast<int>(level));
        const CheckedCurve curve = make_curve(knots, 1, points);
        const std::vector<double> abscissae = curve.curve ? greville_abscissae(*curve.curve) : std::vector<double>();
        for (std::size_t i = 0; i < abscissae.size(); ++i) polygon.push_back({.x = abscissae[i], .y = points[i]});
    }
    return polygons;
}

struct Box {
    Point2 least{.x = std::numeric_limits<double>::max(), .y = std::numeric_limits<double>::max()};
    Point2 most{.x = std::numeric_limits<double>::lowest(), .y = std::numeric_limits<double>::lowest()};
};

Box box_around(const std::vector<Point2>& points, Box box = {}) {
    for (const Point2& point : points) {
        box.least = {.x = std::min(box.least.x, point.x), .y = std::min(box.least.y, point.y)};
        box.most = {.x = std::max(box.most.x, point.x), .y = std::max(box.most.y, point.y)};
    }
    return box;
}

/// Around all levels, though not around what noise blew up: half the size of the fine polygon beyond it at most.
Box box_of(const std::vector<std::vector<Point2>>& polygons) {
    constexpr double border = 0.03; // of the size: lines and marks at the edge
    const Box fine = box_around(polygons.back());
    const Point2 size{.x = fine.most.x - fine.least.x, .y = fine.most.y - fine.least.y};
    Box box = fine;
    for (const std::vector<Point2>& polygon : polygons) box = box_around(polygon, box);
    const auto low = [](double all, double own, double extent) {
        return std::max(all, own - extent / 2) - border * extent;
    };
    const auto high = [](double all, double own, double extent) {
        return std::min(all, own + extent / 2) + border * extent;
    };
    box.least = {.x = low(box.least.x, fine.least.x, size.x), .y = low(box.least.y, fine.least.y, size.y)};
    box.most = {.x = high(box.most.x, fine.most.x, size.x), .y = high(box.most.y, fine.most.y, size.y)};
    return box;
}

struct Grid {
    std::size_t columns = 1;
    double width = 0;  ///< of a panel
    double height = 0; ///< of a panel, without its label
    Point2 scale;      ///< pixels per unit
    Box box;

    [[nodiscard]] Point2 corner(std::size_t panel) const {
        const std::size_t row = panel / columns;
        return {.x = margin + static_cast<double>(panel % columns) * (width + margin),
                .y = title_height + static_cast<double>(row) * (height + label_height + margin)};
    }
    /// Within a panel.
    [[nodiscard]] Point2 pixel(Point2 point) const {
        const double x = width / 2 + (point.x - (box.least.x / 2 + box.most.x / 2)) * scale.x;
        const double y = height / 2 - (point.y - (box.least.y / 2 + box.most.y / 2)) * scale.y;
        // A point that noise took away is drawn just outside.
        return {.x = std::clamp(x, -width, 2 * width), .y = std::clamp(y, -height, 2 * height)};
    }
};

Grid grid_for(std::size_t panels, const Box& box, bool is_graph) {
    Grid grid;
    grid.box = box;
    grid.columns = panels <= 4    ? std::max<std::size_t>(panels, 2) / 2 + panels % 2
                   : panels <= 9  ? 3
                   : panels <= 16 ? 4
                                  : 6;
    grid.width = (picture_width - margin) / static_cast<double>(grid.columns) - margin;
    const Point2 size{.x = box.most.x - box.least.x, .y = box.most.y - box.least.y};
    const bool flat = !(size.x > 0) || is_graph;
    const double shape = flat ? graph_shape : std::clamp(size.y / size.x, 0.1, tallest_shape);
    grid.height = grid.width * shape;
    const double across = size.x > 0 ? grid.width / size.x : 1;
    const double up = size.y > 0 ? grid.height / size.y : 1;
    grid.scale = is_graph ? Point2{.x = across, .y = up}
                          : Point2{.x = size.y > 0 ? std::min(across, up) : across,
                                   .y = size.y > 0 ? std::min(across, up) : across};
    return grid;
}

std::string path_data(const std::vector<Point2>& polygon, const Grid& grid, bool closed) {
    std::vector<Point2> pixels;
    for (const Point2& point : polygon) pixels.push_back(grid.pixel(point));
    std::string data;
    append_polygon(data, pixels, closed);
    return data;
}

std::string vertices(const std::vector<Point2>& polygon, const Grid& grid) {
    std::string text = "<path fill=\"none\" stroke=\"#cc3311\" stroke-linecap=\"round\" stroke-width=\"3.2\" d=\"";
    for (const Point2& point : polygon) {
        text += 'M';
        append_point(text, grid.pixel(point));
        text += "h0";
    }
    return text + "\"/>\n";
}

std::string panel(const std::vector<Point2>& polygon, const Grid& grid, std::size_t place, std::size_t level,
                  bool closed) {
    const Point2 corner = grid.corner(place);
    std::string text = "<svg" + attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", grid.width) +
                       attribute("height", grid.height) + ">\n<use href=\"#fine\"/>\n";
    if (place > 0)
        text += "<path fill=\"none\" stroke=\"#cc3311\" stroke-width=\"1\" stroke-linejoin=\"round\" d=\"" +
                path_data(polygon, grid, closed) + "\"/>\n";
    if (place > 0 && polygon.size() <= few_points) text += vertices(polygon, grid);
    text += "</svg>\n<text" + attribute("x", corner.x + grid.width / 2) +
            attribute("y", corner.y + grid.height + label_height - 7) +
            " font-size=\"12\" text-anchor=\"middle\" fill=\"currentColor\">" +
            fmt::format("level {}: {} {}", level, polygon.size(), polygon.size() == 1 ? "point" : "points") +
            "</text>\n";
    return text;
}

std::string title_of(const PyramidReport& report) {
    const Curve& coarse = report.kept.coarse;
    const std::string& name = coarse.system().grammar().name;
    return fmt::format("{} taken apart by {}, degree {}", report.source, name.empty() ? "a grammar" : name,
                       coarse.degree());
}

} // namespace

std::string pyramid_picture(const PyramidReport& report, const Generator& generator) {
    const std::vector<std::vector<Point2>> polygons = plane_polygons(report);
    const bool is_graph = report.kept.coarse.dimension() == 1;
    const bool closed = report.kept.coarse.ends() == Ends::Circular && !is_graph;
    const Grid grid = grid_for(polygons.size(), box_of(polygons), is_graph);
    const std::size_t rows = (polygons.size() + grid.columns - 1) / grid.columns;
    std::string text = svg_open({.width = picture_width,
                                 .height = grid.corner(rows * grid.columns).y,
                                 .title = title_of(report),
                                 .description = "The polygon at every level, finest first, over the fine polygon.",
                                 .generator = generator},
                                SvgPlace::File);
    text += "<defs><path id=\"fine\" fill=\"none\" stroke=\"#9a9a9a\" stroke-width=\"0.8\" stroke-linejoin=\"round\" "
            "d=\"" +
            path_data(polygons.back(), grid, closed) + "\"/></defs>\n";
    text += "<text" + attribute("x", picture_width / 2) + attribute("y", 28) +
            " font-size=\"18\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"currentColor\">" +
            markup(title_of(report)) + "</text>\n";
    for (std::size_t place = 0; place < polygons.size(); ++place) {
        const std::size_t level = polygons.size() - 1 - place;
        text += panel(polygons[level], grid, place, level, closed);
    }
    return text + "</svg>\n";
}

} // namespace internode
