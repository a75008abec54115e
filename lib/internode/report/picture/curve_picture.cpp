// SPDX-License-Identifier: MIT
//
// Pieces are sorted by symbol without moving their order, so that each symbol is one path whose runs join where its
// pieces do. Everything is written as it is drawn: what is kept is the curve itself and 64 KiB of text.

#include "internode/report/picture/curve_picture.h"

#include "internode/io/file/text_buffer.h"
#include "internode/report/picture/frame.h"
#include "internode/report/picture/marks.h"
#include "internode/report/picture/palette.h"
#include "internode/report/picture/picture_legend.h"
#include "internode/text/diagnostic.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>

namespace internode {

namespace {

constexpr double margin = 28;
constexpr double title_height = 30;
constexpr double remark_height = 24;
constexpr double largest_height = 720;
constexpr double least_height = 40;
constexpr double graph_height = 420;
constexpr std::size_t few_points = 400;     // polygon vertices that are still marked
constexpr std::size_t many_points = 3000;   // beyond, a refined polygon and its curve are one line to the eye
constexpr std::size_t many_segments = 1000; // beyond, marks at the knots would hide the curve
constexpr std::size_t smooth_points = 4000; // points of a polyline that stands for a curve

/// The frame of a curve and where its content ends.
struct Canvas {
    Frame frame;
    double top = 0;    ///< the pixel row where the curve may begin
    double height = 0; ///< down to the margin below the curve
    int decimals = 2;  ///< decimals of the curve's pixels
};

Canvas make_canvas(const PlanarCurve& curve, SvgPlace place) {
    PlaneBox box;
    box.include(curve.control);
    box.include(curve.refined);
    box.include(curve.segments);
    const Point2 size = box.size();
    const Point2 room{.x = picture_width - 2 * margin, .y = curve.is_graph ? graph_height : largest_height};
    const Point2 scale = filling_scale(size, room, curve.is_graph ? Units::Apart : Units::Equal);
    const double content_height = curve.is_graph ? graph_height : std::max(size.y * scale.y, least_height);
    Canvas canvas;
    canvas.top = place == SvgPlace::File ? margin + title_height : margin;
    canvas.height = canvas.top + content_height + margin;
    canvas.frame = {
        .anchor = box.least,
        .at = {.x = (picture_width - size.x * scale.x) / 2, .y = canvas.top + (content_height + size.y * scale.y) / 2},
        .scale = scale};
    canvas.decimals = curve.symbols.size() > many_points ? 2 : 3;
    return canvas;
}

/// Path data of a polygon.
void write_polygon(TextBuffer& out, const std::vector<Point2>& points, bool closed, const Frame& frame) {
    std::string command;
    for (std::size_t k = 0; k < points.size(); ++k) {
        command = k == 0 ? 'M' : 'L';
        append_point(command, frame.pixel(points[k]), 2);
        out << command;
        out.pass_on();
    }
    if (closed) out << 'Z';
}

void draw_polygon(TextBuffer& out, std::string_view name, const std::vector<Point2>& points, const PlanarCurve& curve,
                  const Frame& frame) {
    const bool is_control = name == "control";
    const std::string_view colour = is_control ? "#8c8c8c" : "#b9b9b9";
    out << "<g id=\"" << name << "\">\n<path fill=\"none\" stroke=\"" << colour
        << "\" stroke-linejoin=\"round\" stroke-width=\"" << (points.size() > few_points ? "0.7" : "1") << "\" d=\"";
    write_polygon(out, points, curve.closed, frame);
    out << "\"/>\n";
    if (points.size() <= few_points) {
        std::vector<Point2> pixels;
        for (const Point2& point : points) pixels.push_back(frame.pixel(point));
        out << dots(pixels, colour, is_control ? 5 : 3);
    }
    out << "</g>\n";
}

/// A Bézier curve, rational when it has weights.
struct Piece {
    std::span<const Point2> points;
    std::span<const double> weights; ///< none, or one per point
};

/// A point of a Bézier curve, by de Casteljau; with weights every step is a convex combination too (Farin).
Point2 bezier_point(const Piece& piece, double t) {
    assert(!piece.points.empty() && (piece.weights.empty() || piece.weights.size() == piece.points.size()));
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
    assert(piece.points.size() >= 2 && chords > 0);
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

/// The pieces of each symbol in their order: those of symbol i stand from first[i] up to first[i + 1].
struct PiecesBySymbol {
    std::vector<std::size_t> first;
    std::vector<std::size_t> pieces;
};

PiecesBySymbol pieces_by_symbol(const PlanarCurve& curve) {
    PiecesBySymbol sorted;
    sorted.first.assign(curve.names.size() + 1, 0);
    for (const Symbol symbol : curve.symbols) {
        assert(to_index(symbol) < curve.names.size());
        ++sorted.first[to_index(symbol) + 1];
    }
    std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
    sorted.pieces.resize(curve.symbols.size());
    std::vector<std::size_t> next = sorted.first;
    for (std::size_t k = 0; k < curve.symbols.size(); ++k) sorted.pieces[next[to_index(curve.symbols[k])]++] = k;
    return sorted;
}

/// The pieces of the limit curve in pixels, one after the other in any order.
class Pieces {
public:
    Pieces(const PlanarCurve& curve, const Canvas& canvas)
        : curve_(curve)
        , canvas_(canvas)
        , size_(static_cast<std::size_t>(curve.degree) + 1) {
        assert(!curve.symbols.empty());
        const std::size_t most = curve.weights.empty() ? 16 : 64; // chords: a rational piece may turn by half a circle
        chords_ = std::clamp<std::size_t>(smooth_points / curve.symbols.size(), 2, most);
        assert(curve.segments.size() == size_ * curve.symbols.size());
    }

    /// The first point of piece k, and the last one of the curve for k = their number.
    [[nodiscard]] Point2 start(std::size_t k) const {
        return canvas_.frame.pixel(k < curve_.symbols.size() ? curve_.segments[k * size_] : curve_.segments.back());
    }

    /// The commands of piece k; one that goes on where the last one of its symbol ended needs no start of its own.
    [[nodiscard]] std::string commands(std::size_t k) {
        assert(k < curve_.symbols.size());
        pixels_.clear();
        for (std::size_t b = 0; b < size_; ++b) pixels_.push_back(canvas_.frame.pixel(curve_.segments[k * size_ + b]));
        Piece piece{pixels_, {}};
        if (!curve_.weights.empty()) piece.weights = std::span<const double>(curve_.weights).subspan(k * size_, size_);
        std::string begin;
        append_point(begin, pixels_.front(), canvas_.decimals);
        std::string end_before;
        if (k > 0 && curve_.symbols[k - 1] == curve_.symbols[k])
            append_point(end_before, canvas_.frame.pixel(curve_.segments[k * size_ - 1]), canvas_.decimals);
        std::string path = begin != end_before ? "M" + begin : std::string();
        append_segment(path, piece, chords_, canvas_.decimals);
        return path;
    }

private:
    const PlanarCurve& curve_;
    const Canvas& canvas_;
    std::size_t size_;   ///< Bézier points of a piece
    std::size_t chords_; ///< chords of a piece that has no command in SVG
    std::vector<Point2> pixels_;
};

/// One path per symbol.
void draw_limit(TextBuffer& out, const PlanarCurve& curve, Pieces& pieces) {
    const PiecesBySymbol sorted = pieces_by_symbol(curve);
    out << "<g id=\"limit\" fill=\"none\" stroke-linejoin=\"round\" stroke-width=\""
        << (curve.symbols.size() > many_points ? "1.3" : "2.4") << "\">\n";
    for (std::size_t i = 0; i < curve.names.size(); ++i) {
        if (sorted.first[i] == sorted.first[i + 1]) continue;
        out << "<path" << symbol_stroke(to_symbol(i)) << " d=\"";
        for (std::size_t at = sorted.first[i]; at < sorted.first[i + 1]; ++at) {
            out << pieces.commands(sorted.pieces[at]);
            out.pass_on();
        }
        out << "\"/>\n";
    }
    out << "</g>\n";
}

void draw_knots(TextBuffer& out, const PlanarCurve& curve, const Pieces& pieces) {
    std::vector<Point2> marks;
    const std::size_t knots = curve.symbols.size() + (curve.closed ? 0 : 1);
    for (std::size_t k = 0; k < knots; ++k) marks.push_back(pieces.start(k));
    const double diameter = curve.symbols.size() > 200 ? 3 : 5;
    out << "<g id=\"knots\">\n"
        << dots(marks, "#222222", diameter) << dots(marks, "#ffffff", diameter - 1.8) << "</g>\n";
}

/// The range of the values and of the parameter, at the edges of a graph.
std::string draw_ranges(const Canvas& canvas) {
    const double left = margin;
    const double right = picture_width - margin;
    const double bottom = canvas.height - margin;
    return "<g id=\"axes\" stroke=\"#b9b9b9\" stroke-width=\"1\"><path d=\"M" + fixed(left - 8) + " " +
           fixed(canvas.top) + "V" + fixed(bottom + 8) + "H" + fixed(right) + "\" fill=\"none\"/></g>\n<text" +
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

void write_curve_picture(Sink& sink, const PlanarCurve& curve, const CurvePictureOptions& options) {
    if (curve.symbols.empty()) throw std::invalid_argument("a curve without intervals has no picture");
    const Canvas canvas = make_canvas(curve, options.place);
    const double legend_top = canvas.height + (curve.is_graph ? 10 : 0);
    const Legend legend = picture_legend(legend_entries(curve), picture_width, legend_top);
    const double remark_top = legend_top + legend.height;
    TextBuffer out(sink);
    out << svg_open({.width = picture_width,
                     .height = remark_top + (options.remark.empty() ? 0 : remark_height),
                     .title = options.title,
                     .description = description(curve),
                     .generator = options.generator},
                    options.place);
    if (options.place == SvgPlace::File) out << title_text(options.title, {.x = picture_width / 2, .y = margin + 8});
    if (curve.is_graph) out << draw_ranges(canvas);
    draw_polygon(out, "control", curve.control, curve, canvas.frame);
    if (!curve.refined.empty() && curve.refined.size() <= many_points)
        draw_polygon(out, "refined", curve.refined, curve, canvas.frame);
    Pieces pieces(curve, canvas);
    draw_limit(out, curve, pieces);
    if (curve.symbols.size() <= many_segments) draw_knots(out, curve, pieces);
    out << legend.svg;
    if (!options.remark.empty()) out << caption(options.remark, {.x = picture_width / 2, .y = remark_top + 4});
    out << "</svg>\n";
    out.flush();
}

std::string curve_picture(const PlanarCurve& curve, const CurvePictureOptions& options) {
    StringSink sink;
    write_curve_picture(sink, curve, options);
    return sink.text();
}

} // namespace internode
