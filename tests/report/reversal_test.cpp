// SPDX-License-Identifier: MIT

#include "internode/report/json/reversal_json.h"
#include "internode/report/picture/reversal_picture.h"
#include "internode/report/text/reversal_text.h"

#include <stdexcept>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::HasSubstr;
using testing::Not;

ReversalReport square_report() {
    ReversalReport report;
    report.source = "square.csv";
    report.name = "evil\n\x1b name";
    report.fitting = {.measured = 4, .points = 4};
    report.rule = ReverseRule{2, -1, {Rational(-1, 4), Rational(3, 4), Rational(3, 4), Rational(-1, 4)}};
    report.polygons = {{0, 0, 1, 0, 1, 1, 0, 1}, {0.5, 0, 0.5, 1}};
    report.levels = {{report.polygons[1], 0.75, 0.5}};
    report.generator = {"0", "internode reverse"};
    return report;
}

TEST(ReversalText, ShowsTheRuleItsGainAndEveryLevel) {
    const std::string text = reversal_text(square_report());
    EXPECT_THAT(text, HasSubstr("  gain     2\n"));
    EXPECT_THAT(text, HasSubstr("     1       2       0.75        0.5\n"));
    EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

TEST(ReversalText, SaysWhenErrorsAreNotKnown) {
    ReversalReport report = square_report();
    report.rule.reset();
    report.levels.clear();
    EXPECT_THAT(reversal_text(report), HasSubstr("not known"));
    EXPECT_THAT(reversal_json(report), HasSubstr("\"rule\": null"));
    EXPECT_THAT(reversal_json(report), HasSubstr("\"largest_error\": null"));
}

TEST(ReversalJson, HasTheRuleInExactFractions) {
    const std::string json = reversal_json(square_report());
    EXPECT_THAT(json, HasSubstr("\"format\": \"internode-reversal\""));
    EXPECT_THAT(json, HasSubstr("\"weights\": [\"-1/4\", \"3/4\", \"3/4\", \"-1/4\"]"));
    EXPECT_THAT(json, HasSubstr("\"first\": -1"));
}

TEST(ReversalPicture, HasAPanelForTheOriginalAndEachPhase) {
    ReversalPicture picture;
    picture.original = {0, 0, 1, 0, 1, 1, 0, 1};
    picture.phases = {{0, {0.5, 0, 0.5, 1}}, {1, {0, 0.5, 1, 0.5}}};
    picture.title = "<a> & b";
    const std::string text = reversal_picture(picture);
    EXPECT_THAT(text, HasSubstr("original: 4 points"));
    EXPECT_THAT(text, HasSubstr("phase 1: 2 points"));
    EXPECT_THAT(text, HasSubstr("&lt;a&gt; &amp; b"));
    EXPECT_TRUE(text.ends_with("</svg>\n"));
}

TEST(ReversalPicture, DrawsNumbersOnePointAndWhatNoiseTookAway) {
    ReversalPicture picture;
    picture.dimension = 1;
    picture.original = {1, 2, 3, 2};
    picture.phases = {{0, {1e300, -1e300}}};
    EXPECT_THAT(reversal_picture(picture), Not(HasSubstr("nan")));
    picture.original = {5};
    picture.phases.clear();
    EXPECT_THAT(reversal_picture(picture), Not(HasSubstr("nan")));
    picture.dimension = 2;
    EXPECT_THROW((void)reversal_picture(picture), std::invalid_argument);
}

} // namespace
} // namespace internode
