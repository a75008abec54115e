// SPDX-License-Identifier: MIT

#include "internode/report/picture/curve_picture.h"

#include "internode/report/markup.h"
#include "internode/report/picture/palette.h"
#include "internode/report/picture/picture_legend.h"
#include "internode/text/diagnostic.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace internode {

namespace {

constexpr double picture_width = 960;
constexpr double margin = 28;
constexpr double title_height = 30;
constexpr double largest_height = 720;
constexpr double graph_height = 420;
constexpr std::size_t few_points = 400;     // polygon vertices that are still marked
constexpr std::size_t many_points = 3000;   // beyond, a refined polygon and its curve are one line to the eye
constexpr std::size_t many_segments = 1000; // beyond, marks at the knots would hide the curve
constexpr std::size_t smooth_points = 4000; // of a polyline that stands for a curve

/// From the plane to pixels: equal scales unless the picture is a graph.
struct Frame {
    Point2 least; ///< smallest coordinates, in quarters
    Point2 scale;
    Point2 origin; ///< pixel of the smallest coordinates
    double top = 0;
    double height = 0;
    int decimals = 2;

    [[nodiscard]] Point2 pixel(Point2 point) const {
        return {.x = origin.x + (point.x / 4 - least.x) * scale.x, .y = origin.y - (point.y / 4 - least.y) * scale.y};
    }
};

struct Extent {
    Point2 least{.x = std::numeric_limits<double>::max(), .y = std::numeric_limits<double>::max()};
    Point2 greatest{.x = std::numeric_limits<double>::lowest(), .y = std::numeric_limits<double>::lowest()};

    void include(const std::vector<Point2>& points) {
        for (const Point2& point : points) {
            least = {.x = std::min(least.x, point.x), .y = std::min(least.y, point.y)};
            greatest = {.x = std::max(greatest.x, point.x), .y = std::max(greatest.y, point.y)};
        }
    }
};

/// Pixels per unit so that `extent` fills `pixels`; 0 when it has no size to speak of.
double filling(double pixels, double extent) {
    constexpr double nothing = 1e-300;
    return extent > nothing ? pixels / extent : 0;
}

/// Quarters of coordinates, so that no difference of finite numbers overflows.
Frame make_frame(const PlanarCurve& curve, SvgPlace place) {
    Extent extent;
    extent.include(curve.control);
    extent.include(curve.refined);
    extent.include(curve.segments);
    Frame frame;
    frame.least = {.x = extent.least.x / 4, .y = extent.least.y / 4};
    const Point2 size{.x = extent.greatest.x / 4 - frame.least.x, .y = extent.greatest.y / 4 - frame.least.y};
    const double width = picture_width - 2 * margin;
    const double top = place == SvgPlace::File ? margin + title_height : margin;
    if (curve.is_graph) {
        frame.scale = {.x = filling(width, size.x), .y = filling(graph_height, size.y)};
    } else {
        const double across = filling(width, size.x);
        const double along = filling(largest_height, size.y);
        const double scale = across == 0 ? along : along == 0 ? across : std::min(across, along);
        frame.scale = {.x = scale, .y = scale};
    }
    const double content_height = curve.is_graph ? graph_height : std::max(size.y * frame.scale.y, 40.0);
    frame.origin = {.x = (picture_width - size.x * frame.scale.x) / 2,
                    .y = top + (content_height + size.y * frame.scale.y) / 2};
    frame.top = top;
    frame.height = top + content_height + margin;
    frame.decimals = curve.symbols.size() > many_points ? 2 : 3;
    return frame;
}

std::string polygon_path(const std::vector<Point2>& points, bool closed, const Frame& frame) {
    std::string path;
    for (std::size_t k = 0; k < points.size(); ++k) {
        path += k == 0 ? 'M' : 'L';
        append_point(path, frame.pixel(points[k]), 2);
    }
    return path + (closed ? "Z" : "");
}

/// Marks of a diameter in pixels, as dots of one path.
std::string dots(const std::vector<Point2>& pixels, std::string_view colour, double diameter) {
    std::string text = "<path fill=\"none\" stroke=\"" + std::string(colour) + "\" stroke-linecap=\"round\"" +
                       attribute("stroke-width", diameter) + " d=\"";
    for (const Point2& pixel : pixels) {
        text += 'M';
        append_point(text, pixel);
        text += "h0";
    }
    return text + "\"/>\n";
}

std::string draw_polygon(std::string_view name, const std::vector<Point2>& points, const PlanarCurve& curve,
                         const Frame& frame) {
    const bool is_control = name == "control";
    const std::string_view colour = is_control ? "#8c8c8c" : "#b9b9b9";
    std::string text = "<g id=\"" + std::string(name) + "\">\n<path fill=\"none\" stroke=\"" + std::string(colour) +
                       "\" stroke-linejoin=\"round\" stroke-width=\"" + (points.size() > few_points ? "0.7" : "1") +
                       "\" d=\"" + polygon_path(points, curve.closed, frame) + "\"/>\n";
    if (points.size() <= few_points) {
        std::vector<Point2> pixels;
        for (const Point2& point : points) pixels.push_back(frame.pixel(point));
        text += dots(pixels, colour, is_control ? 5 : 3);
    }
    return text + "</g>\n";
}

/// A Bézier curve, rational when it has weights.
struct Piece {
    std::span<const Point2> points;
    std::span<const double> weights; ///< none, or one per point
};

/// A point of a Bézier curve, by de Casteljau; with weights every step is a convex combination too (Farin).
Point2 bezier_point(const Piece& piece, double t) {
    std::vector<Point2> points(piece.points.begin(), piece.points.end());
    std::vector<double> weights(piece.weights.begin(), piece.weights.end());
    for (std::size_t left = points.size() - 1; left > 0; --left)
        for (std::size_t b = 0; b < left; ++b) {
            double part = t;
            if (!weights.empty()) {
                const double weight = (1 - t) * weights[b] + t * weights[b + 1];
                part = t * weights[b + 1] / weight;
                weights[b] = weight;
            }
            points[b] = {.x = (1 - part) * points[b].x + part * points[b + 1].x,
                         .y = (1 - part) * points[b].y + part * points[b + 1].y};
        }
    return points.front();
}

/// The commands of one segment after its start.
void append_segment(std::string& path, const Piece& piece, std::size_t chords, int decimals) {
    const std::size_t degree = piece.points.size() - 1;
    if (degree <= 3 && piece.weights.empty()) {
        path += std::string_view("LQC")[degree - 1];
        for (std::size_t b = 1; b <= degree; ++b) {
            if (b > 1) path += ' ';
            append_point(path, piece.points[b], decimals);
        }
        return;
    }
    for (std::size_t chord = 1; chord <= chords; ++chord) {
        path += 'L';
        append_point(path, bezier_point(piece, static_cast<double>(chord) / static_cast<double>(chords)), decimals);
    }
}

/// One path per symbol; a piece that goes on where the last one of its symbol ended needs no start of its own.
std::vector<std::string> symbol_paths(const PlanarCurve& curve, const std::vector<Point2>& pixels, int decimals) {
    const std::size_t size = static_cast<std::size_t>(curve.degree) + 1;
    const std::size_t most = curve.weights.empty() ? 16 : 64; // chords: a rational piece may turn by half a circle
    const std::size_t chords = std::clamp<std::size_t>(smooth_points / curve.symbols.size(), 2, most);
    std::vector<std::string> paths(curve.names.size());
    for (std::size_t k = 0; k < curve.symbols.size(); ++k) {
        std::string& path = paths[to_index(curve.symbols[k])];
        Piece piece{std::span<const Point2>(pixels).subspan(k * size, size), {}};
        if (!curve.weights.empty()) piece.weights = std::span<const double>(curve.weights).subspan(k * size, size);
        std::string start;
        append_point(start, piece.points.front(), decimals);
        std::string end_before;
        if (k > 0 && curve.symbols[k - 1] == curve.symbols[k]) append_point(end_before, pixels[k * size - 1], decimals);
        if (start != end_before) path += "M" + start;
        append_segment(path, piece, chords, decimals);
    }
    return paths;
}

std::string draw_limit(const PlanarCurve& curve, const std::vector<Point2>& pixels, int decimals) {
    const char* const width = curve.symbols.size() > many_points ? "1.3" : "2.4";
    std::string text =
        "<g id=\"limit\" fill=\"none\" stroke-linejoin=\"round\" stroke-width=\"" + std::string(width) + "\">\n";
    const std::vector<std::string> paths = symbol_paths(curve, pixels, decimals);
    for (std::size_t i = 0; i < paths.size(); ++i)
        if (!paths[i].empty()) text += "<path" + symbol_stroke(to_symbol(i)) + " d=\"" + paths[i] + "\"/>\n";
    return text + "</g>\n";
}

std::string draw_knots(const PlanarCurve& curve, const std::vector<Point2>& pixels) {
    const std::size_t size = static_cast<std::size_t>(curve.degree) + 1;
    std::vector<Point2> marks;
    for (std::size_t k = 0; k < curve.symbols.size(); ++k) marks.push_back(pixels[k * size]);
    if (!curve.closed) marks.push_back(pixels.back());
    const double diameter = curve.symbols.size() > 200 ? 3 : 5;
    return "<g id=\"knots\">\n" + dots(marks, "#222222", diameter) + dots(marks, "#ffffff", diameter - 1.8) + "</g>\n";
}

/// The range of the values and of the parameter, at the edges of a graph.
std::string draw_ranges(const Frame& frame) {
    const double left = margin;
    const double right = picture_width - margin;
    const double bottom = frame.height - margin;
    return "<g id=\"axes\" stroke=\"#b9b9b9\" stroke-width=\"1\"><path d=\"M" + fixed(left - 8) + " " +
           fixed(frame.top) + "V" + fixed(bottom + 8) + "H" + fixed(right) + "\" fill=\"none\"/></g>\n<text" +
           attribute("x", right) + attribute("y", bottom + 24) +
           " font-size=\"12\" text-anchor=\"end\" fill=\"currentColor\">parameter</text>\n";
}

std::string description(const PlanarCurve& curve) {
    return "A curve of degree " + std::to_string(curve.degree) + " with " + std::to_string(curve.symbols.size()) +
           " knot intervals, each drawn in the colour and dashes of its symbol, and the control polygon of " +
           std::to_string(curve.control.size()) + " points.";
}

std::vector<LegendEntry> legend_entries(const PlanarCurve& curve) {
    std::vector<std::size_t> counts(curve.names.size(), 0);
    for (const Symbol symbol : curve.symbols) ++counts[to_index(symbol)];
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0) entries.push_back({to_symbol(i), curve.names[i], counts[i]});
    return entries;
}

} // namespace

std::string curve_picture(const PlanarCurve& curve, const CurvePictureOptions& options) {
    if (curve.symbols.empty()) throw std::invalid_argument("a curve without intervals has no picture");
    const Frame frame = make_frame(curve, options.place);
    std::vector<Point2> pixels;
    pixels.reserve(curve.segments.size());
    for (const Point2& point : curve.segments) pixels.push_back(frame.pixel(point));

    const double legend_top = frame.height + (curve.is_graph ? 10 : 0);
    const Legend legend = picture_legend(legend_entries(curve), picture_width, legend_top);
    std::string text = svg_open({.width = picture_width,
                                 .height = legend_top + legend.height,
                                 .title = options.title,
                                 .description = description(curve),
                                 .generator = options.generator},
                                options.place);
    if (options.place == SvgPlace::File)
        text += "<text" + attribute("x", picture_width / 2) + attribute("y", margin + 8) +
                " font-size=\"18\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"currentColor\">" +
                markup(options.title) + "</text>\n";
    if (curve.is_graph) text += draw_ranges(frame);
    text += draw_polygon("control", curve.control, curve, frame);
    if (!curve.refined.empty() && curve.refined.size() <= many_points)
        text += draw_polygon("refined", curve.refined, curve, frame);
    text += draw_limit(curve, pixels, frame.decimals);
    if (curve.symbols.size() <= many_segments) text += draw_knots(curve, pixels);
    return text + legend.svg + "</svg>\n";
}

} // namespace internode
