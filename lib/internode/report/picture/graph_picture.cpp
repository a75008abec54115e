// SPDX-License-Identifier: MIT
//
// The circle grows until no two boxes touch. An arrow is a quadratic curve whose control point is drawn towards the
// centre, and a little to the left, so that opposite arrows part; both ends lie on the border of their boxes.

#include "internode/report/picture/graph_picture.h"

#include "internode/report/markup.h"
#include "internode/report/picture/graph_dot.h"
#include "internode/report/picture/svg.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace internode {

namespace {

constexpr double letter_width = 9.2; // pixels of a letter of 15 px bold sans, generous
constexpr double node_height = 30;
constexpr double node_padding = 12; // on each side of the word
constexpr double node_gap = 14;     // between two words
constexpr double smallest_radius = 115;
constexpr double margin = 20;
constexpr double title_height = 34;
constexpr double legend_height = 40;
constexpr double loop_reach = 52; // how far a self loop stands out

struct Node {
    Point2 direction; // direction from the centre of the circle, length 1
    Point2 centre;
    double width = 0;
    std::string label;
    bool persistent = false;
    bool has_loop = false;
};

struct Box {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

std::size_t code_points(const std::string& text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::vector<Node> make_nodes(const FactorGraph& graph, const Alphabet& alphabet) {
    assert(graph.arcs.size() == graph.words.size() && graph.persistent.size() == graph.words.size());
    const std::vector<Point2> directions = points_on_circle(graph.words.size());
    std::vector<Node> nodes(graph.words.size());
    for (std::size_t v = 0; v < nodes.size(); ++v) {
        nodes[v].direction = directions[v];
        nodes[v].label = to_string(graph.words[v], alphabet);
        nodes[v].width = letter_width * static_cast<double>(code_points(nodes[v].label)) + 2 * node_padding;
        nodes[v].persistent = graph.persistent[v];
        nodes[v].has_loop = std::ranges::count(graph.arcs[v], static_cast<std::uint32_t>(v)) > 0;
    }
    return nodes;
}

bool touch(const Node& a, const Node& b, double radius) {
    const double dx = std::abs(a.direction.x - b.direction.x) * radius;
    const double dy = std::abs(a.direction.y - b.direction.y) * radius;
    return dx < (a.width + b.width) / 2 + node_gap && dy < node_height + node_gap;
}

double free_radius(const std::vector<Node>& nodes) {
    assert(nodes.size() > 1 && nodes.size() <= max_drawn_words);
    double radius = smallest_radius;
    for (std::size_t a = 1; a < nodes.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            while (touch(nodes[a], nodes[b], radius)) radius += 5;
    return radius;
}

/// Half the distance from a node's centre to the border of its box, seen in a direction.
Point2 border(const Node& node, Point2 towards) {
    const double dx = towards.x - node.centre.x;
    const double dy = towards.y - node.centre.y;
    const double half_width = node.width / 2 + 2;
    const double half_height = node_height / 2 + 2;
    const double scale = std::max({std::abs(dx) / half_width, std::abs(dy) / half_height, 1e-9});
    return {.x = node.centre.x + dx / scale, .y = node.centre.y + dy / scale};
}

/// A quadratic arrow that bows towards the centre (0, 0) and, seen along it, to the left: a pair of opposite arrows
/// does not coincide.
std::string arrow(const Node& from, const Node& to) {
    const Point2 middle{.x = (from.centre.x + to.centre.x) / 2, .y = (from.centre.y + to.centre.y) / 2};
    const double dx = to.centre.x - from.centre.x;
    const double dy = to.centre.y - from.centre.y;
    const double length = std::max(std::sqrt(dx * dx + dy * dy), 1.0);
    const double depth = std::sqrt(middle.x * middle.x + middle.y * middle.y);
    const double inwards = depth < 1 ? 0 : std::min(24 + 0.16 * length, 0.8 * depth) / depth;
    const double aside = 0.09 * length + 4;
    const Point2 control{.x = middle.x * (1 - inwards) + aside * dy / length,
                         .y = middle.y * (1 - inwards) - aside * dx / length};
    std::string path = "M";
    append_point(path, border(from, control));
    path += "Q";
    append_point(path, control);
    path += ' ';
    append_point(path, border(to, control));
    return path;
}

std::string self_loop(const Node& node) {
    const Point2 out = node.direction;
    const Point2 side{.x = -out.y, .y = out.x};
    const Point2 foot = border(node, {.x = node.centre.x + out.x, .y = node.centre.y + out.y});
    const auto place = [&](double outwards, double sideways) {
        return Point2{.x = foot.x + out.x * outwards + side.x * sideways,
                      .y = foot.y + out.y * outwards + side.y * sideways};
    };
    // Both ends lie on the border of the box: the ends of a flat side, slanted where the border is.
    const Point2 start = border(node, place(10, -12));
    const Point2 end = border(node, place(10, 12));
    std::string path = "M";
    append_point(path, start);
    path += "C";
    append_point(path, place(loop_reach, -30));
    path += ' ';
    append_point(path, place(loop_reach, 30));
    path += ' ';
    append_point(path, end);
    return path;
}

std::string draw_arcs(const FactorGraph& graph, const std::vector<Node>& nodes, bool persistent) {
    const char* const look = persistent ? "stroke=\"#0077bb\" marker-end=\"url(#persistent)\""
                                        : "stroke=\"#8a8a8a\" marker-end=\"url(#transient)\"";
    std::string text = "<g fill=\"none\" stroke-width=\"1.4\">\n";
    for (std::size_t v = 0; v < nodes.size(); ++v) {
        if (nodes[v].persistent != persistent) continue;
        for (const CountedArc& arc : counted_arcs(graph.arcs[v])) {
            const std::string path = arc.target == v ? self_loop(nodes[v]) : arrow(nodes[v], nodes[arc.target]);
            text += "<path d=\"" + path + "\" " + look + "/>\n";
        }
    }
    return text + "</g>\n";
}

std::string draw_nodes(const std::vector<Node>& nodes) {
    std::string text = "<g id=\"words\" font-size=\"15\" text-anchor=\"middle\" stroke-width=\"1.6\">\n";
    for (const Node& node : nodes) {
        text += "<rect" + attribute("x", node.centre.x - node.width / 2) +
                attribute("y", node.centre.y - node_height / 2) + attribute("width", node.width) +
                attribute("height", node_height) + " rx=\"15\"";
        text +=
            node.persistent ? " fill=\"#d6ebf8\" stroke=\"#0077bb\"/>\n" : " fill=\"#ffffff\" stroke=\"#8a8a8a\"/>\n";
        text += "<text" + attribute("x", node.centre.x) + attribute("y", node.centre.y + 5.2) +
                (node.persistent ? " fill=\"#004a75\" font-weight=\"bold\" stroke=\"none\">"
                                 : " fill=\"#444444\" stroke=\"none\">") +
                markup(node.label) + "</text>\n";
    }
    return text + "</g>\n";
}

Box bounds(const std::vector<Node>& nodes) {
    Box box;
    for (const Node& node : nodes) {
        const double reach = node.has_loop ? loop_reach : 0;
        const double x = node.centre.x + node.direction.x * reach;
        const double y = node.centre.y + node.direction.y * reach;
        box.left = std::min(box.left, x - node.width / 2);
        box.right = std::max(box.right, x + node.width / 2);
        box.top = std::min(box.top, y - node_height);
        box.bottom = std::max(box.bottom, y + node_height);
    }
    return box;
}

std::string arrow_head(const char* name, const char* colour) {
    return std::string("<marker id=\"") + name +
           "\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">"
           "<path d=\"M0 1L10 5L0 9Z\" fill=\"" +
           colour + "\" stroke=\"none\"/></marker>\n";
}

std::string draw_legend(double width, double y, bool has_transient) {
    std::string text = "<g id=\"legend\" font-size=\"13\">\n";
    double x = width / 2 - (has_transient ? 112 : 52);
    text += "<rect" + attribute("x", x) + attribute("y", y) +
            " width=\"26\" height=\"15\" rx=\"7.5\" fill=\"#d6ebf8\" stroke=\"#0077bb\"/>\n<text" +
            attribute("x", x + 33) + attribute("y", y + 12) + " fill=\"#222222\">persistent</text>\n";
    x += 124;
    if (has_transient)
        text += "<rect" + attribute("x", x) + attribute("y", y) +
                " width=\"26\" height=\"15\" rx=\"7.5\" fill=\"#ffffff\" stroke=\"#8a8a8a\"/>\n<text" +
                attribute("x", x + 33) + attribute("y", y + 12) + " fill=\"#222222\">transient</text>\n";
    return text + "</g>\n";
}

} // namespace

std::string graph_picture(const FactorGraph& graph, const Alphabet& alphabet, const std::string& title,
                          const Generator& generator) {
    if (graph.words.empty()) throw std::invalid_argument("a graph without words has no picture");
    if (graph.words.size() > max_drawn_words)
        throw std::length_error("the graph has " + std::to_string(graph.words.size()) +
                                " words; a picture shows at most " + std::to_string(max_drawn_words) +
                                ": use --dot and Graphviz");
    std::vector<Node> nodes = make_nodes(graph, alphabet);
    const double radius = nodes.size() == 1 ? 0 : free_radius(nodes);
    for (Node& node : nodes) node.centre = {.x = node.direction.x * radius, .y = node.direction.y * radius};
    const Box box = bounds(nodes);
    const double title_width = 9.0 * static_cast<double>(code_points(title)) + 2 * margin;
    const double width = std::max({box.right - box.left + 2 * margin, title_width, 300.0});
    const double height = box.bottom - box.top + 2 * margin + title_height + legend_height;
    const Point2 origin{.x = width / 2 - (box.left + box.right) / 2, .y = margin + title_height - box.top};
    const bool has_transient = !std::ranges::all_of(graph.persistent, [](bool persistent) { return persistent; });

    std::string text =
        svg_open({.width = width,
                  .height = height,
                  .title = title,
                  .description = "Words of the decomposition graph on a circle; persistent ones are blue.",
                  .generator = generator},
                 SvgPlace::File);
    text += "<defs>\n" + arrow_head("persistent", "#0077bb") + arrow_head("transient", "#8a8a8a") + "</defs>\n";
    text += "<text" + attribute("x", width / 2) + attribute("y", margin + 14) +
            " font-size=\"17\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"#222222\">" + markup(title) +
            "</text>\n";
    text += "<g transform=\"translate(" + fixed(origin.x) + " " + fixed(origin.y) + ")\">\n";
    text += draw_arcs(graph, nodes, false) + draw_arcs(graph, nodes, true) + draw_nodes(nodes) + "</g>\n";
    text += draw_legend(width, height - legend_height, has_transient);
    return text + "</svg>\n";
}

} // namespace internode
