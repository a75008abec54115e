// SPDX-License-Identifier: MIT
//
// A polygon to be taken apart, by its own knots: coarse word, lengths and origin are those that refine to them.

#include "internode/input/settled_contour.h"

#include "internode/curve/parameter.h"
#include "internode/curve/refinement.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/input/refusals.h"

#include <gmock/gmock.h>

namespace internode::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string clamped_knots = R"({"degree":2,"points":[[0],[1],[2],[3],[4],[5]],"knots":[5,5,5,6,7,9,11,11,11]})";

ContourOptions asked(std::optional<std::uint64_t> levels, const std::string& word = {}) {
    ContourOptions options;
    options.levels = levels;
    options.curve.word = word;
    return options;
}

ContourOptions of_degree_1(std::optional<std::uint64_t> levels, bool repeat) {
    ContourOptions options = asked(levels);
    options.curve.degree = 1;
    options.curve.repeat = repeat;
    return options;
}

SettledContour settled(const std::string& text, const ContourOptions& options, const std::string& rules = "A->AA") {
    Settled<SettledContour> contour = settle_contour(system_of(rules), polygon(text), options);
    if (!contour.value) throw std::invalid_argument(refusal_of(contour));
    return *std::move(contour.value);
}

TEST(SettledContour, TakesTheWordOfItsKnotsBack) {
    const SettledContour contour = settled(clamped_knots, asked(1));
    EXPECT_THAT(knot_positions(contour.coarse), ElementsAre(5, 5, 5, 7, 11, 11, 11));
    EXPECT_THAT(knot_positions(refined_knots(contour.coarse, 1)), ElementsAre(5, 5, 5, 6, 7, 9, 11, 11, 11));
    EXPECT_FALSE(contour.fitting.clamped);
    EXPECT_EQ(contour.points.size(), 6U);
}

TEST(SettledContour, HoldsACoarseWordAgainstTheKnots) {
    const std::string even = R"({"degree":1,"closed":true,"points":[[0],[1],[2],[3]],"knots":[5,6,7,8,9]})";
    EXPECT_THAT(knot_positions(settled(even, asked(1, "A A")).coarse), ElementsAre(5, 7, 9));
    const std::string golden = R"({"degree":1,"closed":true,"points":[[0],[1],[2]],)"
                               R"("knots":[0,1,{"exact":["1","1"]},{"exact":["1","2"]}]})";
    EXPECT_EQ(settled(golden, asked(1, "L S"), "L->SL, S->L").levels, 1);
}

TEST(SettledContour, RefusesKnotsThatAreNoRefinement) {
    const auto refused = [](const std::string& text, const ContourOptions& options,
                            const std::string& rules = "A->AA") {
        return refusal_of(settle_contour(system_of(rules), polygon(text), options));
    };
    EXPECT_THAT(refused(clamped_knots, asked(2)), HasSubstr("are no refinement of 2 levels"));
    EXPECT_THAT(refused(clamped_knots, {}), HasSubstr("leave the number of levels open"));
    EXPECT_THAT(refused(R"({"degree":1,"closed":true,"points":[[0],[1],[2]],)"
                        R"("knots":[0,{"exact":["0","1"]},{"exact":["0","2"]},{"exact":["1","2"]}]})",
                        asked(1, "L S"), "L->SL, S->L"),
                HasSubstr("the knots in p.json are not what the coarse word becomes after 1 levels"));
    EXPECT_THAT(refused("[[0],[1]]", of_degree_1({}, true)), HasSubstr("number of levels open"));
    EXPECT_THAT(refused(R"({"degree":1,"points":[[0],[1]],"weights":[1,1],"word":"AAA"})", {}),
                HasSubstr("without weights"));
    EXPECT_THAT(refused("[[0],[1]]", of_degree_1(1'000'000, false)), HasSubstr("at most 100000 levels"));
}

TEST(SettledContour, ClampsUnlessItsKnotsClampBothEndsWhole) {
    const auto is_clamped = [](const std::string& knots) {
        const std::string text = R"({"degree":2,"points":[[0],[1],[2],[3],[4]],"knots":)" + knots + "}";
        return settled(text, asked(0)).fitting.clamped;
    };
    EXPECT_FALSE(is_clamped("[0,0,0,1,2,3,3,3]"));
    EXPECT_TRUE(is_clamped("[0,0,0,1,2,3,3,4]"));
    EXPECT_TRUE(is_clamped("[0,0,0,1,2,3,4,4]"));
    EXPECT_TRUE(is_clamped("[0,1,1,2,3,4,4,4]"));
    EXPECT_TRUE(is_clamped("[0,0,1,2,3,4,4,4]"));
}

TEST(SettledContour, KeepsTheOriginOfARefinedFile) {
    const std::string fine = R"({"degree":1,"closed":true,"points":[[0],[1],[2],[3]],"word":"A A A A","origin":"7/2",)"
                             R"("lengths":{"A":"1/2"}})";
    const SettledContour contour = settled(fine, asked(1, "A A"));
    EXPECT_THAT(knot_positions(contour.coarse), ElementsAre(3.5, 4.5, 5.5));
}

} // namespace
} // namespace internode::tests
