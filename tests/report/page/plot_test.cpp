// SPDX-License-Identifier: MIT

#include "internode/report/page/plot.h"

#include "tests/report/systems.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using ::testing::HasSubstr;

PlotSeries series_of(std::vector<Point2> points) {
    return {.name = "error", .style = "error", .mark = Mark::Disc, .points = std::move(points), .labels = {"first"}};
}

Plot logarithmic(PlotSeries series) {
    return {.title = "t",
            .x_label = "points",
            .y_label = "error",
            .x_scale = Scale::Logarithmic,
            .y_scale = Scale::Logarithmic,
            .series = {std::move(series)}};
}

TEST(Plot, MarksTellTheirNumbers) {
    const std::string svg = plot_svg(logarithmic(series_of({{10, 1}, {100, 0.01}})));
    EXPECT_THAT(svg, HasSubstr("<title>first</title></circle>"));
    EXPECT_THAT(svg, HasSubstr(">0.01</text>"));
    EXPECT_THAT(svg, HasSubstr(">points</text>"));
}

TEST(Plot, LeavesOutWhatALogarithmCannotShow) {
    EXPECT_EQ(plot_svg(logarithmic(series_of({{10, 0}, {100, 0}}))), "");
    EXPECT_EQ(plot_svg(logarithmic(series_of({}))), "");
    EXPECT_NE(plot_svg(logarithmic(series_of({{10, 0}, {100, 1}}))), "");
}

TEST(Plot, LabelsAreText) {
    PlotSeries series = series_of({{1, 1}, {2, 2}});
    series.name = testing_report::hostile;
    series.labels = {testing_report::hostile, testing_report::hostile};
    Plot plot = logarithmic(series);
    plot.x_label = plot.y_label = plot.title = testing_report::hostile;
    testing_report::expect_inert(plot_svg(plot));
}

} // namespace
} // namespace internode
