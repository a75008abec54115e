// SPDX-License-Identifier: MIT

#include "internode/report/picture/curve_picture.h"

#include "tests/report/picture/planar.h"
#include "tests/report/systems.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <regex>

namespace internode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing_report::curve_of;
using testing_report::planar_of;
using testing_report::system_of;

std::string limit_layer(const std::string& svg) {
    const std::size_t start = svg.find("<g id=\"limit\"");
    return svg.substr(start, svg.find("</g>", start) - start);
}

TEST(CurvePicture, DrawsEveryIntervalAsOneExactSegmentUpToDegreeThree) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    for (int degree = 1; degree <= 3; ++degree) {
        const PlanarCurve planar = planar_of(curve_of(system, degree, Ends::Circular), 3);
        const std::string layer =
            limit_layer(curve_picture(planar, {.title = "t", .generator = testing_report::drawer}));
        const char command = std::string("LQC")[static_cast<std::size_t>(degree) - 1];
        std::size_t count = 0;
        const std::regex data(" d=\"([^\"]*)\"");
        for (std::sregex_iterator match(layer.begin(), layer.end(), data), end; match != end; ++match) {
            const std::string path = (*match)[1];
            count += static_cast<std::size_t>(std::ranges::count(path, command));
        }
        EXPECT_EQ(count, planar.symbols.size());
    }
}

TEST(CurvePicture, SegmentsJoin) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    for (const Ends ends : {Ends::Open, Ends::Circular}) {
        const PlanarCurve planar = planar_of(curve_of(system, 3, ends), 2);
        ASSERT_EQ(planar.segments.size(), 4 * planar.symbols.size());
        for (std::size_t k = 1; k < planar.symbols.size(); ++k) {
            EXPECT_NEAR(planar.segments[4 * k].x, planar.segments[4 * k - 1].x, 1e-12);
            EXPECT_NEAR(planar.segments[4 * k].y, planar.segments[4 * k - 1].y, 1e-12);
        }
    }
}

TEST(CurvePicture, NothingIsClipped) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    for (const int degree : {2, 5}) {
        const std::string svg = curve_picture(planar_of(curve_of(system, degree, Ends::Open), 2),
                                              {.title = "t", .generator = testing_report::drawer});
        std::smatch box;
        ASSERT_TRUE(std::regex_search(svg, box, std::regex("viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"")));
        const double width = std::stod(box[1]);
        const double height = std::stod(box[2]);
        const std::regex point("[MLQC ]([-0-9.]+) ([-0-9.]+)");
        const std::string layer = limit_layer(svg);
        for (std::sregex_iterator match(layer.begin(), layer.end(), point), end; match != end; ++match) {
            EXPECT_TRUE(std::stod((*match)[1]) >= 0 && std::stod((*match)[1]) <= width);
            EXPECT_TRUE(std::stod((*match)[2]) >= 0 && std::stod((*match)[2]) <= height);
        }
    }
}

TEST(CurvePicture, ADimensionOneCurveIsAGraphOverItsParameter) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    const PlanarCurve planar = planar_of(curve_of(system, 2, Ends::Open, 1), 1);
    EXPECT_TRUE(planar.is_graph);
    for (std::size_t i = 1; i < planar.segments.size(); ++i)
        EXPECT_GE(planar.segments[i].x, planar.segments[i - 1].x - 1e-12);
    EXPECT_THAT(curve_picture(planar, {.title = "t", .generator = testing_report::drawer}), HasSubstr("parameter"));
}

TEST(CurvePicture, StepZeroHasNoRefinedPolygon) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    const Curve curve = curve_of(system, 3, Ends::Circular);
    EXPECT_THAT(curve_picture(planar_of(curve, 0), {.title = "t", .generator = testing_report::drawer}),
                Not(HasSubstr("id=\"refined\"")));
    EXPECT_THAT(curve_picture(planar_of(curve, 1), {.title = "t", .generator = testing_report::drawer}),
                HasSubstr("id=\"refined\""));
}

TEST(CurvePicture, OnePathPerSymbolHoweverManyIntervals) {
    const IntervalSystem system = system_of(testing_report::fibonacci);
    const PlanarCurve planar = planar_of(curve_of(system, 3, Ends::Circular), 12);
    ASSERT_GT(planar.symbols.size(), 2000U);
    const std::string svg = curve_picture(planar, {.title = "t", .generator = testing_report::drawer});
    const std::string layer = limit_layer(svg);
    std::size_t paths = 0;
    for (std::size_t at = 0; (at = layer.find("<path", at)) != std::string::npos; ++at) ++paths;
    EXPECT_EQ(paths, 2U);
    EXPECT_LT(svg.size(), 90 * planar.symbols.size());
}

TEST(CurvePicture, DrawsPointsAndHugeNumbersToo) {
    const IntervalSystem system = system_of("A -> A A");
    for (const double size : {0.0, 1e-320, 1e308}) {
        CurveData data;
        data.degree = 2;
        data.ends = Ends::Circular;
        data.word = Word(3, to_symbol(0));
        data.points = {-size, 0, size, size, 0, -size};
        const std::string svg = curve_picture(planar_of(make_curve(system, data).curve.value(), 1),
                                              {.title = "t", .generator = testing_report::drawer});
        EXPECT_THAT(svg, Not(HasSubstr("nan")));
        EXPECT_THAT(svg, Not(HasSubstr("inf\"")));
    }
}

TEST(CurvePicture, RefusesAxesThatThePointsDoNotHave) {
    const Curve curve = curve_of(system_of(testing_report::fibonacci), 2, Ends::Open);
    EXPECT_THROW((void)planar_of(curve, 0, {.right = 0, .up = 2}), std::invalid_argument);
    EXPECT_NO_THROW((void)planar_of(curve, 0, {.right = 1, .up = 0}));
    EXPECT_THROW((void)curve_picture({}, {.title = "t", .generator = testing_report::drawer}), std::invalid_argument);
}

TEST(CurvePicture, NamesAreText) {
    const IntervalSystem system = validate(testing_report::hostile_grammar()).system.value();
    const PlanarCurve planar = planar_of(curve_of(system, 3, Ends::Circular), 1);
    testing_report::expect_inert(
        curve_picture(planar, {.title = testing_report::hostile, .generator = {"0", testing_report::hostile}}));
}

} // namespace
} // namespace internode
