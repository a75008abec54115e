// SPDX-License-Identifier: MIT
//
// Places come from the layout in units; a unit becomes as many pixels as fit, and below a least size the picture grows.
// Contexts are painted first, then successors, then the words over the ends of all arrows.

#include "internode/report/picture/derivation_tree.h"

#include "internode/report/markup.h"
#include "internode/report/picture/palette.h"
#include "internode/report/picture/svg.h"
#include "internode/report/picture/tree_layout.h"
#include "internode/text/diagnostic.h"
#include "internode/text/number.h"
#include "internode/text/printable.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

constexpr double least_width = 960;
constexpr double side = 24;
constexpr double row_name_width = 92;
constexpr double title_height = 52;
constexpr double row_height = 70;
constexpr double seam_room = 12; // pixels for arrows that come in from the side
constexpr double legend_height = 46;
constexpr double widest_unit = 84;    // pixels of a module
constexpr double narrowest_unit = 12; // below, the picture grows
constexpr double labelled_unit = 40;  // from here on numbers are written beside their module
constexpr std::size_t most_looks = 12;

/// What a module looks like: its letter, and for a point with a state the state too.
struct Look {
    Symbol letter{};
    std::string label;
    bool is_edge = false;
};

bool is_mark(std::string_view name) {
    return name == "#" || name == "[" || name == "]";
}

/// "x", "y", "z", "x4", …
std::string number_name(std::size_t index) {
    return index < 3 ? std::string(1, "xyz"[index]) : "x" + std::to_string(index + 1);
}

class Painter {
public:
    Painter(const DerivationTree& tree, const PointSystem& system)
        : tree_(tree)
        , system_(system)
        , strict_(strict_sizes(tree.steps, system.grammar())) {
        std::vector<std::size_t> sizes;
        for (const ModuleWord& word : tree.words) sizes.push_back(word.size());
        layout_ = tree_layout(sizes, tree.steps, strict_);
        unit_ = std::clamp((least_width - row_name_width - 2 * side) / std::max(layout_.width, 1.0), narrowest_unit,
                           widest_unit);
        radius_ = std::min(6.5, unit_ * 0.3);
        width_ = std::max(least_width, row_name_width + 2 * side + layout_.width * unit_);
        left_ = row_name_width + (width_ - row_name_width - layout_.width * unit_) / 2;
    }

    std::string paint();

private:
    [[nodiscard]] static double line_of(std::size_t row) {
        return title_height + 20 + static_cast<double>(row) * row_height;
    }
    [[nodiscard]] Point2 place(std::size_t row, std::size_t module) const {
        return {.x = left_ + layout_.centre[row][module] * unit_, .y = line_of(row)};
    }
    [[nodiscard]] bool is_edge(std::size_t row, std::size_t module) const {
        return tree_.words[row].values(module).empty();
    }
    [[nodiscard]] std::string_view name(std::size_t row, std::size_t module) const {
        return letter_text(system_.grammar(), tree_.words[row].letter(module));
    }
    [[nodiscard]] bool has_point(std::size_t row, std::size_t module) const;
    [[nodiscard]] std::string module_text(std::size_t row, std::size_t module) const;
    std::size_t look_of(std::size_t row, std::size_t module);
    [[nodiscard]] std::string look_label(std::size_t row, std::size_t module) const;
    [[nodiscard]] Point2 toward(Point2 from, Point2 to) const;
    [[nodiscard]] std::string arrow(Point2 from, Point2 to, bool dashed) const;
    [[nodiscard]] std::string arrows(std::size_t row, bool dashed) const;
    [[nodiscard]] std::string context_arrow(std::size_t row, std::size_t read, std::size_t child) const;
    [[nodiscard]] std::string edge_line(std::size_t row, std::size_t module, std::string_view colour) const;
    std::string module_mark(std::size_t row, std::size_t module);
    std::string paint_row(std::size_t index);
    [[nodiscard]] std::string legend(double top) const;

    const DerivationTree& tree_;
    const PointSystem& system_;
    StrictSizes strict_;
    TreeLayout layout_;
    double unit_ = 0;
    double radius_ = 0;
    double width_ = 0;
    double left_ = 0;
    std::vector<Look> looks_;
};

bool Painter::has_point(std::size_t row, std::size_t module) const {
    const auto& layout = system_.layout()[to_index(tree_.words[row].letter(module))];
    return layout && std::ranges::any_of(*layout, [](Extent extent) { return extent > 0; });
}

std::string Painter::module_text(std::size_t row, std::size_t module) const {
    ModuleWord alone;
    alone.push_back(tree_.words[row].letter(module), tree_.words[row].values(module));
    return to_string(alone, system_.grammar(), system_.layout());
}

/// "P(v, 2)" for a point with a number, "A(x, y)" for numbers alone, "E" for a module without parameters.
std::string Painter::look_label(std::size_t row, std::size_t module) const {
    const auto& layout = system_.layout()[to_index(tree_.words[row].letter(module))];
    std::string label(name(row, module));
    if (!layout || layout->empty()) return label;
    const bool is_point = has_point(row, module);
    std::size_t value = 0;
    std::string arguments;
    for (const Extent extent : *layout) {
        if (!arguments.empty()) arguments += ", ";
        if (extent > 0)
            arguments += "v";
        else
            arguments += is_point ? to_string(tree_.words[row].values(module)[value]) : number_name(value);
        value += std::max<std::size_t>(extent, 1);
    }
    return label + "(" + arguments + ")";
}

std::size_t Painter::look_of(std::size_t row, std::size_t module) {
    std::string label = look_label(row, module);
    const auto found = std::ranges::find(looks_, label, &Look::label);
    if (found != looks_.end()) return static_cast<std::size_t>(found - looks_.begin());
    if (looks_.size() == most_looks) return most_looks - 1;
    looks_.push_back({tree_.words[row].letter(module), std::move(label), is_edge(row, module)});
    return looks_.size() - 1;
}

/// Where an arrow from `from` ends at the mark around `to`.
Point2 Painter::toward(Point2 from, Point2 to) const {
    const Point2 way{.x = to.x - from.x, .y = to.y - from.y};
    const double length = std::max(std::abs(way.x), std::abs(way.y));
    const double part = 1 - std::min(0.5, (radius_ + 3) / std::max(length, 1.0));
    return {.x = from.x + part * way.x, .y = from.y + part * way.y};
}

std::string Painter::arrow(Point2 from, Point2 to, bool dashed) const {
    std::string text = "<path d=\"M";
    append_point(text, toward(to, from));
    text += 'L';
    append_point(text, toward(from, to));
    return text + (dashed ? "\" class=\"context\"/>\n" : "\"/>\n");
}

/// Across the seam of a ring the arrow is cut: its last part, from the side that the context is on.
std::string Painter::context_arrow(std::size_t row, std::size_t read, std::size_t child) const {
    assert(read < tree_.words[row].size() && child < tree_.words[row + 1].size());
    const Point2 from = place(row, read);
    const Point2 to = place(row + 1, child);
    const double around = layout_.width * unit_;
    if (!system_.grammar().ring || std::abs(from.x - to.x) <= around / 2) return arrow(from, to, true);
    const Point2 turned{.x = from.x + (from.x > to.x ? -around : around), .y = from.y};
    const double border = turned.x < to.x ? left_ - seam_room : left_ + around + seam_room;
    const double part = std::clamp((border - to.x) / (turned.x - to.x), 0.1, 0.6);
    const Point2 middle{.x = to.x + (turned.x - to.x) * part, .y = to.y + (turned.y - to.y) * part};
    return arrow(middle, to, true);
}

std::string Painter::arrows(std::size_t row, bool dashed) const {
    const StepRecord& step = tree_.steps[row];
    assert(step.read.size() == step.parent.size() && step.parent.size() == tree_.words[row + 1].size());
    std::string text;
    for (std::size_t child = 0; child < step.parent.size(); ++child) {
        if (dashed) {
            for (const std::size_t read : step.read[child])
                if (!is_edge(row, read)) text += context_arrow(row, read, child); // an edge has nothing to tell
            continue;
        }
        const std::size_t size = tree_.words[row].size();
        for (std::size_t i = 0; i < strict_[row][child]; ++i)
            text += arrow(place(row, (step.parent[child] + i) % size), place(row + 1, child), false);
    }
    return text;
}

/// From mark to mark, as an edge of a polygon.
std::string Painter::edge_line(std::size_t row, std::size_t module, std::string_view colour) const {
    const Point2 centre = place(row, module);
    const std::size_t size = tree_.words[row].size();
    double from = centre.x - 0.42 * unit_;
    double to = centre.x + 0.42 * unit_;
    if (module > 0 && !is_edge(row, module - 1)) from = std::min(from, place(row, module - 1).x + radius_ + 2);
    if (module + 1 < size && !is_edge(row, module + 1)) to = std::max(to, place(row, module + 1).x - radius_ - 2);
    return "<path d=\"M" + fixed(from) + " " + fixed(centre.y) + "H" + fixed(to) + "\" stroke=\"" +
           std::string(colour) + "\" stroke-width=\"2.4\" fill=\"none\"/>\n";
}

std::string Painter::module_mark(std::size_t row, std::size_t module) {
    const Point2 centre = place(row, module);
    if (is_mark(name(row, module)))
        return "<text" + attribute("x", centre.x) + attribute("y", centre.y + 4.5) +
               " font-size=\"13\" text-anchor=\"middle\" fill=\"currentColor\">" + markup(name(row, module)) +
               "</text>\n";
    const SymbolStyle style = symbol_style(to_symbol(look_of(row, module)));
    if (is_edge(row, module)) return edge_line(row, module, style.colour);
    const std::string said = module_text(row, module);
    std::string text = "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius_) +
                       " fill=\"" + std::string(style.colour) + "\"><title>" + markup(printable(said)) +
                       "</title></circle>\n";
    if (unit_ >= labelled_unit && !has_point(row, module))
        text +=
            "<text" + attribute("x", centre.x + radius_ + 3) + attribute("y", centre.y + 4) +
            " font-size=\"11\" fill=\"currentColor\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\">" +
            markup(printable(said)) + "</text>\n";
    return text;
}

std::string Painter::paint_row(std::size_t index) {
    assert(index < tree_.words.size());
    std::string text = "<g>\n<text" + attribute("x", side) + attribute("y", line_of(index) + 4.5) +
                       " font-size=\"12\" fill=\"currentColor\">" + markup(printable(tree_.row_names[index])) +
                       "</text>\n";
    for (std::size_t module = 0; module < tree_.words[index].size(); ++module) text += module_mark(index, module);
    return text + "</g>\n";
}

std::string Painter::legend(double top) const {
    std::string text = "<g id=\"legend\" font-size=\"12\" fill=\"currentColor\">\n";
    double x = side;
    const auto entry = [&](const std::string& sample, const std::string& label) {
        text += "<g transform=\"translate(" + fixed(x) + " " + fixed(top) + ")\">" + sample +
                "<text x=\"30\" y=\"4\">" + markup(printable(label)) + "</text></g>\n";
        x += 52 + 7.0 * static_cast<double>(label.size());
    };
    for (std::size_t i = 0; i < looks_.size(); ++i) {
        const std::string colour(symbol_style(to_symbol(i)).colour);
        entry(looks_[i].is_edge ? "<path d=\"M0 0H24\" stroke-width=\"2.4\" stroke=\"" + colour + "\"/>"
                                : "<circle cx=\"12\" cy=\"0\" r=\"5\" fill=\"" + colour + "\"/>",
              looks_[i].label);
    }
    entry("<path d=\"M0 0H24\" stroke=\"#222222\"/>", "successor");
    entry("<path d=\"M0 0H24\" stroke=\"#777777\" stroke-dasharray=\"4 3\"/>", "read as context");
    return text + "</g>\n";
}

std::string Painter::paint() {
    const double height = line_of(tree_.words.size() - 1) + 24 + legend_height;
    std::string text = svg_open({.width = width_,
                                 .height = height,
                                 .title = tree_.title,
                                 .description = "A row per word; solid arrows from predecessor to successor, dashed "
                                                "ones from contexts.",
                                 .generator = tree_.generator},
                                SvgPlace::File);
    text += "<defs><marker id=\"head\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"6\" markerHeight=\"6\" "
            "orient=\"auto\"><path d=\"M0 0.5L8 4L0 7.5Z\" fill=\"#222222\"/></marker></defs>\n<text" +
            attribute("x", width_ / 2) + attribute("y", 30) +
            " font-size=\"18\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"currentColor\">" +
            markup(printable(tree_.title)) + "</text>\n";
    const std::string heads = " fill=\"none\" marker-end=\"url(#head)\">\n";
    text += "<g id=\"contexts\" stroke=\"#777777\" stroke-width=\"0.8\" stroke-dasharray=\"4 3\"" + heads;
    for (std::size_t step = 0; step < tree_.steps.size(); ++step) text += arrows(step, true);
    text += "</g>\n<g id=\"successors\" stroke=\"#222222\" stroke-width=\"1\"" + heads;
    for (std::size_t step = 0; step < tree_.steps.size(); ++step) text += arrows(step, false);
    text += "</g>\n";
    for (std::size_t index = 0; index < tree_.words.size(); ++index) text += paint_row(index);
    return text + legend(height - 22) + "</svg>\n";
}

} // namespace

bool fits_in_tree(const std::vector<ModuleWord>& words) {
    std::size_t total = 0;
    for (const ModuleWord& word : words) {
        if (word.size() > max_tree_row) return false;
        total += word.size();
    }
    return total <= max_tree_modules;
}

std::string derivation_tree(const DerivationTree& tree, const PointSystem& system) {
    if (tree.words.empty() || tree.steps.size() + 1 != tree.words.size() || tree.row_names.size() != tree.words.size())
        throw std::invalid_argument("derivation_tree: numbers of words, steps and names disagree");
    if (!fits_in_tree(tree.words)) throw std::invalid_argument("derivation_tree: too many modules");
    return Painter(tree, system).paint();
}

} // namespace internode
