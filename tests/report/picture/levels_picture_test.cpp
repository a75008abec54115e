// SPDX-License-Identifier: MIT

#include "internode/report/picture/levels_picture.h"

#include "internode/point/strands.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <regex>
#include <stdexcept>

namespace internode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

PictureLevel level(std::size_t number, const std::vector<double>& points, bool closed) {
    PictureLevel made{.number = number};
    PointStrands& part = made.parts.emplace_back();
    part.dimension = 2;
    part.points = points;
    PointStrands::Strand strand;
    strand.closed = closed;
    for (std::size_t i = 0; i < points.size() / 2; ++i) strand.points.push_back(i);
    if (!points.empty()) part.strands.push_back(strand);
    return made;
}

LevelsPicture picture(std::vector<PictureLevel> levels) {
    return {.levels = std::move(levels), .title = "t", .generator = testing_report::drawer};
}

const std::vector<double> triangle{0, 0, 4, 0, 0, 3};

TEST(LevelsPicture, HasAPanelPerLevelOverTheControlPolygon) {
    const std::string svg = levels_picture(picture({level(0, triangle, true), level(1, triangle, true)}));
    EXPECT_THAT(svg, HasSubstr("level 0: 3 points"));
    EXPECT_THAT(svg, HasSubstr("level 1: 3 points"));
    EXPECT_THAT(svg, HasSubstr("<use href=\"#control\"/>"));
    EXPECT_THAT(levels_picture(picture({level(0, {1, 1}, false)})), HasSubstr("level 0: 1 point<"));
}

TEST(LevelsPicture, ClosesRingsAndNothingElse) {
    EXPECT_THAT(levels_picture(picture({level(0, triangle, true)})), HasSubstr("Z\""));
    EXPECT_THAT(levels_picture(picture({level(0, triangle, false)})), Not(HasSubstr("Z\"")));
}

TEST(LevelsPicture, DrawsTheLinesOfAWordInsteadOfItsStrands) {
    PictureLevel lines = level(0, triangle, true);
    lines.parts[0].lines = {0, 0, 4, 0};
    const std::string svg = levels_picture(picture({lines}));
    EXPECT_THAT(svg, Not(HasSubstr("Z\"")));
    EXPECT_THAT(svg, HasSubstr("3 points, 1 edge<"));
}

TEST(LevelsPicture, ExplainsDotsWhereALevelHasThem) {
    const std::string dot = ">point</text>";
    const std::vector<double> many(2 * 601, 1);
    EXPECT_THAT(levels_picture(picture({level(0, triangle, true), level(1, many, true)})), HasSubstr(dot));
    EXPECT_THAT(levels_picture(picture({level(0, many, true), level(1, triangle, true)})), HasSubstr(dot));
    EXPECT_THAT(levels_picture(picture({level(0, many, true), level(1, many, true)})), Not(HasSubstr(dot)));
}

/// Numbers of all M and L commands stay in their panel.
TEST(LevelsPicture, NothingIsClipped) {
    for (const std::vector<double>& points : {triangle,
                                              std::vector<double>{0, 0, 1e300, -1e300},
                                              {5, 5, 5, 5},
                                              {0, 0, 0, 9},
                                              {0, 0, 9, 0},
                                              {-1e-300, 0, 1e-300, 0}}) {
        for (const std::size_t count : {1U, 2U, 4U, 9U, 12U}) {
            std::vector<PictureLevel> levels;
            for (std::size_t i = 0; i < count; ++i) levels.push_back(level(i, points, true));
            const std::string svg = levels_picture(picture(levels));
            const std::regex command("[ML](-?[0-9.]+) (-?[0-9.]+)");
            for (std::sregex_iterator match(svg.begin(), svg.end(), command), end; match != end; ++match) {
                EXPECT_GE(std::stod((*match)[1]), 0);
                EXPECT_LE(std::stod((*match)[1]), 960);
                EXPECT_GE(std::stod((*match)[2]), 0);
                EXPECT_LE(std::stod((*match)[2]), 560);
            }
            EXPECT_THAT(svg, Not(HasSubstr("nan")));
            EXPECT_THAT(svg, Not(HasSubstr("inf")));
        }
    }
}

TEST(LevelsPicture, DrawsNumbersOverTheirPlace) {
    PictureLevel numbers{.number = 0};
    numbers.parts = {
        {.dimension = 1, .points = {0, 3, 1}, .strands = {{.points = {0, 1, 2}, .closed = true}}, .lines = {}}};
    EXPECT_THAT(levels_picture(picture({numbers})), HasSubstr("level 0: 3 points"));
}

TEST(LevelsPicture, TitlesAreText) {
    LevelsPicture hostile = picture({level(0, triangle, true)});
    hostile.title = "</title><script>";
    EXPECT_THAT(levels_picture(hostile), Not(HasSubstr("<script>")));
}

TEST(LevelsPicture, RefusesWhatCannotBeDrawn) {
    EXPECT_THROW((void)levels_picture(picture({})), std::invalid_argument);
    EXPECT_THROW((void)levels_picture(picture({level(0, {}, false)})), std::invalid_argument);
    EXPECT_THROW((void)levels_picture(picture(std::vector<PictureLevel>(13, level(0, triangle, true)))),
                 std::invalid_argument);
    LevelsPicture axes = picture({level(0, triangle, true)});
    axes.axes.up = 2;
    EXPECT_THROW((void)levels_picture(axes), std::invalid_argument);
}

} // namespace
} // namespace internode
