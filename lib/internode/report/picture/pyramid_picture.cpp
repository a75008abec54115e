// SPDX-License-Identifier: MIT

#include "internode/report/picture/pyramid_picture.h"

#include "internode/curve/parameter.h"
#include "internode/curve/refinement.h"
#include "internode/report/picture/marks.h"
#include "internode/report/picture/panels.h"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

namespace internode {

namespace {

/// The levels as plane polygons: two coordinates, or numbers over their Greville abscissae.
std::vector<std::vector<Point2>> plane_polygons(const PyramidReport& report) {
    const std::size_t dimension = report.kept.coarse.dimension();
    std::vector<std::vector<Point2>> polygons;
    for (std::size_t level = 0; level < report.analysis.polygons.size(); ++level) {
        const std::vector<double>& points = report.analysis.polygons[level];
        std::vector<Point2>& polygon = polygons.emplace_back();
        if (dimension > 1) {
            for (std::size_t row = 0; row < points.size(); row += dimension)
                polygon.push_back({.x = points[row], .y = points[row + 1]});
            continue;
        }
        const Knots knots = refined_knots(report.kept.coarse.knots(), static_cast<int>(level));
        const CheckedCurve curve = make_curve(knots, 1, points);
        const std::vector<double> abscissae = curve.curve ? greville_abscissae(*curve.curve) : std::vector<double>();
        for (std::size_t i = 0; i < abscissae.size(); ++i) polygon.push_back({.x = abscissae[i], .y = points[i]});
    }
    return polygons;
}

/// Around all levels, though not around what noise blew up: half the size of the fine polygon beyond it at most.
PlaneBox box_of(const std::vector<std::vector<Point2>>& polygons) {
    assert(!polygons.empty());
    constexpr double border = 0.03; // part of the size, for lines and marks at the edge
    PlaneBox fine;
    fine.include(polygons.back());
    PlaneBox box = fine;
    for (const std::vector<Point2>& polygon : polygons) box.include(polygon);
    const Point2 size = fine.size();
    const auto low = [](double all, double own, double extent) {
        return std::max(all, own - extent / 2) - border * extent;
    };
    const auto high = [](double all, double own, double extent) {
        return std::min(all, own + extent / 2) + border * extent;
    };
    box.least = {.x = low(box.least.x, fine.least.x, size.x), .y = low(box.least.y, fine.least.y, size.y)};
    box.greatest = {.x = high(box.greatest.x, fine.greatest.x, size.x),
                    .y = high(box.greatest.y, fine.greatest.y, size.y)};
    return box;
}

std::size_t columns_for(std::size_t panels) {
    if (panels <= 4) return std::max<std::size_t>(panels, 2) / 2 + panels % 2;
    if (panels <= 9) return 3;
    return panels <= 16 ? 4 : 6;
}

PanelGrid grid_for(std::size_t panels, const PlaneBox& box, bool is_graph) {
    const std::size_t columns = columns_for(panels);
    const double width = panel_width(columns);
    const double height = panel_height(width, box.size(), is_graph);
    const Point2 scale = filling_scale(box.size(), {.x = width, .y = height}, is_graph ? Units::Apart : Units::Equal);
    return panel_grid(columns, height, box, scale);
}

std::string level_label(std::size_t level, std::size_t points) {
    return fmt::format("level {}: {} {}", level, points, points == 1 ? "point" : "points");
}

std::string title_of(const PyramidReport& report) {
    const Curve& coarse = report.kept.coarse;
    const std::string& name = coarse.system().grammar().name;
    return fmt::format("{} taken apart by {}, degree {}", report.source, name.empty() ? "a grammar" : name,
                       coarse.degree());
}

} // namespace

std::string pyramid_picture(const PyramidReport& report, const Generator& generator) {
    const std::vector<std::vector<Point2>> polygons = plane_polygons(report);
    assert(!polygons.empty() && "the coarse polygon at least");
    const bool is_graph = report.kept.coarse.dimension() == 1;
    const bool closed = report.kept.coarse.ends() == Ends::Circular && !is_graph;
    const PanelGrid grid = grid_for(polygons.size(), box_of(polygons), is_graph);
    std::string text = svg_open({.width = picture_width,
                                 .height = grid.bottom(polygons.size()),
                                 .title = title_of(report),
                                 .description = "The polygon at every level, finest first, over the fine polygon.",
                                 .generator = generator},
                                SvgPlace::File);
    text += shared_polygon("fine", grid.path(polygons.back(), closed));
    text += title_text(title_of(report), {.x = picture_width / 2, .y = 28});
    constexpr std::size_t few_points = 150; // vertices that are still marked
    for (std::size_t place = 0; place < polygons.size(); ++place) {
        const std::size_t level = polygons.size() - 1 - place;
        const std::vector<Point2>& polygon = polygons[level];
        const std::string drawn = place == 0 ? std::string() : marked_polygon(grid, polygon, closed, few_points);
        text += cut_panel(grid, place, "fine", drawn, level_label(level, polygon.size()));
    }
    return text + "</svg>\n";
}

} // namespace internode
