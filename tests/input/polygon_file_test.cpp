// SPDX-License-Identifier: MIT
//
// Every format by name and by content; parts of a file, all of them or the one that is asked for.

#include "internode/input/polygon_file.h"

#include "tests/input/refusals.h"

#include <gmock/gmock.h>

namespace internode::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string curves = "v 0 0 0\nv 1 0 0\nv 1 1 0\ncstype bspline\ndeg 1\n"
                           "curv 0 1 1 2\nparm u 0 0 1 1\nend\ncurv 0 3 1 2 3\nparm u 0 0 1 3 3\nend\n";
const std::string lines = "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\nv 5 5 5\nv 6 6 6\nl -2 -1\n";

std::vector<std::size_t> sizes(std::string_view text, std::string_view source) {
    const Settled<std::vector<InputPolygon>> settled = polygons_of_file(text, source);
    EXPECT_TRUE(settled.value) << refusal_of(settled);
    std::vector<std::size_t> result;
    for (const InputPolygon& one : settled.value.value_or(std::vector<InputPolygon>{})) result.push_back(one.size());
    return result;
}

TEST(PolygonFile, IsReadByNameAndByContent) {
    EXPECT_THAT(sizes(curves, "c.obj"), ElementsAre(2, 3));
    EXPECT_THAT(sizes(curves, "<stdin>"), ElementsAre(2, 3));
    EXPECT_THAT(sizes(lines, "l.obj"), ElementsAre(3, 2));
    EXPECT_THAT(sizes("[[0,1],[2,3]]", "p"), ElementsAre(2));
    EXPECT_THAT(sizes("0,1\n2,3\n", "p"), ElementsAre(2));
    EXPECT_THAT(refusal_of(polygons_of_file("0,1\n", "p.obj")), HasSubstr("p.obj:1:1"));
}

TEST(PolygonFile, GivesTheElementThatIsAskedFor) {
    EXPECT_EQ(polygon_of_file(curves, "c.obj", 2).value.value().size(), 3U);
    EXPECT_EQ(polygon_of_file("0,0\n\n1,1\n2,2\n", "p.csv", 2).value.value().size(), 2U);
    EXPECT_EQ(polygon_of_file("0,0\n", "p.csv", 1).value.value().size(), 1U);
    EXPECT_THAT(refusal_of(polygon_of_file("0,0\n", "p.csv", 2)), HasSubstr("no element 2: p.csv has 1"));
    EXPECT_THAT(refusal_of(polygon_of_file(curves, "c.obj", 0)), HasSubstr("no element 0: c.obj has 2"));
    EXPECT_THAT(refusal_of(polygon_of_file(curves, "c.obj")), HasSubstr("c.obj has 2 polygons, where one is meant"));
}

TEST(PolygonFile, KnowsWhereItsPartsBegin) {
    const auto parts = polygons_of_file("x,y\n0,0\n1,1\n\n# two\n2,2\n", "p.csv").value.value();
    EXPECT_EQ(parts[0].line, 2U);
    EXPECT_EQ(parts[1].line, 6U);
    EXPECT_EQ(polygons_of_file(lines, "l.obj").value.value()[1].line, 7U);
    EXPECT_EQ(polygons_of_file(curves, "c.obj").value.value()[1].line, 9U);
    EXPECT_EQ(polygon("0,0\n", "p.csv").line, 0U);
}

TEST(PolygonFile, TellsCurvesFromSurfaces) {
    const std::string flat = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ncstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\n"
                             "parm u 0 0 1 1\nparm v 0 0 1 1\nend\n";
    EXPECT_THAT(refusal_of(polygons_of_file(flat, "f.obj")), HasSubstr("element 1 of f.obj (line 7) is a surface"));
    EXPECT_EQ(grid_of_file(flat, "f.obj").value.value().rows, 2U);
    EXPECT_THAT(refusal_of(grid_of_file(curves, "c.obj", 1)), HasSubstr("element 1 of c.obj (line 6) is a curve"));
    EXPECT_THAT(refusal_of(grid_of_file(curves, "c.obj")), HasSubstr("2 curves and surfaces"));
    EXPECT_THAT(refusal_of(grid_of_file("{}", "g.json", 1)), HasSubstr("is no OBJ file"));
    EXPECT_THAT(refusal_of(grid_of_file("{}", "g.json")), HasSubstr("`points`"));
}

} // namespace
} // namespace internode::tests
