// SPDX-License-Identifier: MIT
//
// A plot for a page: series of points over linear or logarithmic axes, as inline SVG. The page's style sheet colours it
// (classes error, envelope, bisection, guide). It needs no script: a mark tells its numbers as a tooltip.

#pragma once

#include "internode/report/page/axis_ticks.h"
#include "internode/report/picture/svg.h"

#include <string>
#include <vector>

namespace internode {

enum class Mark { None, Disc, Square, Triangle };

struct PlotSeries {
    std::string name;                ///< the series in the legend; empty: not there
    std::string style;               ///< a class of the page's style sheet
    Mark mark = Mark::Disc;          ///< None: the line alone
    std::vector<Point2> points;      ///< left to right; what a logarithmic axis cannot show is left out
    std::vector<std::string> labels; ///< tooltip of each point; may be empty
};

struct Plot {
    std::string title; ///< the plot in words, for readers who do not see it
    std::string x_label;
    std::string y_label;
    Scale x_scale = Scale::Linear;
    Scale y_scale = Scale::Linear;
    std::vector<PlotSeries> series;
};

/// An <svg> element; empty when nothing can be shown.
[[nodiscard]] std::string plot_svg(const Plot& plot);

} // namespace internode
