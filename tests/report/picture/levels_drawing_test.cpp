// SPDX-License-Identifier: MIT

#include "internode/report/picture/levels_picture.h"
#include "tests/report/picture/drawn_points.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing_report::dots_of;
using testing_report::expect_drawn;
using testing_report::expect_near;
using testing_report::expect_reading_order;
using testing_report::plane_points;
using testing_report::way_of;
using testing_report::WayToScreen;
using tests::DrawnShape;
using tests::Spot;

const std::vector<double> house{0, 0, 4, 0, 4, 3, 2, 5, 0, 3}; // its roof is on top

PictureLevel house_level(std::size_t number, const std::vector<double>& points, bool closed = true) {
    PictureLevel made{.number = number};
    PointStrands& part = made.parts.emplace_back();
    part.dimension = 2;
    part.points = points;
    PointStrands::Strand strand{.points = {}, .closed = closed};
    for (std::size_t i = 0; i < points.size() / 2; ++i) strand.points.push_back(i);
    part.strands.push_back(strand);
    return made;
}

std::vector<double> moved(std::vector<double> points, double right, double up) {
    for (std::size_t i = 0; i < points.size(); i += 2) {
        points[i] += right;
        points[i + 1] += up;
    }
    return points;
}

std::vector<DrawnShape> drawn(const LevelsPicture& picture) {
    return tests::shapes_of(tests::read_markup(levels_picture(picture)));
}

std::string id_of(std::size_t number) {
    return "level-" + std::to_string(number);
}

/// The path of a level's own lines.
DrawnShape lines_of(const std::vector<DrawnShape>& panel) {
    for (const DrawnShape& shape : panel)
        if (shape.name == "path" && !shape.used) return shape;
    ADD_FAILURE() << "no lines";
    return {};
}

TEST(LevelsDrawing, EveryPolygonStandsUprightInOneScaleInItsPanel) {
    LevelsPicture picture;
    for (std::size_t k = 0; k < 3; ++k)
        picture.levels.push_back(
            house_level(k, moved(house, static_cast<double>(k), 2 - static_cast<double>(k)), k != 1));
    const std::vector<DrawnShape> shapes = drawn(picture);
    WayToScreen first;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<DrawnShape> panel = shapes_in(shapes, id_of(k));
        const DrawnShape lines = lines_of(panel);
        ASSERT_EQ(lines.runs.size(), 1U);
        EXPECT_EQ(lines.runs[0].closed, k != 1);
        const std::vector<Point2> points = plane_points(picture.levels[k].parts[0].points);
        const WayToScreen way = way_of(points, lines.runs[0].points);
        EXPECT_NEAR(way.right, way.up, 0.01) << "one unit in both directions";
        expect_drawn(points, lines.runs[0].points, way);
        expect_drawn(points, dots_of(panel[k == 0 ? 1 : 2]), way);
        if (k == 0) first = way;
        EXPECT_NEAR(way.right, first.right, 0.01) << "one scale in all panels";
    }
}

TEST(LevelsDrawing, PanelsStandInReadingOrderAndHoldTheirPoints) {
    for (const auto& [count, columns] : std::vector<std::pair<std::size_t, std::size_t>>{
             {1, 1}, {2, 2}, {3, 3}, {4, 2}, {5, 3}, {9, 3}, {10, 4}, {12, 4}}) {
        LevelsPicture picture;
        for (std::size_t k = 0; k < count; ++k) picture.levels.push_back(house_level(k, house));
        const std::vector<DrawnShape> shapes = drawn(picture);
        std::vector<Spot> corners;
        double width = 0;
        double height = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const std::vector<DrawnShape> panel = shapes_in(shapes, id_of(k));
            const DrawnShape& caption = panel.back();
            const DrawnShape lines = lines_of(panel);
            const Spot corner = lines.at;
            ASSERT_EQ(caption.name, "text");
            EXPECT_EQ(caption.text.substr(0, caption.text.find(':')), "level " + std::to_string(k));
            corners.push_back(corner);
            width = 2 * (caption.at.x - corner.x);
            height = caption.at.y - corner.y - 16;
            for (const Spot& spot : lines.runs.at(0).points) {
                EXPECT_TRUE(corner.x < spot.x && spot.x < corner.x + width);
                EXPECT_TRUE(corner.y < spot.y && spot.y < corner.y + height);
            }
        }
        expect_reading_order(corners, columns, width, height);
    }
}

TEST(LevelsDrawing, TheFirstLevelLiesInGreyUnderTheOthers) {
    LevelsPicture picture;
    picture.levels = {house_level(0, house), house_level(1, moved(house, 1, 1)), house_level(2, moved(house, 0, 1))};
    const std::vector<DrawnShape> shapes = drawn(picture);
    const DrawnShape own = lines_of(shapes_in(shapes, id_of(0)));
    EXPECT_FALSE(shapes_in(shapes, id_of(0)).front().used);
    for (std::size_t k = 1; k < 3; ++k) {
        const std::vector<DrawnShape> panel = shapes_in(shapes, id_of(k));
        ASSERT_TRUE(panel.front().used);
        EXPECT_EQ(panel.front().attribute("stroke"), "#a8a8a8");
        ASSERT_EQ(panel.front().runs.size(), 1U);
        for (std::size_t i = 0; i < 5; ++i)
            expect_near({panel.front().runs[0].points[i].x - panel.front().at.x,
                         panel.front().runs[0].points[i].y - panel.front().at.y},
                        {own.runs[0].points[i].x - own.at.x, own.runs[0].points[i].y - own.at.y});
    }
}

TEST(LevelsDrawing, LinesOfAWordAreDrawnOneByOneInsteadOfTheStrands) {
    LevelsPicture picture;
    picture.levels = {house_level(3, house)};
    picture.levels[0].parts[0].lines = {0, 0, 4, 3, 2, 5, 0, 1};
    const std::vector<DrawnShape> panel = shapes_in(drawn(picture), id_of(3));
    const WayToScreen way = way_of(plane_points(house), dots_of(panel[1]));
    const std::vector<Point2> ends = plane_points(picture.levels[0].parts[0].lines);
    const DrawnShape lines = lines_of(panel);
    ASSERT_EQ(lines.runs.size(), 2U);
    for (std::size_t line = 0; line < 2; ++line) {
        EXPECT_FALSE(lines.runs[line].closed);
        expect_drawn({ends[2 * line], ends[2 * line + 1]}, lines.runs[line].points, way);
    }
}

TEST(LevelsDrawing, EveryStrandIsAPolygonOfItsOwnAndAxesAreChosen) {
    LevelsPicture picture;
    picture.axes = {.right = 2, .up = 0};
    PictureLevel strands{.number = 0};
    strands.parts = {{.dimension = 3,
                      .points = {0, 9, 1, 2, 9, 5, 7, 9, 3, 4, 9, 4, 1, 9, 2},
                      .strands = {{.points = {0, 1, 2}, .closed = true}, {.points = {4, 3}, .closed = false}},
                      .lines = {}}};
    picture.levels = {strands};
    const std::vector<DrawnShape> panel = shapes_in(drawn(picture), id_of(0));
    const std::vector<Point2> points{{1, 0}, {5, 2}, {3, 7}, {4, 4}, {2, 1}};
    const WayToScreen way = way_of(points, dots_of(panel[1]));
    const DrawnShape lines = lines_of(panel);
    ASSERT_EQ(lines.runs.size(), 2U);
    EXPECT_TRUE(lines.runs[0].closed);
    EXPECT_FALSE(lines.runs[1].closed);
    expect_drawn({points[0], points[1], points[2]}, lines.runs[0].points, way);
    expect_drawn({points[4], points[3]}, lines.runs[1].points, way);
}

TEST(LevelsDrawing, NumbersStandOverTheirPlacesAtEqualSteps) {
    LevelsPicture picture;
    PictureLevel numbers{.number = 0};
    numbers.parts = {
        {.dimension = 1, .points = {0, 3, 1, 8}, .strands = {{.points = {0, 1, 2, 3}, .closed = false}}, .lines = {}}};
    picture.levels = {numbers};
    const DrawnShape lines = lines_of(shapes_in(drawn(picture), id_of(0)));
    const std::vector<Point2> points{{0, 0}, {1, 3}, {2, 1}, {3, 8}};
    expect_drawn(points, lines.runs[0].points, way_of(points, lines.runs[0].points));
}

TEST(LevelsDrawing, SeveralPolygonsStandTogetherEachWithItsStrandsOrItsLines) {
    LevelsPicture picture;
    PictureLevel several = house_level(0, house);
    several.parts.push_back(house_level(0, moved(house, 7, -2), false).parts[0]);
    several.parts.push_back(house_level(0, moved(house, 3, 9)).parts[0]);
    several.parts[2].lines = {0, 12, 4, 12};
    several.parts.emplace_back(); // a word without points
    picture.levels = {several};
    const std::vector<DrawnShape> panel = shapes_in(drawn(picture), id_of(0));
    std::vector<Point2> points = plane_points(house);
    for (const auto& more : {moved(house, 7, -2), moved(house, 3, 9)}) {
        const std::vector<Point2> next = plane_points(more);
        points.insert(points.end(), next.begin(), next.end());
    }
    const WayToScreen way = way_of(points, dots_of(panel[1]));
    expect_drawn(points, dots_of(panel[1]), way);
    const DrawnShape lines = lines_of(panel);
    ASSERT_EQ(lines.runs.size(), 3U);
    EXPECT_TRUE(lines.runs[0].closed);
    EXPECT_FALSE(lines.runs[1].closed);
    expect_drawn(plane_points(house), lines.runs[0].points, way);
    expect_drawn(plane_points(moved(house, 7, -2)), lines.runs[1].points, way);
    expect_drawn({{0, 12}, {4, 12}}, lines.runs[2].points, way);
    EXPECT_EQ(panel.back().text, "level 0: 15 points, 1 edge in 4 parts");
}

TEST(LevelsDrawing, DotsEndWhereTheyWouldHideTheLines) {
    for (const std::size_t count : {600U, 601U}) {
        std::vector<double> points;
        for (std::size_t i = 0; i < count; ++i) {
            points.push_back(static_cast<double>(i));
            points.push_back(static_cast<double>(i % 7));
        }
        LevelsPicture picture;
        picture.levels.push_back(house_level(0, points, false));
        std::size_t dots = 0;
        for (const DrawnShape& shape : shapes_in(drawn(picture), id_of(0)))
            if (!shape.runs.empty() && shape.runs.front().commands == "h") dots += dots_of(shape).size();
        EXPECT_EQ(dots, count == 600 ? count : 0U);
    }
}

TEST(LevelsDrawing, RefusesNumbersBesidePoints) {
    LevelsPicture picture;
    picture.levels = {house_level(0, house)};
    picture.levels[0].parts.push_back({.dimension = 1, .points = {1, 2}, .strands = {}, .lines = {}});
    EXPECT_THROW((void)levels_picture(picture), std::invalid_argument);
}

} // namespace
} // namespace internode
