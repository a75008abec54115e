// SPDX-License-Identifier: MIT
//
// Pictures whose panels lie over a polygon that they share: the levels of a pyramid, the phases of a reversal.

#include "internode/curve/refinement.h"
#include "internode/report/picture/pyramid_picture.h"
#include "internode/report/picture/reversal_picture.h"
#include "tests/fixtures/random_curve.h"
#include "tests/report/picture/drawn_points.h"
#include "tests/report/systems.h"

namespace internode {
namespace {

using testing_report::dots_of;
using testing_report::expect_drawn;
using testing_report::expect_reading_order;
using testing_report::plane_points;
using testing_report::way_of;
using testing_report::WayToScreen;
using tests::DrawnShape;
using tests::Panel;
using tests::Spot;

/// A closed polygon of random points taken apart by a system that doubles every third step: many levels, few points.
PyramidReport report_of(int levels, std::size_t dimension = 2) {
    const IntervalSystem system = testing_report::system_of(testing_report::slow_growth);
    const Knots knots = *make_knots(system, {2, Ends::Circular, Word(3, to_symbol(0))}).knots;
    tests::Random random(17);
    std::vector<double> fine(refined_size(knots, dimension, static_cast<std::uint64_t>(levels), 100'000).points *
                             dimension);
    for (double& number : fine) number = random.coordinate();
    Analysis analysis = analyse(knots, levels, dimension, fine);
    Pyramid kept = analysis.pyramid;
    return pyramid_report(std::move(analysis), std::move(kept), {}, "polygon.csv");
}

std::vector<Spot> corners_of(const std::vector<Panel>& panels) {
    std::vector<Spot> corners;
    for (const Panel& panel : panels) corners.push_back(panel.corner);
    return corners;
}

/// The same way, from the corner of a panel.
WayToScreen within(WayToScreen way, const Panel& from, const Panel& to) {
    way.x += to.corner.x - from.corner.x;
    way.y += to.corner.y - from.corner.y;
    return way;
}

TEST(PyramidDrawing, PanelsStandInReadingOrderSixteenInFourColumns) {
    for (const auto& [levels, columns] : std::vector<std::pair<int, std::size_t>>{
             {0, 2}, {1, 1}, {2, 2}, {3, 2}, {4, 3}, {8, 3}, {9, 4}, {15, 4}, {16, 6}}) {
        const std::vector<Panel> panels =
            tests::panels_of(tests::read_markup(pyramid_picture(report_of(levels), {"0", "internode"})));
        ASSERT_EQ(panels.size(), static_cast<std::size_t>(levels) + 1);
        expect_reading_order(corners_of(panels), columns, panels[0].width, panels[0].height);
    }
}

TEST(PyramidDrawing, EveryLevelIsItsPolygonOverTheFineOneFinestFirst) {
    constexpr int levels = 9;
    const PyramidReport report = report_of(levels);
    const std::vector<Panel> panels = tests::panels_of(tests::read_markup(pyramid_picture(report, {"0", "internode"})));
    ASSERT_EQ(panels.size(), 10U);
    const std::vector<Point2> fine = plane_points(report.analysis.polygons.back());
    ASSERT_EQ(panels[0].shapes.size(), 1U) << "the fine polygon alone";
    const WayToScreen way = way_of(fine, panels[0].shapes[0].runs[0].points);
    EXPECT_NEAR(way.right, way.up, 0.02 * way.up);
    for (std::size_t place = 0; place < panels.size(); ++place) {
        const std::vector<Point2> polygon = plane_points(report.analysis.polygons[levels - place]);
        const std::vector<DrawnShape>& shapes = panels[place].shapes;
        const WayToScreen here = within(way, panels[0], panels[place]);
        ASSERT_TRUE(shapes[0].used);
        expect_drawn(fine, shapes[0].runs[0].points, here);
        if (place == 0) continue;
        ASSERT_EQ(shapes.size(), 3U);
        EXPECT_TRUE(shapes[1].runs[0].closed);
        expect_drawn(polygon, shapes[1].runs[0].points, here);
        expect_drawn(polygon, dots_of(shapes[2]), here);
    }
}

/// A square of side 1 under a coarse level that reaches beyond its first or last x or y by so much.
TEST(PyramidDrawing, PanelsShowAllLevelsUpToHalfTheFinePolygonBeyondIt) {
    constexpr double border = 0.03;
    const std::vector<double> square{0, 0, 1, 0, 1, 1, 0, 1};
    for (const double reach : {0.0, 0.25, 0.5, 40.0})
        for (const auto& [x, y] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            PyramidReport report = report_of(1);
            report.analysis.polygons = {square, square};
            report.analysis.polygons[0].insert(report.analysis.polygons[0].end(),
                                               {x < 0 ? -reach : 1 + x * reach, y < 0 ? -reach : 1 + y * reach});
            const Panel panel =
                tests::panels_of(tests::read_markup(pyramid_picture(report, {"0", "internode"}))).front();
            const WayToScreen way = way_of(plane_points(square), panel.shapes[0].runs[0].points);
            const double shown = std::min(reach, 0.5);
            EXPECT_NEAR(panel.width / way.right, 1 + 2 * border + (x == 0 ? 0 : shown), 0.01);
            EXPECT_NEAR(panel.height / way.up, 1 + 2 * border + (y == 0 ? 0 : shown), 0.01);
            EXPECT_NEAR((way.x - panel.corner.x) / way.right, border + (x < 0 ? shown : 0), 0.01);
            EXPECT_NEAR((panel.corner.y + panel.height - way.y) / way.up, border + (y < 0 ? shown : 0), 0.01);
        }
}

TEST(PyramidDrawing, LabelsStandBelowTheirPanels) {
    const PyramidReport report = report_of(4);
    const tests::Element root = tests::read_markup(pyramid_picture(report, {"0", "internode"}));
    const std::vector<Panel> panels = tests::panels_of(root);
    std::size_t place = 0;
    for (const DrawnShape& shape : tests::shapes_of(root)) {
        if (shape.name != "text" || !shape.text.starts_with("level ")) continue;
        ASSERT_LT(place, panels.size());
        const std::size_t level = 4 - place;
        EXPECT_EQ(shape.text, "level " + std::to_string(level) + ": " +
                                  std::to_string(report.analysis.polygons[level].size() / 2) + " points");
        EXPECT_NEAR(shape.at.x, panels[place].corner.x + panels[place].width / 2, 0.02);
        EXPECT_GT(shape.at.y, panels[place].corner.y + panels[place].height);
        EXPECT_LT(shape.at.y, panels[place].corner.y + panels[place].height + 22);
        ++place;
    }
    EXPECT_EQ(place, panels.size());
}

ReversalPicture star() {
    ReversalPicture picture;
    picture.original = {0, 0, 6, 0, 8, 4, 3, 9, -1, 5, 2, 3};
    picture.phases = {{0, {6, 0, 3, 9, 2, 3}}, {1, {0, 0, 8, 4, -1, 5}}, {2, {0, 1, 7, 5}}, {3, {1, 1}}};
    return picture;
}

TEST(ReversalDrawing, EveryPhaseIsItsPolygonOverTheOriginal) {
    const ReversalPicture picture = star();
    const std::vector<Panel> panels = tests::panels_of(tests::read_markup(reversal_picture(picture)));
    ASSERT_EQ(panels.size(), 5U);
    expect_reading_order(corners_of(panels), 3, panels[0].width, panels[0].height);
    const std::vector<Point2> original = plane_points(picture.original);
    const WayToScreen way = way_of(original, panels[0].shapes[0].runs[0].points);
    EXPECT_NEAR(way.right, way.up, 0.01 * way.up);
    for (std::size_t place = 0; place < panels.size(); ++place) {
        const Panel& panel = panels[place];
        const WayToScreen here = within(way, panels[0], panel);
        EXPECT_TRUE(panel.shapes[0].used && panel.shapes[0].runs[0].closed);
        expect_drawn(original, panel.shapes[0].runs[0].points, here);
        for (const Spot& spot : panel.shapes[0].runs[0].points) {
            EXPECT_TRUE(panel.corner.x <= spot.x && spot.x <= panel.corner.x + panel.width);
            EXPECT_TRUE(panel.corner.y <= spot.y && spot.y <= panel.corner.y + panel.height);
        }
        ASSERT_EQ(panel.shapes.size(), place == 0 ? 1U : 3U);
        if (place == 0) continue;
        const std::vector<Point2> polygon = plane_points(picture.phases[place - 1].points);
        EXPECT_TRUE(panel.shapes[1].runs[0].closed);
        expect_drawn(polygon, panel.shapes[1].runs[0].points, here);
        expect_drawn(polygon, dots_of(panel.shapes[2]), here);
    }
}

/// A polygon without height fills the width; one without width the height.
TEST(ReversalDrawing, AFlatPolygonFillsItsPanel) {
    ReversalPicture picture;
    for (const bool is_level : {true, false}) {
        picture.original = is_level ? std::vector<double>{0, 5, 0.5, 5, 1, 5} : std::vector<double>{5, 0, 5, 0.5, 5, 1};
        const std::vector<Panel> panels = tests::panels_of(tests::read_markup(reversal_picture(picture)));
        const std::vector<Spot>& spots = panels[0].shapes[0].runs[0].points;
        const double extent = is_level ? spots[2].x - spots[0].x : spots[0].y - spots[2].y;
        EXPECT_GT(extent, 0.9 * (is_level ? panels[0].width : panels[0].height));
    }
}

TEST(ReversalDrawing, NumbersStandOverTheirPlacesInTheRing) {
    ReversalPicture picture;
    picture.dimension = 1;
    picture.original = {1, 2, 5, 3};
    picture.phases = {{0, {2, 4}}};
    const std::vector<Panel> panels = tests::panels_of(tests::read_markup(reversal_picture(picture)));
    const std::vector<Point2> original{{0, 1}, {0.25, 2}, {0.5, 5}, {0.75, 3}};
    const WayToScreen way = way_of(original, panels[0].shapes[0].runs[0].points);
    EXPECT_FALSE(panels[0].shapes[0].runs[0].closed) << "a graph does not close";
    expect_drawn(original, panels[0].shapes[0].runs[0].points, way);
    expect_drawn({{0, 2}, {0.5, 4}}, panels[1].shapes[1].runs[0].points, within(way, panels[0], panels[1]));
}

} // namespace
} // namespace internode
