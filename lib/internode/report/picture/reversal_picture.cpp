// SPDX-License-Identifier: MIT

#include "internode/report/picture/reversal_picture.h"

#include "internode/report/markup.h"
#include "internode/report/picture/polygon_path.h"
#include "internode/report/picture/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace internode {

namespace {

constexpr double picture_width = 960;
constexpr double title_height = 44;
constexpr double margin = 14;
constexpr double label_height = 22;
constexpr double graph_shape = 0.45;    // height over width of a panel that shows numbers
constexpr double border = 0.03;         // of the size: lines and dots at the edge
constexpr double tallest_shape = 1.6;   // of a panel
constexpr std::size_t few_points = 200; // vertices that are still marked
constexpr std::size_t most_columns = 3; // panels side by side

std::vector<Point2> plane(const std::vector<double>& points, std::size_t dimension) {
    std::vector<Point2> polygon;
    const std::size_t count = points.size() / dimension;
    for (std::size_t i = 0; i < count; ++i) {
        const double place = static_cast<double>(i) / static_cast<double>(count);
        polygon.push_back(dimension == 1 ? Point2{.x = place, .y = points[i]}
                                         : Point2{.x = points[i * dimension], .y = points[i * dimension + 1]});
    }
    return polygon;
}

/// One panel's size, and the way from the plane into it: the box of the original, which approximations leave by little.
struct Frame {
    double width = 0;
    double height = 0;
    Point2 middle; ///< of the box
    Point2 scale;  ///< pixels per unit

    [[nodiscard]] Point2 pixel(Point2 point) const {
        // A point that noise took away is drawn just outside.
        return {.x = std::clamp(width / 2 + (point.x - middle.x) * scale.x, -width, 2 * width),
                .y = std::clamp(height / 2 - (point.y - middle.y) * scale.y, -height, 2 * height)};
    }
};

Frame frame_of(const std::vector<Point2>& original, std::size_t columns, bool is_graph) {
    const auto [left, right] = std::ranges::minmax(original, {}, &Point2::x);
    const auto [low, high] = std::ranges::minmax(original, {}, &Point2::y);
    const Point2 size{.x = (right.x - left.x) * (1 + 2 * border), .y = (high.y - low.y) * (1 + 2 * border)};
    Frame frame;
    frame.middle = {.x = left.x / 2 + right.x / 2, .y = low.y / 2 + high.y / 2};
    frame.width = (picture_width - margin) / static_cast<double>(columns) - margin;
    const bool is_flat = is_graph || !(size.x > 0) || !std::isfinite(size.y / size.x);
    frame.height = frame.width * (is_flat ? graph_shape : std::clamp(size.y / size.x, 0.1, tallest_shape));
    const double across = size.x > 0 ? frame.width / size.x : 1;
    const double up = size.y > 0 ? frame.height / size.y : 1;
    frame.scale =
        is_graph ? Point2{.x = across, .y = up} : Point2{.x = std::min(across, up), .y = std::min(across, up)};
    return frame;
}

std::string path_data(const std::vector<Point2>& polygon, const Frame& frame, bool closed) {
    std::vector<Point2> pixels;
    for (const Point2& point : polygon) pixels.push_back(frame.pixel(point));
    std::string data;
    append_polygon(data, pixels, closed);
    return data;
}

std::string dots(const std::vector<Point2>& polygon, const Frame& frame) {
    if (polygon.size() > few_points) return {};
    std::string text = "<path fill=\"none\" stroke=\"#cc3311\" stroke-linecap=\"round\" stroke-width=\"3.2\" d=\"";
    for (const Point2& point : polygon) {
        text += 'M';
        append_point(text, frame.pixel(point));
        text += "h0";
    }
    return text + "\"/>\n";
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

std::string panel_text(const Panel& panel, const Frame& frame, Point2 corner, bool closed) {
    std::string text = "<svg" + attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", frame.width) +
                       attribute("height", frame.height) + ">\n" + "<use href=\"#original\"/>\n";
    if (!panel.polygon.empty())
        text += "<path fill=\"none\" stroke=\"#cc3311\" stroke-width=\"1\" stroke-linejoin=\"round\" d=\"" +
                path_data(panel.polygon, frame, closed) + "\"/>\n" + dots(panel.polygon, frame);
    return text + "</svg>\n<text" + attribute("x", corner.x + frame.width / 2) +
           attribute("y", corner.y + frame.height + label_height - 7) +
           " font-size=\"12\" text-anchor=\"middle\" fill=\"currentColor\">" + panel.label + "</text>\n";
}

} // namespace

std::string reversal_picture(const ReversalPicture& picture) {
    if (picture.dimension == 0 || picture.original.size() < picture.dimension)
        throw std::invalid_argument("reversal_picture: no point to draw");
    const std::vector<Point2> original = plane(picture.original, picture.dimension);
    const bool is_graph = picture.dimension == 1;
    const std::vector<Panel> panels = panels_of(picture);
    const std::size_t columns = std::min(panels.size(), most_columns);
    const Frame frame = frame_of(original, columns, is_graph);
    const double row_height = frame.height + label_height + margin;
    const std::size_t rows = (panels.size() + columns - 1) / columns;
    std::string text = svg_open({.width = picture_width,
                                 .height = title_height + static_cast<double>(rows) * row_height,
                                 .title = picture.title,
                                 .description = "The original, and what is left of it in each phase of the ring.",
                                 .generator = picture.generator},
                                SvgPlace::File);
    text += "<defs><path id=\"original\" fill=\"none\" stroke=\"#9a9a9a\" stroke-width=\"0.8\" "
            "stroke-linejoin=\"round\" d=\"" +
            path_data(original, frame, !is_graph) + "\"/></defs>\n";
    text += "<text" + attribute("x", picture_width / 2) + attribute("y", 28) +
            " font-size=\"18\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"currentColor\">" +
            markup(picture.title) + "</text>\n";
    for (std::size_t place = 0; place < panels.size(); ++place) {
        const std::size_t row = place / columns;
        const Point2 corner{.x = margin + static_cast<double>(place % columns) * (frame.width + margin),
                            .y = title_height + static_cast<double>(row) * row_height};
        text += panel_text(panels[place], frame, corner, !is_graph);
    }
    return text + "</svg>\n";
}

} // namespace internode
