// SPDX-License-Identifier: MIT
//
// A polygon and what a caller says of it: the parameter is the file's, knots and word agree, lengths are positive.
// What the command says of polygons is tested with the command.

#include "internode/input/settled_curve.h"

#include "internode/curve/parameter.h"
#include "internode/curve/refinement.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/input/refusals.h"

#include <gmock/gmock.h>

namespace internode::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Settled<SettledCurve> settle(const std::string& rules, const std::string& members, const CurveOptions& options = {}) {
    return settle_curve(system_of(rules), polygon("{" + members + "}"), options);
}

std::string refused(const std::string& rules, const std::string& members, const CurveOptions& options = {}) {
    return refusal_of(settle(rules, members, options));
}

const std::string four = R"("degree":2,"points":[[0],[1],[4],[9]])";
const std::string ring = R"("degree":2,"closed":true,"points":[[0],[1],[4]])";

std::vector<double> knots_of(const std::string& rules, const std::string& members) {
    const Settled<SettledCurve> settled = settle(rules, members);
    EXPECT_TRUE(settled.value) << refusal_of(settled);
    return settled.value ? knot_positions(settled.value->curve) : std::vector<double>();
}

TEST(SettledCurve, HasTheParameterOfItsKnots) {
    EXPECT_THAT(knots_of("A->AA", four + R"(,"knots":[5,5,5,6,7,7,7])"), ElementsAre(5, 5, 5, 6, 7, 7, 7));
    EXPECT_THAT(knots_of("A->AA", four + R"(,"knots":[5,5,6,7,7])"), ElementsAre(5, 5, 5, 6, 7, 7, 7));
    EXPECT_THAT(knots_of("A->AA", four + R"(,"knots":[1,2,3,4,5,6,7])"), ElementsAre(1, 2, 3, 4, 5, 6, 7));
    EXPECT_THAT(knots_of("A->AA", ring + R"(,"knots":[-3,-2,0,1])"), ElementsAre(-3, -2, 0, 1));
}

TEST(SettledCurve, HasTheEndsOfItsWord) {
    const auto ends = [](const std::string& rules, const std::string& members) {
        return settle(rules, R"("degree":1,"points":[[0],[1],[4]])" + members).value.value().curve.ends();
    };
    EXPECT_EQ(ends("A->AA, axiom AAAA", ""), Ends::Open);
    EXPECT_EQ(ends("A->AA, axiom (AAA)", ""), Ends::Circular);
    EXPECT_EQ(ends("A->AA", ",\"word\":\"AAAA\""), Ends::Open);
    EXPECT_EQ(ends("A->AA", ",\"word\":\"(AAA)\""), Ends::Circular);
    EXPECT_EQ(ends("A->AA", ",\"word\":[\"A\",\"A\",\"A\",\"A\"]"), Ends::Open);
}

TEST(SettledCurve, HasTheOriginOfItsFile) {
    EXPECT_THAT(knots_of("A->AA", ring + R"(,"word":["A","A","A"],"origin":"1/2")"), ElementsAre(0.5, 1.5, 2.5, 3.5));
    const Settled<SettledCurve> golden =
        settle("L->SL, S->L", ring + R"(,"word":"LSL","origin":{"value":0,"exact":["-3","2"]})");
    ASSERT_TRUE(golden.value);
    EXPECT_DOUBLE_EQ(golden.value->curve.knots().origin().to_double(), 0.2360679774997897);
}

TEST(SettledCurve, KeepsItsOriginThroughRefinement) {
    for (const char* const members : {R"("degree":2,"points":[[0],[1],[4],[9]],"knots":[5,5,5,6,7,7,7])",
                                      R"("degree":2,"closed":true,"points":[[0],[1],[4]],"knots":[5,6,7,8])"}) {
        const Settled<SettledCurve> settled = settle("A->AA", members);
        ASSERT_TRUE(settled.value);
        const Curve fine = refine(settled.value->curve, 3);
        EXPECT_EQ(fine.knots().origin(), Number(5));
        EXPECT_EQ(knot_positions(fine).back(), knot_positions(settled.value->curve).back());
    }
}

TEST(SettledCurve, TakesKnotsBesideAWordThatAreTheWords) {
    const std::string word = four + R"(,"word":["0","0","A","A","0","0"],"origin":5)";
    EXPECT_THAT(knots_of("A->AA", word + R"(,"knots":[5,5,5,6,7,7,7])"), ElementsAre(5, 5, 5, 6, 7, 7, 7));
    EXPECT_THAT(knots_of("A->AA", word + R"(,"knots":[5,5,6,7,7])"), ElementsAre(5, 5, 5, 6, 7, 7, 7));
    EXPECT_THAT(refused("A->AA", word + R"(,"knots":[5,5,5,6,7,7,8])"),
                HasSubstr("p.json: error: knot 7 is 8, but the word, its lengths and the origin say 7"));
    EXPECT_THAT(refused("A->AA", word + R"(,"knots":[0,0,0,1,2,2,2])"), HasSubstr("knot 1 is 0, but"));
    EXPECT_THAT(refused("A->AA", word + R"(,"knots":[5,5])"), HasSubstr("2 knots beside a word that has 7"));
}

TEST(SettledCurve, ForgivesKnotsTheRoundingOfTheLargestOfThem) {
    const std::string word = four + R"(,"word":["0","0","A","A","0","0"],"origin":)";
    EXPECT_EQ(refused("A->AA", word + R"(0,"knots":[0,0,0,1.0000000000000008,2,2,2])"), "none");
    EXPECT_EQ(refused("A->AA", word + R"(-2,"knots":[-2,-2,-2,-1.0000000000000008,0,0,0])"), "none");
    EXPECT_THAT(refused("A->AA", word + R"(0,"knots":[0,0,0,1.000000000000001,2,2,2])"), HasSubstr("knot 4 is 1.0"));
}

TEST(SettledCurve, RefusesAnOriginThatIsNotTheFirstKnot) {
    EXPECT_THAT(refused("A->AA", four + R"(,"knots":[5,5,5,6,7,7,7],"origin":4)"),
                HasSubstr("\"origin\" is not the knot where the domain begins"));
    EXPECT_EQ(refused("A->AA", four + R"(,"knots":[5,5,5,6,7,7,7],"origin":5)"), "none");
    EXPECT_THAT(refused("A->AA", ring + R"(,"word":"AAA","origin":{"exact":["1","1"]})"),
                HasSubstr("\"origin\" has 2 coefficients, but the field has degree 1"));
    EXPECT_THAT(refused("A->AA", ring + R"(,"word":"AAA","origin":1e200)"),
                HasSubstr("the parameter begins at 1e+200"));
}

TEST(SettledCurve, RefusesLengthsThatAreNotPositiveAtTheirPlace) {
    const std::string word = ring + R"(,"word":"LSL",)";
    for (const std::string bad : {"0", "-1", R"({"exact":["0","0"]})", R"({"exact":["3","-2"]})"})
        EXPECT_THAT(refused("L->SL, S->L", word + R"("lengths":{"L":)" + bad + "}"),
                    testing::AllOf(HasSubstr("p.json:1:"), HasSubstr("error: the length of `L` must be positive")))
            << bad;
    EXPECT_EQ(refused("L->SL, S->L", word + R"("lengths":{"L":{"exact":["-3","2"]}})"), "none");
    for (const std::string lengths : {R"("B":0)", R"("C":1,"B":0)", R"("B":0,"C":1)"})
        EXPECT_THAT(refused("A->AA", ring + R"(,"word":"BBB","lengths":{)" + lengths + "}"),
                    HasSubstr("error: the length of `B` must be a positive rational"))
            << lengths;
}

TEST(SettledCurve, SaysWhoMustSayMore) {
    const Settled<SettledCurve> none = settle_curve(system_of("A->AA"), polygon("[[0],[1]]"), {});
    EXPECT_TRUE(none.refusal.unsaid);
    EXPECT_EQ(refusal_of(none), "error: no degree\nhint: give -d, or \"degree\" in the polygon's JSON\n");
    EXPECT_FALSE(settle("A->AA", four).refusal.unsaid);
}

TEST(SettledCurve, PlacesARefusalAtItsPart) {
    InputPolygon part = polygon("[[0]]");
    part.line = 12;
    CurveOptions options;
    options.degree = 3;
    options.word = "A";
    const Refusal refusal = placed(settle_curve(system_of("A->AA"), part, options).refusal, part);
    EXPECT_THAT(to_string(refusal.errors), HasSubstr("p.json:12: error: an open curve of degree 3 needs at least 4"));
}

} // namespace
} // namespace internode::tests
