// SPDX-License-Identifier: MIT

#include "internode/report/page/convergence_plots.h"
#include "internode/report/page/plot.h"
#include "tests/report/picture/drawn_points.h"
#include "tests/report/systems.h"

#include <charconv>

namespace internode {
namespace {

using testing_report::expect_drawn;
using testing_report::way_of;
using testing_report::WayToScreen;
using tests::DrawnShape;
using tests::Spot;

/// The centres of the marks that have a tooltip, of all series.
std::vector<Spot> discs_of(const std::vector<DrawnShape>& shapes) {
    std::vector<Spot> spots;
    for (const DrawnShape& shape : shapes)
        if (shape.name == "circle") spots.push_back(shape.at);
    return spots;
}

Plot plot_of(std::vector<Point2> points, Scale scale) {
    Plot plot{.title = "t", .x_label = "x", .y_label = "y", .x_scale = scale, .y_scale = scale, .series = {}};
    plot.series.push_back(
        {.name = "", .style = "error", .mark = Mark::Disc, .points = std::move(points), .labels = {}});
    return plot;
}

std::vector<Point2> logarithms(const std::vector<Point2>& points) {
    std::vector<Point2> made;
    for (const Point2& point : points) made.push_back({.x = std::log10(point.x), .y = std::log10(point.y)});
    return made;
}

TEST(PlotDrawing, MarksAndLineStandWhereTheirNumbersSay) {
    const std::vector<Point2> points{{1, 3}, {2, 7}, {4, 1}, {9, 5}};
    for (const Scale scale : {Scale::Linear, Scale::Logarithmic}) {
        const std::vector<DrawnShape> shapes = tests::shapes_of(tests::read_markup(plot_svg(plot_of(points, scale))));
        const std::vector<Point2> expected = scale == Scale::Linear ? points : logarithms(points);
        const std::vector<Spot> discs = discs_of(shapes);
        const WayToScreen way = way_of(expected, discs);
        expect_drawn(expected, discs, way);
        for (const DrawnShape& shape : shapes)
            if (shape.attribute("class") == "line") expect_drawn(expected, shape.runs.at(0).points, way);
    }
}

/// Every tick stands at its number, between the borders of the plot.
TEST(PlotDrawing, TicksStandAtTheirNumbers) {
    const std::vector<Point2> points{{10, 0.5}, {40, 0.25}, {90, 0.75}};
    const std::vector<DrawnShape> shapes =
        tests::shapes_of(tests::read_markup(plot_svg(plot_of(points, Scale::Linear))));
    const WayToScreen way = way_of(points, discs_of(shapes));
    std::size_t ticks = 0;
    for (std::size_t i = 0; i + 1 < shapes.size(); ++i) {
        if (shapes[i].name != "path" || shapes[i].attribute("class") != "grid") continue;
        const std::string& label = shapes[i + 1].text;
        double number = 0;
        ASSERT_EQ(std::from_chars(label.data(), label.data() + label.size(), number).ec, std::errc()) << label;
        const Spot start = shapes[i].runs.at(0).points.front();
        if (shapes[i].runs[0].commands == "V")
            EXPECT_NEAR(start.x, way({number, 0}).x, 0.05) << label;
        else
            EXPECT_NEAR(start.y, way({0, number}).y, 0.05) << label;
        ++ticks;
    }
    EXPECT_GE(ticks, 6U);
}

TEST(PlotDrawing, TheErrorsOfEveryStepAreDiscsOfTheErrorPlot) {
    const IntervalSystem system = testing_report::system_of(testing_report::fibonacci);
    const Curve curve = testing_report::curve_of(system, 3, Ends::Circular);
    ConvergenceOptions options;
    options.steps = 5;
    const Convergence measured = measure_convergence(curve, options);
    std::vector<Point2> expected;
    for (const ConvergenceStep& step : measured.steps)
        expected.push_back({.x = std::log10(static_cast<double>(step.points)), .y = std::log10(step.error)});
    const std::vector<DrawnShape> shapes = tests::shapes_of(tests::read_markup(error_plot(measured)));
    std::vector<Spot> discs;
    for (const DrawnShape& shape : shapes)
        if (shape.name == "circle" && shape.attribute("class") == "error") discs.push_back(shape.at);
    if (!discs.empty() && discs.size() == expected.size() + 1) discs.pop_back(); // the sample in the legend
    expect_drawn(expected, discs, way_of(expected, discs));
}

} // namespace
} // namespace internode
