// SPDX-License-Identifier: MIT

#include "internode/surface/grid.h"

#include "tests/fixtures/random_grid.h"
#include "tests/fixtures/words.h"

#include <gmock/gmock.h>
#include <limits>

namespace internode {
namespace {

using namespace tests::letters;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using tests::fibonacci;

Knots closed(Word word) {
    return make_knots(fibonacci(), {2, Ends::Circular, std::move(word)}).knots.value();
}

/// Two rows of three points, all coordinates 1.
GridData small_data() {
    return {closed({a, b}), closed({a, b, a}), 3, false, std::vector<double>(18, 1)};
}

std::vector<std::string> problems(GridData data) {
    const CheckedGrid checked = make_grid(std::move(data));
    EXPECT_EQ(checked.grid.has_value(), checked.problems.empty());
    return checked.problems;
}

TEST(Grid, KeepsWhatItIsGiven) {
    GridData data = small_data();
    data.points[4] = 7;
    data.rational = true;
    const Grid grid = make_grid(data).grid.value();
    EXPECT_EQ(grid.u().size(), 2u);
    EXPECT_EQ(grid.v().size(), 3u);
    EXPECT_EQ(grid.size(), 6u);
    EXPECT_EQ(grid.dimension(), 3u);
    EXPECT_EQ(grid.space_dimension(), 2u);
    EXPECT_TRUE(grid.rational());
    EXPECT_EQ(grid.points(), data.points);
}

TEST(Grid, RefusesAnotherNumberOfPointsThanItsKnotsAskFor) {
    for (const std::size_t points : {0u, 3u, 5u, 7u, 9u}) {
        GridData data = small_data();
        data.points.assign(points * 3, 0);
        EXPECT_THAT(problems(data),
                    ElementsAre("knots for 2 by 3 control points need as many points, not " + std::to_string(points)));
    }
}

TEST(Grid, RefusesBrokenRowsAndPointsWithoutCoordinates) {
    GridData data = small_data();
    data.points.pop_back();
    EXPECT_THAT(problems(data), ElementsAre("17 coordinates do not make whole points of 3"));
    data.dimension = 0;
    EXPECT_THAT(problems(data), ElementsAre("a point needs at least one coordinate"));
    data.dimension = 1;
    data.rational = true;
    EXPECT_THAT(problems(data), ElementsAre(HasSubstr("at least one coordinate and the weight")));
}

TEST(Grid, NamesThePlaceOfWhatIsNotFinite) {
    GridData data = small_data();
    data.points[4] = std::numeric_limits<double>::infinity();
    data.points[17] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(problems(data),
                ElementsAre("row 1, column 2, coordinate 2 is inf: every coordinate must be a finite number",
                            "row 2, column 3, coordinate 3 is nan: every coordinate must be a finite number"));
    data.points.assign(18, std::numeric_limits<double>::infinity());
    EXPECT_THAT(problems(data), SizeIs(6));
    EXPECT_EQ(problems(data).back(), "and 13 more coordinates like these");
}

TEST(Grid, RefusesWeightsThatAreNotPositiveOrTooSmallToDivideBy) {
    GridData data = small_data();
    data.rational = true;
    EXPECT_THAT(problems(data), SizeIs(0));
    for (const double weight : {0.0, -0.0, -1.0, 1e-101, 1e101}) {
        data.points[5] = weight;
        EXPECT_THAT(problems(data), ElementsAre(HasSubstr("row 1, column 2, coordinate 3 is")));
    }
    data.rational = false;
    EXPECT_THAT(problems(data), SizeIs(0));
}

TEST(Grid, ProjectsByDividingByTheWeight) {
    GridData data{closed({a}), closed({a, b}), 3, true, {1, 2, 2, 3, 4, 0.5}};
    EXPECT_THAT(projected_points(make_grid(data).grid.value()), ElementsAre(0.5, 1, 6, 8));
    data.rational = false;
    EXPECT_THAT(projected_points(make_grid(data).grid.value()), ElementsAre(1, 2, 2, 3, 4, 0.5));
}

} // namespace
} // namespace internode
