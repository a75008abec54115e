// SPDX-License-Identifier: MIT

#include "internode/report/page/plot.h"

#include "internode/algebra/logarithm.h"
#include "internode/report/markup.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace internode {

namespace {

constexpr double plot_width = 520;
constexpr double plot_height = 370;
constexpr double left = 66;
constexpr double right = 18;
constexpr double top = 60; // the legend stands here, in up to two rows
constexpr double bottom = 50;

struct Axis {
    Scale scale = Scale::Linear;
    double least = std::numeric_limits<double>::max(); ///< transformed
    double greatest = std::numeric_limits<double>::lowest();
    double first_pixel = 0;
    double last_pixel = 0;

    [[nodiscard]] bool shows(double value) const { return scale != Scale::Logarithmic || value > 0; }
    [[nodiscard]] double transformed(double value) const {
        assert(shows(value));
        return scale == Scale::Logarithmic ? decimal_logarithm(value) : value;
    }
    void include(double value) {
        least = std::min(least, transformed(value));
        greatest = std::max(greatest, transformed(value));
    }
    /// Some room on both sides, and an extent where there is none.
    void pad() {
        const double room = greatest > least ? 0.05 * (greatest - least) : 0.5;
        least -= room;
        greatest += room;
    }
    /// Of a transformed value.
    [[nodiscard]] double place(double transform) const {
        assert(least < greatest);
        return first_pixel + (transform - least) / (greatest - least) * (last_pixel - first_pixel);
    }
    [[nodiscard]] double pixel(double value) const { return place(transformed(value)); }
};

struct Axes {
    Axis x;
    Axis y;
};

std::vector<Point2> shown_points(const PlotSeries& series, const Axes& axes) {
    std::vector<Point2> points;
    for (const Point2& point : series.points)
        if (axes.x.shows(point.x) && axes.y.shows(point.y)) points.push_back(point);
    return points;
}

Axes make_axes(const Plot& plot) {
    Axes axes;
    axes.x.scale = plot.x_scale;
    axes.y.scale = plot.y_scale;
    for (const PlotSeries& series : plot.series) {
        for (const Point2& point : shown_points(series, axes)) {
            axes.x.include(point.x);
            axes.y.include(point.y);
        }
    }
    if (axes.x.least > axes.x.greatest) return axes;
    axes.x.pad();
    axes.y.pad();
    axes.x.first_pixel = left;
    axes.x.last_pixel = plot_width - right;
    axes.y.first_pixel = plot_height - bottom;
    axes.y.last_pixel = top;
    return axes;
}

std::string draw_axes(const Axes& axes, const Plot& plot) {
    std::string text = "<g class=\"grid\" font-size=\"12\">\n";
    for (const Tick& tick : axis_ticks(axes.x.least, axes.x.greatest, axes.x.scale)) {
        const double x = axes.x.place(tick.place);
        text += "<path d=\"M" + fixed(x) + " " + fixed(top) + "V" + fixed(plot_height - bottom) + "\"/><text" +
                attribute("x", x) + attribute("y", plot_height - bottom + 18) + " text-anchor=\"middle\">" +
                tick.label + "</text>\n";
    }
    for (const Tick& tick : axis_ticks(axes.y.least, axes.y.greatest, axes.y.scale)) {
        const double y = axes.y.place(tick.place);
        text += "<path d=\"M" + fixed(left) + " " + fixed(y) + "H" + fixed(plot_width - right) + "\"/><text" +
                attribute("x", left - 8) + attribute("y", y + 4) + " text-anchor=\"end\">" + tick.label + "</text>\n";
    }
    text += "<text" + attribute("x", (left + plot_width - right) / 2) + attribute("y", plot_height - 10) +
            " font-size=\"13\" text-anchor=\"middle\">" + markup(plot.x_label) + "</text>\n";
    const double middle = (top + plot_height - bottom) / 2;
    text += "<text transform=\"translate(16 " + fixed(middle) +
            ") rotate(-90)\" font-size=\"13\" text-anchor=\"middle\">" + markup(plot.y_label) + "</text>\n";
    return text + "</g>\n";
}

std::string draw_mark(Mark mark, Point2 at) {
    switch (mark) {
    case Mark::Disc:
        return "<circle" + attribute("cx", at.x) + attribute("cy", at.y) + " r=\"4\"";
    case Mark::Square:
        return "<rect" + attribute("x", at.x - 3.5) + attribute("y", at.y - 3.5) + " width=\"7\" height=\"7\"";
    case Mark::Triangle:
        return "<path d=\"M" + fixed(at.x) + " " + fixed(at.y - 5) + "l5 8.5h-10z\"";
    case Mark::None:
        break;
    }
    return {};
}

std::string_view closing(Mark mark) {
    switch (mark) {
    case Mark::Disc:
        return "</circle>\n";
    case Mark::Square:
        return "</rect>\n";
    case Mark::Triangle:
        return "</path>\n";
    case Mark::None:
        break;
    }
    return {};
}

std::string draw_series(const PlotSeries& series, const Axes& axes) {
    std::string line;
    std::string marks;
    for (std::size_t k = 0; k < series.points.size(); ++k) {
        const Point2 point = series.points[k];
        if (!axes.x.shows(point.x) || !axes.y.shows(point.y)) continue;
        const Point2 pixel{.x = axes.x.pixel(point.x), .y = axes.y.pixel(point.y)};
        line += line.empty() ? 'M' : 'L';
        append_point(line, pixel);
        if (series.mark == Mark::None) continue;
        marks += draw_mark(series.mark, pixel);
        marks += k < series.labels.size()
                     ? "><title>" + markup(series.labels[k]) + "</title>" + std::string(closing(series.mark))
                     : std::string("/>\n");
    }
    return "<g class=\"" + series.style + "\"><path class=\"line\" d=\"" + line + "\"/>\n" + marks + "</g>\n";
}

std::string draw_legend(const Plot& plot) {
    std::string text = "<g font-size=\"13\">\n";
    double x = left;
    double y = 16;
    for (const PlotSeries& series : plot.series) {
        if (series.name.empty()) continue;
        const double width = 36 + 7.2 * static_cast<double>(series.name.size());
        if (x + width > plot_width) {
            x = left;
            y += 22;
        }
        text += "<g class=\"" + series.style + "\"><path class=\"line\" d=\"M" + fixed(x) + " " + fixed(y) + "h28\"/>";
        if (series.mark != Mark::None) text += draw_mark(series.mark, {.x = x + 14, .y = y}) + "/>";
        text += "</g><text" + attribute("x", x + 36) + attribute("y", y + 4.5) + " fill=\"currentColor\">" +
                markup(series.name) + "</text>\n";
        x += width + 22;
    }
    return text + "</g>\n";
}

} // namespace

std::string plot_svg(const Plot& plot) {
    assert(!plot.series.empty());
    const Axes axes = make_axes(plot);
    if (axes.x.least > axes.x.greatest) return {};
    std::string text =
        svg_open({.width = plot_width, .height = plot_height, .title = plot.title, .description = {}, .generator = {}},
                 SvgPlace::Page);
    text += draw_axes(axes, plot);
    for (const PlotSeries& series : plot.series) text += draw_series(series, axes);
    return text + draw_legend(plot) + "</svg>\n";
}

} // namespace internode
