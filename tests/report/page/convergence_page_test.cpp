// SPDX-License-Identifier: MIT

#include "internode/report/page/convergence_page.h"

#include "internode/report/json/convergence_json.h"
#include "internode/report/picture/curve_picture.h"
#include "internode/report/text/convergence_text.h"

#include "tests/report/systems.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace internode {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_report::curve_of;
using testing_report::system_of;

const Generator generator{"0.1.0", "internode converge @fibonacci polygon.csv"};

Convergence measured(const Curve& curve, std::optional<double> tolerance = std::nullopt) {
    ConvergenceOptions options;
    options.steps = 4;
    options.tolerance = tolerance;
    return measure_convergence(curve, options);
}

std::string page_of(const Curve& curve, const std::string& name) {
    const Refinement refinement(curve);
    const std::string picture = curve_picture(planar_curve(curve, refinement, {}),
                                              {.title = name, .generator = generator, .place = SvgPlace::Page});
    return convergence_page({measured(curve, 1e-3), curve.system(), name, picture, generator});
}

TEST(ConvergencePage, ForbidsItselfEveryRequest) {
    const std::string page = page_of(curve_of(system_of(testing_report::fibonacci), 3, Ends::Circular), "leaf");
    EXPECT_THAT(page, HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:\""));
    for (const char* const request : {"<script", "src=", "href=", "@import", "url(", "https:"})
        EXPECT_THAT(page, Not(HasSubstr(request)));
    EXPECT_THAT(page, HasSubstr("prefers-color-scheme:dark"));
}

TEST(ConvergencePage, ShowsCurvePlotsConstantsAndSteps) {
    const std::string page = page_of(curve_of(system_of(testing_report::fibonacci), 3, Ends::Circular), "leaf");
    EXPECT_THAT(page, HasSubstr("leaf under fibonacci"));
    EXPECT_THAT(page, HasSubstr("<g id=\"limit\""));
    EXPECT_THAT(page, HasSubstr("slope −2"));
    EXPECT_THAT(page, HasSubstr("1/φ² = 0.382"));
    EXPECT_THAT(page, HasSubstr("φ/6+1/6"));
    EXPECT_THAT(page, HasSubstr("<td>4</td>"));
    EXPECT_THAT(page, HasSubstr("internode converge @fibonacci polygon.csv"));
}

TEST(ConvergencePage, DegreeOneHasNoErrorToPlot) {
    const std::string page = page_of(curve_of(system_of(testing_report::fibonacci), 1, Ends::Open), "line");
    EXPECT_THAT(page, Not(HasSubstr("slope −2")));
    EXPECT_THAT(page, HasSubstr("At degree 1 the polygon is the curve"));
}

TEST(ConvergencePage, ListsTheRulesOfUpToTwelveSymbols) {
    const auto page = [](int symbols) {
        std::string rules; // A->BB, B->CC, … and back
        for (int i = 0; i < symbols; ++i) {
            const std::string next(2, static_cast<char>('A' + (i + 1) % symbols));
            rules += (i == 0 ? "" : ", ") + std::string(1, static_cast<char>('A' + i)) + "->" + next;
        }
        return page_of(curve_of(system_of(rules), 2, Ends::Circular), "ring");
    };
    EXPECT_THAT(page(12), HasSubstr("<code>L</code></td><td class=\"symbol\"><code>AA</code>"));
    EXPECT_THAT(page(13), AllOf(HasSubstr("<h2>The grammar</h2>"), Not(HasSubstr("<code>M</code>"))));
}

TEST(ConvergencePage, NamesAreText) {
    const IntervalSystem system = validate(testing_report::hostile_grammar()).system.value();
    const Curve curve = curve_of(system, 2, Ends::Circular);
    testing_report::expect_inert(
        convergence_page({measured(curve), system, testing_report::hostile, "", {"0", testing_report::hostile}}));
}

TEST(ConvergenceJson, SaysWhatWasMeasured) {
    const Curve curve = curve_of(system_of(testing_report::fibonacci), 3, Ends::Circular);
    const Convergence convergence = measured(curve, 1e-3);
    const nlohmann::json document = nlohmann::json::parse(convergence_json(convergence, curve.system(), generator));
    EXPECT_EQ(document["format"], "internode-convergence");
    ASSERT_EQ(document["steps"].size(), 5U);
    EXPECT_EQ(document["steps"][0]["ratio"], nullptr);
    EXPECT_EQ(document["steps"][4]["error"], convergence.steps[4].error);
    EXPECT_EQ(document["expected_ratio"]["exact"], (nlohmann::json{"2", "-1"}));
    EXPECT_EQ(document["constant"]["exact"], (nlohmann::json{"1/6", "1/6"}));
    EXPECT_EQ(document["depth_for_tolerance"]["tolerance"], 1e-3);
    const nlohmann::json without = nlohmann::json::parse(convergence_json(measured(curve), curve.system(), generator));
    EXPECT_EQ(without["depth_for_tolerance"], nullptr);
}

TEST(ConvergenceText, SaysTheSame) {
    const Curve curve = curve_of(system_of(testing_report::fibonacci), 3, Ends::Circular);
    const std::string text = convergence_text(measured(curve, 1e-3), curve.system());
    EXPECT_THAT(text, HasSubstr("1/φ² = 2−φ ≈ 0.382"));
    EXPECT_THAT(text, HasSubstr("φ/6+1/6 ≈ 0.4363, attained at LL"));
    EXPECT_THAT(text, HasSubstr("an error of at most 0.001"));
    EXPECT_THAT(text, HasSubstr("bisected uniformly"));
}

} // namespace
} // namespace internode
