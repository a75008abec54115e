// SPDX-License-Identifier: MIT
//
// Pieces are sorted by symbol without moving their order, so that each symbol is one path whose runs join where its
// pieces do. Everything is written as it is drawn: what is kept is the curves themselves and 64 KiB of text. Every
// layer is one path, or one a symbol, with a run for each curve.

#include "internode/report/picture/curve_picture.h"

#include "internode/io/file/text_buffer.h"
#include "internode/report/picture/frame.h"
#include "internode/report/picture/marks.h"
#include "internode/report/picture/palette.h"
#include "internode/report/picture/picture_legend.h"
#include "internode/text/diagnostic.h"

#include <algorithm>
#include <cassert>
#include <map>
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

using Curves = std::span<const PlanarCurve>;

/// Knot intervals of all curves.
std::size_t interval_count(Curves curves) {
    std::size_t count = 0;
    for (const PlanarCurve& curve : curves) count += curve.symbols.size();
    return count;
}

/// The polygon of each curve that a layer shows.
using Polygon = std::vector<Point2> PlanarCurve::*;

std::size_t point_count(Curves curves, Polygon polygon) {
    std::size_t count = 0;
    for (const PlanarCurve& curve : curves) count += (curve.*polygon).size();
    return count;
}

/// The frame of the curves and where their content ends.
struct Canvas {
    Frame frame;
    double top = 0;         ///< the pixel row where the curves may begin
    double height = 0;      ///< down to the margin below the curves
    int decimals = 2;       ///< decimals of the curves' pixels
    std::size_t pieces = 0; ///< knot intervals of all curves
};

Canvas make_canvas(Curves curves, SvgPlace place) {
    PlaneBox box;
    for (const PlanarCurve& curve : curves) {
        box.include(curve.control);
        box.include(curve.refined);
        box.include(curve.segments);
    }
    const bool is_graph = curves.front().is_graph;
    const Point2 size = box.size();
    const Point2 room{.x = picture_width - 2 * margin, .y = is_graph ? graph_height : largest_height};
    const Point2 scale = filling_scale(size, room, is_graph ? Units::Apart : Units::Equal);
    const double content_height = is_graph ? graph_height : std::max(size.y * scale.y, least_height);
    Canvas canvas;
    canvas.top = place == SvgPlace::File ? margin + title_height : margin;
    canvas.height = canvas.top + content_height + margin;
    canvas.frame = {
        .anchor = box.least,
        .at = {.x = (picture_width - size.x * scale.x) / 2, .y = canvas.top + (content_height + size.y * scale.y) / 2},
        .scale = scale};
    canvas.pieces = interval_count(curves);
    canvas.decimals = canvas.pieces > many_points ? 2 : 3;
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

/// A layer: the polygon of each curve a run of one path, their vertices marked where they are few.
void draw_polygons(TextBuffer& out, std::string_view name, Curves curves, Polygon polygon, const Frame& frame) {
    const bool is_control = name == "control";
    const std::string_view colour = is_control ? "#8c8c8c" : "#b9b9b9";
    const std::size_t count = point_count(curves, polygon);
    out << "<g id=\"" << name << "\">\n<path fill=\"none\" stroke=\"" << colour
        << "\" stroke-linejoin=\"round\" stroke-width=\"" << (count > few_points ? "0.7" : "1") << "\" d=\"";
    for (const PlanarCurve& curve : curves)
        if (!(curve.*polygon).empty()) write_polygon(out, curve.*polygon, curve.closed, frame);
    out << "\"/>\n";
    if (count <= few_points) {
        std::vector<Point2> pixels;
        for (const PlanarCurve& curve : curves)
            for (const Point2& point : curve.*polygon) pixels.push_back(frame.pixel(point));
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

/// The pieces of a limit curve in pixels, one after the other in any order.
class Pieces {
public:
    Pieces(const PlanarCurve& curve, const Canvas& canvas)
        : curve_(curve)
        , canvas_(canvas)
        , sorted_(pieces_by_symbol(curve))
        , size_(static_cast<std::size_t>(curve.degree) + 1) {
        assert(!curve.symbols.empty());
        const std::size_t most = curve.weights.empty() ? 16 : 64; // chords: a rational piece may turn by half a circle
        chords_ = std::clamp<std::size_t>(smooth_points / canvas.pieces, 2, most);
        assert(curve.segments.size() == size_ * curve.symbols.size());
    }

    [[nodiscard]] const PlanarCurve& curve() const { return curve_; }
    /// Those of a symbol, in their order.
    [[nodiscard]] std::span<const std::size_t> of(Symbol symbol) const {
        const std::size_t first = sorted_.first[to_index(symbol)];
        return std::span(sorted_.pieces).subspan(first, sorted_.first[to_index(symbol) + 1] - first);
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
    PiecesBySymbol sorted_;
    std::size_t size_;   ///< Bézier points of a piece
    std::size_t chords_; ///< chords of a piece that has no command in SVG
    std::vector<Point2> pixels_;
};

/// A symbol of the picture, which stands for those of its name in each curve.
struct SharedSymbol {
    std::string name;
    std::size_t intervals = 0;
    std::vector<std::pair<std::size_t, Symbol>> places; ///< curves that have it, and what it is there
};

/// The symbols of all curves by their names, in the order in which they come.
std::vector<SharedSymbol> shared_symbols(std::span<const Pieces> curves) {
    std::vector<SharedSymbol> symbols;
    std::map<std::string_view, std::size_t> known;
    for (std::size_t at = 0; at < curves.size(); ++at) {
        const std::vector<std::string>& names = curves[at].curve().names;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto [place, is_new] = known.emplace(names[i], symbols.size());
            if (is_new) symbols.push_back({.name = names[i], .intervals = 0, .places = {}});
            const std::size_t count = curves[at].of(to_symbol(i)).size();
            symbols[place->second].intervals += count;
            if (count > 0) symbols[place->second].places.emplace_back(at, to_symbol(i));
        }
    }
    return symbols;
}

/// One path per symbol.
void draw_limit(TextBuffer& out, std::span<Pieces> curves, const std::vector<SharedSymbol>& symbols,
                std::size_t count) {
    out << "<g id=\"limit\" fill=\"none\" stroke-linejoin=\"round\" stroke-width=\""
        << (count > many_points ? "1.3" : "2.4") << "\">\n";
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        if (symbols[i].places.empty()) continue;
        out << "<path" << symbol_stroke(to_symbol(i)) << " d=\"";
        for (const auto& [at, symbol] : symbols[i].places)
            for (const std::size_t piece : curves[at].of(symbol)) {
                out << curves[at].commands(piece);
                out.pass_on();
            }
        out << "\"/>\n";
    }
    out << "</g>\n";
}

void draw_knots(TextBuffer& out, std::span<const Pieces> curves, std::size_t count) {
    std::vector<Point2> marks;
    for (const Pieces& pieces : curves) {
        const std::size_t knots = pieces.curve().symbols.size() + (pieces.curve().closed ? 0 : 1);
        for (std::size_t k = 0; k < knots; ++k) marks.push_back(pieces.start(k));
    }
    const double diameter = count > 200 ? 3 : 5;
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

std::string description(Curves curves, std::size_t intervals) {
    const std::string rest =
        std::to_string(intervals) + " knot intervals, each drawn in the colour and dashes of its symbol, and ";
    const std::string points = std::to_string(point_count(curves, &PlanarCurve::control)) + " points.";
    if (curves.size() == 1)
        return "A curve of degree " + std::to_string(curves.front().degree) + " with " + rest +
               "the control polygon of " + points;
    return std::to_string(curves.size()) + " curves with " + rest + "their control polygons of " + points;
}

std::vector<LegendEntry> legend_entries(const std::vector<SharedSymbol>& symbols) {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < symbols.size(); ++i)
        if (symbols[i].intervals > 0) entries.push_back({to_symbol(i), symbols[i].name, symbols[i].intervals});
    return entries;
}

void require_drawable(Curves curves) {
    if (curves.empty()) throw std::invalid_argument("no curve, no picture");
    for (const PlanarCurve& curve : curves) {
        if (curve.symbols.empty()) throw std::invalid_argument("a curve without intervals has no picture");
        if (curve.is_graph != curves.front().is_graph)
            throw std::invalid_argument("functions and curves of the plane have no picture together");
    }
}

void draw_curves(TextBuffer& out, Curves curves, std::span<Pieces> pieces, const std::vector<SharedSymbol>& symbols,
                 const Canvas& canvas) {
    if (curves.front().is_graph) out << draw_ranges(canvas);
    draw_polygons(out, "control", curves, &PlanarCurve::control, canvas.frame);
    const std::size_t refined = point_count(curves, &PlanarCurve::refined);
    if (refined > 0 && refined <= many_points)
        draw_polygons(out, "refined", curves, &PlanarCurve::refined, canvas.frame);
    draw_limit(out, pieces, symbols, canvas.pieces);
    if (canvas.pieces <= many_segments) draw_knots(out, pieces, canvas.pieces);
}

} // namespace

void write_curve_picture(Sink& sink, std::span<const PlanarCurve> curves, const CurvePictureOptions& options) {
    require_drawable(curves);
    const Canvas canvas = make_canvas(curves, options.place);
    std::vector<Pieces> pieces;
    pieces.reserve(curves.size());
    for (const PlanarCurve& curve : curves) pieces.emplace_back(curve, canvas);
    const std::vector<SharedSymbol> symbols = shared_symbols(pieces);
    const double legend_top = canvas.height + (curves.front().is_graph ? 10 : 0);
    const Legend legend = picture_legend(legend_entries(symbols), picture_width, legend_top);
    const double remark_top = legend_top + legend.height;
    TextBuffer out(sink);
    out << svg_open({.width = picture_width,
                     .height = remark_top + (options.remark.empty() ? 0 : remark_height),
                     .title = options.title,
                     .description = description(curves, canvas.pieces),
                     .generator = options.generator},
                    options.place);
    if (options.place == SvgPlace::File) out << title_text(options.title, {.x = picture_width / 2, .y = margin + 8});
    draw_curves(out, curves, pieces, symbols, canvas);
    out << legend.svg;
    if (!options.remark.empty()) out << caption(options.remark, {.x = picture_width / 2, .y = remark_top + 4});
    out << "</svg>\n";
    out.flush();
}

std::string curve_picture(const PlanarCurve& curve, const CurvePictureOptions& options) {
    StringSink sink;
    write_curve_picture(sink, std::span(&curve, 1), options);
    return sink.text();
}

} // namespace internode
