// SPDX-License-Identifier: MIT

#include "internode/report/page/convergence_plots.h"

#include "internode/report/page/plot.h"
#include "internode/report/text/text_table.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

std::string step_label(const ConvergenceStep& step, const std::string& what) {
    return "step " + std::to_string(step.step) + ", " + std::to_string(step.points) + " points: " + what;
}

/// The line of slope -2 a little below the last error, over the range of the steps.
PlotSeries slope_guide(const Convergence& convergence) {
    constexpr double below = 0.45;
    PlotSeries guide{.name = "slope −2", .style = "guide", .mark = Mark::None, .points = {}, .labels = {}};
    assert(!convergence.steps.empty());
    const ConvergenceStep& last = convergence.steps.back();
    const ConvergenceStep& first = convergence.steps.front();
    if (first.points >= last.points) return guide;
    const double growth = static_cast<double>(last.points) / static_cast<double>(first.points);
    guide.points = {{static_cast<double>(first.points), below * last.error * growth * growth},
                    {static_cast<double>(last.points), below * last.error}};
    return guide;
}

} // namespace

std::string error_plot(const Convergence& convergence) {
    const auto has_error = [](const ConvergenceStep& step) { return step.error > 0; };
    if (std::ranges::none_of(convergence.steps, has_error)) return {};
    PlotSeries error{.name = "error", .style = "error", .mark = Mark::Disc, .points = {}, .labels = {}};
    PlotSeries envelope{.name = "envelope", .style = "envelope", .mark = Mark::Square, .points = {}, .labels = {}};
    for (const ConvergenceStep& step : convergence.steps) {
        const auto points = static_cast<double>(step.points);
        error.points.push_back({points, step.error});
        error.labels.push_back(step_label(step, "error " + rounded(step.error)));
        envelope.points.push_back({points, step.envelope});
        envelope.labels.push_back(step_label(step, "at most " + rounded_up(step.envelope)));
    }
    PlotSeries bisection{.name = "bisection", .style = "bisection", .mark = Mark::Triangle, .points = {}, .labels = {}};
    for (const BisectionStep& step : convergence.bisection) {
        bisection.points.push_back({static_cast<double>(step.points), step.error});
        bisection.labels.push_back("bisected, " + std::to_string(step.points) + " points: error " +
                                   rounded(step.error));
    }
    Plot plot{.title = "Error against the number of points, both logarithmic",
              .x_label = "control points",
              .y_label = "distance from the curve",
              .x_scale = Scale::Logarithmic,
              .y_scale = Scale::Logarithmic,
              .series = {slope_guide(convergence), envelope}};
    if (!bisection.points.empty()) plot.series.push_back(bisection);
    plot.series.push_back(error);
    return plot_svg(plot);
}

std::string ratio_plot(const Convergence& convergence, const std::string& ratio_name) {
    PlotSeries measured{
        .name = "error / error before", .style = "error", .mark = Mark::Disc, .points = {}, .labels = {}};
    for (const ConvergenceStep& step : convergence.steps) {
        if (!step.ratio) continue;
        measured.points.push_back({static_cast<double>(step.step), *step.ratio});
        measured.labels.push_back("step " + std::to_string(step.step) + ": " + rounded(*step.ratio));
    }
    if (measured.points.empty()) return {};
    const double expected = convergence.expected_ratio.to_double();
    const auto last = static_cast<double>(convergence.steps.back().step);
    PlotSeries limit{.name = "1/" + ratio_name + "² = " + rounded(expected),
                     .style = "guide",
                     .mark = Mark::None,
                     .points = {{0, expected}, {last, expected}},
                     .labels = {}};
    return plot_svg({.title = "Ratio of successive errors at each step",
                     .x_label = "step",
                     .y_label = "ratio of errors",
                     .x_scale = Scale::Whole,
                     .y_scale = Scale::Linear,
                     .series = {limit, measured}});
}

} // namespace internode
