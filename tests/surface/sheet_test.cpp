// SPDX-License-Identifier: MIT

#include "internode/surface/sheet.h"

#include "tests/fixtures/random_grid.h"
#include "tests/fixtures/words.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using namespace tests::letters;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using tests::fibonacci;

/// A grid with these knots along u and a single closed row along v.
Sheet sheet_of(int degree, Ends ends, Word word) {
    const Knots u = make_knots(fibonacci(), {degree, ends, std::move(word)}).knots.value();
    const Knots v = make_knots(fibonacci(), {1, Ends::Circular, {a}}).knots.value();
    return control_sheet(tests::grid_of({u, v, 1, false, std::vector<double>(u.size())}));
}

TEST(Sheet, JoinsTheLastRowOfAClosedDirectionToItsFirst) {
    EXPECT_THAT(sheet_of(2, Ends::Circular, {a, b, a}).joined_rows, ElementsAre(Join{0, 1}, Join{1, 2}, Join{2, 0}));
    EXPECT_THAT(sheet_of(1, Ends::Open, {a, a, b, b}).joined_rows, ElementsAre(Join{0, 1}, Join{1, 2}));
}

TEST(Sheet, JoinsASinglePointToNothing) {
    const Sheet sheet = sheet_of(2, Ends::Circular, {a});
    EXPECT_THAT(sheet.joined_rows, IsEmpty());
    EXPECT_EQ(sheet.faces(), 0u);
    EXPECT_THAT(sheet_of(2, Ends::Circular, {a, b}).joined_columns, IsEmpty());
}

TEST(Sheet, JoinsNothingAcrossABreak) {
    EXPECT_THAT(sheet_of(2, Ends::Open, {o, o, a, o, o, b, o, o}).joined_rows,
                ElementsAre(Join{0, 1}, Join{1, 2}, Join{3, 4}, Join{4, 5}));
    EXPECT_THAT(sheet_of(2, Ends::Circular, {o, o, a, b}).joined_rows, ElementsAre(Join{0, 1}, Join{1, 2}, Join{2, 3}));
    EXPECT_THAT(sheet_of(2, Ends::Circular, {o, a, b, o}).joined_rows, ElementsAre(Join{0, 1}, Join{1, 2}, Join{3, 0}));
    EXPECT_THAT(sheet_of(1, Ends::Open, {o, a, o, b, o}).joined_rows, ElementsAre(Join{0, 1}, Join{2, 3}));
}

TEST(Sheet, GoesRoundItsFacesFromUToV) {
    const Knots u = make_knots(fibonacci(), {1, Ends::Open, {a, a, a}}).knots.value();
    const Knots v = make_knots(fibonacci(), {1, Ends::Circular, {a, a, a}}).knots.value();
    const Sheet sheet = control_sheet(tests::grid_of({u, v, 1, false, std::vector<double>(6)}));
    ASSERT_EQ(sheet.faces(), 3u);
    EXPECT_THAT(sheet.face(0), ElementsAre(0, 3, 4, 1));
    EXPECT_THAT(sheet.face(2), ElementsAre(2, 5, 3, 0));
}

TEST(Sheet, HasPointsInSpace) {
    const Knots one = make_knots(fibonacci(), {1, Ends::Circular, {a}}).knots.value();
    const Sheet sheet = control_sheet(tests::grid_of({one, one, 4, true, {2, 4, 6, 2}}));
    EXPECT_EQ(sheet.dimension, 3u);
    EXPECT_THAT(sheet.points, ElementsAre(1, 2, 3));
    EXPECT_THAT(sheet.normals, IsEmpty());
}

} // namespace
} // namespace internode
