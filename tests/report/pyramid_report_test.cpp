// SPDX-License-Identifier: MIT

#include "internode/report/pyramid_report.h"

#include "internode/curve/refinement.h"
#include "internode/report/json/pyramid_json.h"
#include "internode/report/picture/pyramid_picture.h"
#include "internode/report/text/pyramid_text.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/random_curve.h"

#include <gmock/gmock.h>

#include <sstream>

namespace internode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tests::Random;
using tests::random_curve;
using tests::Shape;

PyramidReport report_of(Shape shape, std::size_t dimension, std::size_t kept_details, const Fitting& fitting = {}) {
    Random random(3);
    const Curve coarse = random_curve(random, tests::fibonacci(), 3, shape, 6, dimension);
    std::vector<double> fine(refined_size(coarse, 4, 100'000).points * dimension);
    for (double& coordinate : fine) coordinate = random.coordinate();
    Analysis analysis = analyse(coarse.knots(), 4, dimension, fine);
    Pyramid kept = with_longest(analysis.pyramid, kept_details);
    return pyramid_report(std::move(analysis), std::move(kept), fitting, "<leaf>.csv");
}

TEST(PyramidReport, SaysHowThePolygonWasMadeToFit) {
    EXPECT_THAT(pyramid_text(report_of(Shape::Closed, 2, 5, {Fit::AsMeasured, 20, 20, {}})),
                HasSubstr("20 points, as measured"));
    EXPECT_THAT(pyramid_text(report_of(Shape::Closed, 2, 5, {Fit::Cut, 23, 20, {}})),
                HasSubstr("23 points, the last 3 cut off: 20"));
    EXPECT_THAT(pyramid_text(report_of(Shape::Closed, 2, 5, {Fit::Resampled, 1, 20, Spacing::Index})),
                HasSubstr("1 point, resampled to 20 at equal steps of the index"));
    const std::string json =
        pyramid_json(report_of(Shape::Closed, 2, 5, {Fit::Resampled, 23, 20, Spacing::ChordLength}), {"0", "x"});
    EXPECT_THAT(json, HasSubstr(R"("change": "resampled", "spacing": "chord-length")"));
}

TEST(PyramidReport, ListsEveryLevelFromThePolygonDown) {
    const PyramidReport report = report_of(Shape::Closed, 2, 5);
    std::istringstream lines(pyramid_text(report));
    std::string line;
    while (std::getline(lines, line) && !line.starts_with("  level")) {
    }
    for (std::size_t level = 5; level-- > 0;) {
        std::size_t line_level = 0;
        std::size_t points = 0;
        lines >> line_level >> points;
        EXPECT_EQ(line_level, level);
        EXPECT_EQ(points, report.analysis.polygons[level].size() / 2);
        std::getline(lines, line);
    }
    EXPECT_TRUE(std::getline(lines, line) && line.empty());
}

TEST(PyramidReport, WarnsOfLooseEndsWithTheirGain) {
    EXPECT_EQ(loose_ends_warning(report_of(Shape::Closed, 2, 5)), "");
    EXPECT_EQ(loose_ends_warning(report_of(Shape::Clamped, 2, 5)), "");
    Random random(4);
    const Curve coarse = random_curve(random, tests::fibonacci(), 5, Shape::Open, 6, 1);
    std::vector<double> fine(refined_size(coarse, 5, 100'000).points);
    for (double& coordinate : fine) coordinate = random.coordinate();
    Analysis analysis = analyse(coarse.knots(), 5, 1, fine);
    Pyramid kept = analysis.pyramid;
    EXPECT_THAT(loose_ends_warning(pyramid_report(std::move(analysis), std::move(kept), {}, "")), HasSubstr("G = "));
}

TEST(PyramidReport, DoesNotWarnOfLooseEndsOfAPolygonThatWasRefined) {
    Random random(4);
    const Curve coarse = random_curve(random, tests::fibonacci(), 3, Shape::Open, 6, 1);
    ASSERT_TRUE(has_loose_ends(coarse.knots()));
    Analysis analysis = analyse(coarse.knots(), 2, 1, refine(coarse, 2).points());
    Pyramid kept = analysis.pyramid;
    EXPECT_EQ(loose_ends_warning(pyramid_report(std::move(analysis), std::move(kept), {}, "")), "");
}

TEST(PyramidReport, DrawsAPanelPerLevelAndNamesAsText) {
    for (const std::size_t dimension : {1U, 2U, 3U})
        for (const Shape shape : {Shape::Closed, Shape::Clamped}) {
            const std::string svg = pyramid_picture(report_of(shape, dimension, 5), {"0", "internode"});
            for (int level = 0; level <= 4; ++level)
                EXPECT_THAT(svg, HasSubstr("level " + std::to_string(level) + ": "));
            EXPECT_THAT(svg, HasSubstr("&lt;leaf&gt;.csv"));
            EXPECT_THAT(svg, Not(HasSubstr("<leaf>")));
            EXPECT_THAT(svg, Not(HasSubstr("nan")));
        }
}

TEST(PyramidReport, DrawsAPolygonWithoutSize) {
    const Knots knots = *make_knots(tests::fibonacci(), {2, Ends::Circular, Word(3)}).knots;
    Analysis analysis = analyse(knots, 2, 2, std::vector<double>(18, 4.0));
    Pyramid kept = analysis.pyramid;
    const std::string svg = pyramid_picture(pyramid_report(std::move(analysis), std::move(kept), {}, ""), {"0", "x"});
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

} // namespace
} // namespace internode
