// SPDX-License-Identifier: MIT

#include "internode/io/obj/obj_polylines.h"

#include "internode/io/obj/obj.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<InputPolygon> read_lines(std::string_view text) {
    ParsedPolygons parsed = read_obj_polylines(text, "l.obj");
    EXPECT_TRUE(parsed.errors.empty()) << to_string(parsed.errors);
    return std::move(parsed.polygons);
}

std::string refusal_of_lines(std::string_view text) {
    const ParsedPolygons parsed = read_obj_polylines(text, "l.obj");
    EXPECT_TRUE(parsed.polygons.empty());
    return to_string(parsed.errors);
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjPolylines, AreReadWithTheirLines) {
    const std::vector<InputPolygon> two = read_lines(square + "l 1 2 3\nl -1 1\n");
    ASSERT_EQ(two.size(), 2U);
    EXPECT_THAT(two[0].points, ElementsAre(0, 0, 0, 1, 0, 0, 1, 1, 0));
    EXPECT_THAT(two[1].points, ElementsAre(0, 1, 0, 0, 0, 0));
    EXPECT_EQ(two[0].line, 5U);
    EXPECT_EQ(two[1].line, 6U);
    EXPECT_FALSE(two[0].closed);
}

TEST(ObjPolylines, AreClosedWhereTheyEndAtTheirFirstPoint) {
    const std::vector<InputPolygon> ring = read_lines(square + "l 1 2 3 4 1\n");
    ASSERT_EQ(ring.size(), 1U);
    EXPECT_EQ(ring[0].closed, true);
    EXPECT_EQ(ring[0].size(), 4U);
}

TEST(ObjPolylines, OfSingleEdgesArePutTogether) {
    const std::vector<InputPolygon> ring = read_lines(square + "l 1 2\nl 2 3\nl 3 4\nl 4 1\n");
    ASSERT_EQ(ring.size(), 1U);
    EXPECT_EQ(ring[0].size(), 4U);
    EXPECT_EQ(read_lines(square + "l 1 2 3\nl 3 4\n").size(), 2U) << "two polylines that meet";
    EXPECT_EQ(read_lines(square + "l 1 2\no b\nl 2 3\n").size(), 2U) << "an object begins";
}

TEST(ObjPolylines, AreWhatIsWritten) {
    for (const std::size_t size : {std::size_t{2}, std::size_t{256}, std::size_t{257}, std::size_t{700}})
        for (const Ends ends : {Ends::Open, Ends::Circular}) {
            if (size == 2 && ends == Ends::Circular) continue;
            std::vector<double> points;
            for (std::size_t i = 0; i < 3 * size; ++i) points.push_back(static_cast<double>(i));
            StringSink sink;
            ASSERT_TRUE(write_obj(sink, {3, points}, ends));
            ASSERT_TRUE(write_obj(sink, {3, points}, ends, {}, size));
            const std::vector<InputPolygon> two = read_lines(sink.text());
            ASSERT_EQ(two.size(), 2U) << size;
            for (const InputPolygon& one : two) {
                EXPECT_EQ(one.points, points);
                EXPECT_EQ(one.closed.value_or(false), ends == Ends::Circular);
            }
        }
}

TEST(ObjPolylines, AreToldFromFreeForms) {
    EXPECT_TRUE(has_only_polylines(square + "l 1 2\n"));
    EXPECT_FALSE(has_only_polylines(square));
    EXPECT_FALSE(has_only_polylines(square + "l 1 2\ncurv 0 1 1 2\n"));
}

TEST(ObjPolylines, AreRefusedWithTheirPlace) {
    for (const std::string index : {"0", "5", "-5", "2147483648", "9223372036854775808", "x"})
        EXPECT_THAT(refusal_of_lines(square + "l 1 " + index + "\n"),
                    HasSubstr("l.obj:5:5: error: no vertex `" + index));
    EXPECT_THAT(refusal_of_lines(square + "l 1\n"), HasSubstr("two vertices at least"));
    EXPECT_THAT(refusal_of_lines("v 1 2\nl 1 1\n"), HasSubstr("needs x, y and z"));
    EXPECT_THAT(refusal_of_lines("v 1 2 nan\nl 1 1\n"), HasSubstr("`nan` is not a number"));
    EXPECT_THAT(refusal_of_lines(square + "line 1 2\nl 1 2\n"), HasSubstr("`line` is no statement"));
    EXPECT_THAT(refusal_of_lines(square + "call x.obj\nl 1 2\n"), HasSubstr("reaches out of the file"));
    EXPECT_THAT(to_string(read_obj_polylines(square + "l 1 2 3\n", "l.obj", {.vertices = 2}).errors),
                HasSubstr("more than 2 vertices"));
}

TEST(ObjPolylines, GiveOneErrorForOneMistakeWithItsHint) {
    const std::vector<Diagnostic> errors = read_obj_polylines(square + "l 1\nl 9\nl 1 2\n", "l.obj").errors;
    ASSERT_THAT(errors, testing::SizeIs(2));
    EXPECT_EQ(errors[0].hint, "");
    EXPECT_EQ(errors[0].width, 1U) << "`l`";
    EXPECT_EQ(read_obj_polylines(square + "l 1 -99\n", "l.obj").errors.at(0).width, 3U) << "`-99`";
    EXPECT_EQ(errors[1].hint, "indices count from 1, or from -1 backwards");
}

} // namespace
} // namespace internode
