// SPDX-License-Identifier: MIT
//
// A grid along its two sides: parameters of the file, knots beside words, lengths that are positive.

#include "internode/input/settled_grid.h"

#include "internode/curve/parameter.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/input/refusals.h"

#include <gmock/gmock.h>

namespace internode::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Settled<Grid> settle_small_grid(const std::string& members) {
    const std::string text = R"({"degree":[1,1],"points":[[[0],[1]],[[2],[3]],[[4],[5]]],)" + members + "}";
    Settled<InputGrid> input = grid_of_file(text, "g.json");
    EXPECT_TRUE(input.value) << refusal_of(input);
    return settle_grid({system_of("A->AA"), system_of("A->AA")}, *std::move(input.value), {});
}

TEST(SettledGrid, HasTheParametersOfItsKnots) {
    const Settled<Grid> grid = settle_small_grid(R"("knots":[[5,5,6,8,8],[-1,-1,1,1]])");
    ASSERT_TRUE(grid.value) << refusal_of(grid);
    EXPECT_THAT(knot_positions(grid.value->u()), ElementsAre(5, 5, 6, 8, 8));
    EXPECT_THAT(knot_positions(grid.value->v()), ElementsAre(-1, -1, 1, 1));
}

TEST(SettledGrid, HasTheOriginsOfItsFile) {
    const Settled<Grid> grid = settle_small_grid(R"("word":["0 A A 0","0 A 0"],"origin":["1/2",null])");
    ASSERT_TRUE(grid.value) << refusal_of(grid);
    EXPECT_THAT(knot_positions(grid.value->u()), ElementsAre(0.5, 0.5, 1.5, 2.5, 2.5));
    EXPECT_THAT(knot_positions(grid.value->v()), ElementsAre(0, 0, 1, 1));
}

TEST(SettledGrid, RefusesWithTheSide) {
    EXPECT_THAT(refusal_of(settle_small_grid(R"("word":["0 A A 0","0 A 0"],"knots":[null,[0,0,2,2]])")),
                HasSubstr("g.json: error: along v: knot 3 is 2, but the word, its lengths and the origin say 1"));
    EXPECT_THAT(refusal_of(settle_small_grid(R"("word":["0 A A 0","0 A 0"],"lengths":[{"A":0},null])")),
                HasSubstr("error: the length of `A` must be positive"));
    EXPECT_THAT(refusal_of(settle_small_grid(R"("word":["A A A","0 A 0"])")),
                HasSubstr("along u 3 points of degree 1 need a word of 4 letters, but the grid's word has 3"));
    EXPECT_THAT(refusal_of(settle_small_grid(R"x("word":["(A A A)","0 A 0"],"closed":[false,null])x")),
                HasSubstr("along u the grid's word is circular"));
}

} // namespace
} // namespace internode::tests
