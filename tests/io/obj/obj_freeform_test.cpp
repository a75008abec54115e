// SPDX-License-Identifier: MIT
//
// Free forms of OBJ: what is read, and every index, count and statement that is not.

#include "internode/io/obj/obj_freeform.h"

#include "internode/io/obj/free_form_input.h"
#include "internode/text/number.h"

#include <bit>
#include <cmath>
#include <gmock/gmock.h>
#include <random>
#include <string>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

const std::string four_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0 2\nv 0 1 0\n";
const std::string head = four_vertices + "cstype bspline\ndeg 1\n"; // six lines

FreeFormFile read(const std::string& text) {
    ParsedFreeForms parsed = read_obj_freeform(text, "f.obj");
    EXPECT_TRUE(parsed.file) << text << (parsed.errors.empty() ? "" : to_string(parsed.errors));
    return parsed.file ? *std::move(parsed.file) : FreeFormFile();
}

/// The first error of a text, which must have a place.
Diagnostic refusal(const std::string& text, const ObjLimits& limits = {}) {
    const ParsedFreeForms parsed = read_obj_freeform(text, "f.obj", limits);
    EXPECT_FALSE(parsed.file) << text;
    if (parsed.errors.empty()) return {};
    EXPECT_GE(parsed.errors.front().line, 1U) << text;
    EXPECT_GE(parsed.errors.front().column, 1U) << text;
    return parsed.errors.front();
}

TEST(ObjFreeform, ReadsACurve) {
    const FreeFormFile file = read(head + "curv 0 3 1 2 3 -1\nparm u 0 0 1 2 3.0 +3\nend\n");
    EXPECT_THAT(file.vertices, ElementsAre(0, 0, 0, 1, 1, 0, 0, 1, 1, 1, 0, 2, 0, 1, 0, 1));
    ASSERT_THAT(file.elements, SizeIs(1));
    const FreeForm& curve = file.elements[0];
    EXPECT_EQ(curve.place.line, 7U);
    EXPECT_FALSE(curve.rational || curve.v);
    EXPECT_EQ(curve.u.degree, 1U);
    EXPECT_EQ(curve.u.points, 4U);
    EXPECT_THAT(curve.u.knots, ElementsAre(0, 0, 1, 2, 3, 3));
    EXPECT_THAT(curve.vertices, ElementsAre(0, 1, 2, 3));
}

TEST(ObjFreeform, ReadsARationalSurface) {
    const FreeFormFile file = read("vt 0 0\nvn 0 0 1\n" + four_vertices +
                                   "cstype rat bspline\ndeg 1 1\nsurf 0 1 2 3 1/1/1 2//-1 4/-1 3\n"
                                   "parm v 2 2 3 3\nparm u 0 0 1 1\nsp 1\nend\n");
    const FreeForm& surface = file.elements.at(0);
    EXPECT_TRUE(surface.rational);
    ASSERT_TRUE(surface.v);
    EXPECT_THAT(surface.v->knots, ElementsAre(2, 2, 3, 3));
    EXPECT_EQ(surface.u.points * surface.v->points, 4U);
    EXPECT_THAT(surface.vertices, ElementsAre(0, 1, 3, 2));
    EXPECT_THROW((void)free_form_polygon(file, surface), std::invalid_argument);
}

TEST(ObjFreeform, ContinuesLinesAndPassesOver) {
    const FreeFormFile file = read("# a comment\n\n  \t\ng body\nusemtl red\n" + head +
                                   "curv 0 1 \\\n 1\\\r\n 2 # here\r\nparm u 0 \\\n0 1 1\nend\nf 1 2 3\n"
                                   "curv2 1 2 3\nparm u 0 1 1\nend\np 1");
    ASSERT_THAT(file.elements, SizeIs(1));
    EXPECT_THAT(file.elements[0].vertices, ElementsAre(0, 1));
    EXPECT_THAT(file.elements[0].u.knots, ElementsAre(0, 0, 1, 1));
}

TEST(ObjFreeform, ReadsNumbersExactlyAndCorrectlyRounded) {
    const FreeFormFile file = read("v 0.1 5. +1e-3\nv 1 2 3 0.2 0.3 0.4\ncstype bspline\ndeg 1\ncurv 1e-1 5.e-1 1 2\n"
                                   "parm u .1 0.1 5.e-1 0.50\nend\n");
    EXPECT_THAT(file.vertices, ElementsAre(0.1, 5, 1e-3, 1, 1, 2, 3, 1));
    EXPECT_THAT(file.elements[0].u.knots,
                ElementsAre(Rational(1, 10), Rational(1, 10), Rational(1, 2), Rational(1, 2)));
    std::mt19937_64 random(5);
    std::string text;
    std::vector<double> expected;
    while (expected.size() < 4000) {
        const double number = std::bit_cast<double>(random());
        if (!(std::abs(number) < 1e300)) continue;
        expected.push_back(number);
        text += (expected.size() % 4 == 1 ? "\nv " : " ") + to_string(number);
    }
    text += "\ncstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n";
    EXPECT_EQ(read(text).vertices, expected);
}

TEST(ObjFreeform, AnElementIsAPolygon) {
    const FreeFormFile file =
        read("v 1 2 3 4\nv 5 6 7 8\ncstype rat bspline\ndeg 1\ncurv 0 1 2 1\nparm u 0 0 1 1\nend\n"
             "cstype bspline\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n");
    const InputPolygon rational = free_form_polygon(file, file.elements.at(0));
    EXPECT_THAT(rational.points, ElementsAre(5, 6, 7, 1, 2, 3));
    EXPECT_THAT(rational.weights, ElementsAre(8, 4));
    EXPECT_EQ(rational.degree, 1U);
    EXPECT_EQ(rational.closed, false);
    EXPECT_THAT(rational.knots.value(), ElementsAre(ElementsAre(0), ElementsAre(0), ElementsAre(1), ElementsAre(1)));
    EXPECT_TRUE(free_form_polygon(file, file.elements.at(1)).weights.empty());
}

TEST(ObjFreeform, ASurfaceIsAGridWithRowsAlongU) {
    const FreeFormFile file = read("v 0 0 0 1\nv 1 0 0 2\nv 2 0 0 1\nv 0 1 0 1\nv 1 1 0 1\nv 2 1 0 1\n"
                                   "cstype rat bspline\ndeg 2 1\nsurf 0 1 0 2 1 2 3 4 5 6\n"
                                   "parm u 0 0 0 1 1 1\nparm v 0 0 2 2\nend\n"
                                   "cstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n");
    const InputGrid grid = free_form_grid(file, file.elements.at(0));
    EXPECT_EQ(grid.rows, 3U);
    EXPECT_EQ(grid.columns, 2U);
    EXPECT_EQ(grid.dimension, 4U);
    EXPECT_TRUE(grid.rational);
    EXPECT_THAT(grid.points, ElementsAre(0, 0, 0, 1, 0, 1, 0, 1, 2, 0, 0, 2, 1, 1, 0, 1, 2, 0, 0, 1, 2, 1, 0, 1));
    EXPECT_EQ(grid.sides[0].degree, 2U);
    EXPECT_THAT(grid.sides[1].knots.value(),
                ElementsAre(ElementsAre(0), ElementsAre(0), ElementsAre(2), ElementsAre(2)));
    EXPECT_THROW((void)free_form_grid(file, file.elements.at(1)), std::invalid_argument);
}

TEST(ObjFreeform, ChecksEveryIndexWhereItStands) {
    for (const std::string index :
         {"0", "-0", "5", "-5", "2147483648", "-2147483648", "4294967296", "4294967297", "9223372036854775808",
          "-9223372036854775808", "18446744073709551617", "99999999999999999999999"}) {
        const Diagnostic error = refusal(head + "curv 0 1 1 " + index + "\nparm u 0 0 1 1\nend\n");
        EXPECT_EQ(error.line, 7U);
        EXPECT_EQ(error.column, 12U);
        EXPECT_THAT(error.message, HasSubstr("no vertex " + index + ": 4 stand before")) << index;
    }
    for (const std::string index : {"x", "1.0", "1e0", "+1", "--1", "0x1", "1,", "/1"})
        EXPECT_THAT(refusal(head + "curv 0 1 1 " + index + "\nparm u 0 0 1 1\nend\n").message,
                    HasSubstr("is not the index of a vertex"))
            << index;
    // A vertex that only follows is none yet.
    EXPECT_EQ(refusal("cstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n" + four_vertices).line, 3U);
    EXPECT_THAT(refusal(head + "curv 0 1 1 2/1\nparm u 0 0 1 1\nend\n").message, HasSubstr("one index"));
    const std::string surface = four_vertices + "vt 0\nvn 0 0 1\ncstype bspline\ndeg 1 1\nsurf 0 1 0 1 ";
    EXPECT_THAT(refusal(surface + "1/2\n").message, HasSubstr("no texture vertex 2: 1 stands before"));
    EXPECT_THAT(refusal(surface + "1/1/0\n").message, HasSubstr("no normal 0"));
    EXPECT_THAT(refusal(surface + "1//\n").message, HasSubstr("not the index of a normal"));
}

TEST(ObjFreeform, CountsMustFit) {
    const auto message = [](const std::string& rest) { return refusal(head + rest).message; };
    EXPECT_THAT(message("curv 0 1 1 2\nend\n"), HasSubstr("no `parm u`"));
    EXPECT_THAT(message("curv 0 1 1 2\nparm u 0 0 1\nend\n"), HasSubstr("3 knots in `parm u`, but degree 1 needs"));
    EXPECT_THAT(message("curv 0 1 1 2 3\nparm u 0 0 1 1\nend\n"), HasSubstr("3 control points, but"));
    EXPECT_THAT(message("curv 0 1\nparm u 0 0 1 1\nend\n"), HasSubstr("0 control points"));
    EXPECT_THAT(message("curv 0 0.5 1 2\nparm u 0 0 1 1\nend\n"),
                HasSubstr("from 0 to 1/2 is meant, but the domain of the knots is 0 to 1"));
    EXPECT_THAT(message("deg 1 1\nsurf 0 1 0 1 1 2 3\nparm u 0 0 1 1\nparm v 0 0 1 1\nend\n"),
                HasSubstr("3 control points, but the knots of both directions are for 4"));
    EXPECT_THAT(message("deg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 0 1 1\nend\n"), HasSubstr("no `parm v`"));
    EXPECT_THAT(message("deg 1 1\nsurf 0 1 0 2 1 2 3 4\nparm u 0 0 1 1\nparm v 0 0 1 1\nend\n"),
                HasSubstr("from 0 to 2"));
    EXPECT_THAT(message("deg 1000000\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n"), HasSubstr("needs at least 2000002"));
}

TEST(ObjFreeform, RefusesWhatItDoesNotRead) {
    const std::string curve = "curv 0 1 1 2\nparm u 0 0 1 1\nend\n";
    EXPECT_THAT(refusal(four_vertices + "cstype bezier\ndeg 3\n" + curve).message, HasSubstr("not `cstype` `bezier`"));
    EXPECT_THAT(refusal(four_vertices + "cstype bspline\n" + curve).message, HasSubstr("needs a degree"));
    EXPECT_THAT(refusal(four_vertices + curve).message, HasSubstr("before `cstype`"));
    EXPECT_THAT(refusal(head + "surf 0 1 0 1 1 2\n").message, HasSubstr("needs two degrees"));
    EXPECT_THAT(refusal(head + curve + "trim 0 1 1\n").message, HasSubstr("trimmed"));
    EXPECT_THAT(refusal(head + curve + "call other.obj\n").message, HasSubstr("out of the file"));
    const Diagnostic unknown = refusal(head + curve + "cstyp bspline\n");
    EXPECT_THAT(unknown.message, HasSubstr("`cstyp` is no statement of OBJ"));
    EXPECT_THAT(unknown.hint, HasSubstr("cstype"));
    EXPECT_EQ(unknown.line, 10U);
    const ParsedFreeForms none = read_obj_freeform(four_vertices + "f 1 2 3\n", "f.obj");
    EXPECT_FALSE(none.file);
    EXPECT_THAT(none.errors.at(0).message, HasSubstr("no curve or surface"));
}

TEST(ObjFreeform, RefusesStatementsThatAreNotWhole) {
    const auto message = [](const std::string& rest) { return refusal(four_vertices + rest).message; };
    EXPECT_THAT(message("v 1 2\n"), HasSubstr("3, 4 or 6 numbers, not 2"));
    EXPECT_THAT(message("v 1 2 3 4 5\n"), HasSubstr("not 5"));
    EXPECT_THAT(message("v 1 2 3 4 5 6 7\n"), HasSubstr("no more"));
    for (const std::string bad : {"nan", "inf", "1e400", "1,5", "0x1"})
        EXPECT_THAT(message("v 0 0 " + bad + "\n"), HasSubstr("is not a number")) << bad;
    EXPECT_THAT(message("cstype\n"), HasSubstr("needs a type"));
    EXPECT_THAT(message("cstype bspline rat\n"), HasSubstr("one word too many"));
    EXPECT_THAT(message("deg\n"), HasSubstr("needs a degree"));
    EXPECT_THAT(message("deg 0\n"), HasSubstr("whole number from 1"));
    EXPECT_THAT(message("deg 1000001\n"), HasSubstr("to 1000000"));
    EXPECT_THAT(message("deg 3 3 3\n"), HasSubstr("one word too many"));
    EXPECT_THAT(message("parm u 0 1\n"), HasSubstr("outside"));
    EXPECT_THAT(message("end\n"), HasSubstr("outside"));
    const auto inside = [&](const std::string& rest) {
        return message("cstype bspline\ndeg 1\ncurv 0 1 1 2\n" + rest);
    };
    EXPECT_THAT(inside(""), HasSubstr("`curv` without `end`"));
    EXPECT_THAT(inside("curv 0 1 1 2\n"), HasSubstr("before the `end` of `curv`"));
    EXPECT_THAT(inside("parm w 0 1\n"), HasSubstr("u or v"));
    EXPECT_THAT(inside("parm\n"), HasSubstr("u or v"));
    EXPECT_THAT(inside("parm v 0 1\n"), HasSubstr("no parameter v"));
    EXPECT_THAT(inside("parm u 0 0 1 1\nparm u 0 0 1 1\nend\n"), HasSubstr("twice"));
    for (const std::string bad : {"nan", "1/2", "+-1", "1e401", "0x1", "--1"})
        EXPECT_THAT(inside("parm u 0 0 1 " + bad + "\nend\n"), HasSubstr("is not a decimal number")) << bad;
    EXPECT_THAT(message("cstype bspline\ndeg 1\ncurv 0\n"), HasSubstr("range of its parameters"));
    EXPECT_THAT(message("v 0 0 0 0\ncstype rat bspline\ndeg 1\ncurv 0 1 1 -1\n"),
                HasSubstr("weight of vertex -1 is 0"));
    EXPECT_THAT(message("v 0 0 0 -2\ncstype rat bspline\ndeg 1\ncurv 0 1 5 1\n"),
                HasSubstr("weight of vertex 5 is -2"));
}

TEST(ObjFreeform, KeepsItsLimits) {
    const std::string curve = "curv 0 1 1 2\nparm u 0 0 1 1\nend\n";
    EXPECT_TRUE(read_obj_freeform(head + curve, "f", {.vertices = 4, .knots = 4}).file);
    EXPECT_THAT(refusal(head + curve, {.vertices = 3, .knots = 4}).message, HasSubstr("more than 3 vertices"));
    EXPECT_THAT(refusal(head + curve, {.vertices = 4, .knots = 3}).message, HasSubstr("more than 3 knots"));
    EXPECT_THAT(refusal(head + curve + curve + curve, {.vertices = 4, .knots = 12}).message,
                HasSubstr("more than 4 control points"));
}

TEST(ObjFreeform, GivesOneErrorForOneMistake) {
    const ParsedFreeForms parsed =
        read_obj_freeform(head + "curv 0 1 1 9\nparm u 0 0 1 1\nend\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n", "f.obj");
    EXPECT_THAT(parsed.errors, SizeIs(1));
    EXPECT_THAT(read_obj_freeform(four_vertices + "cstype bezier\ncurv 0 1 7 8\nend\n", "f.obj").errors, SizeIs(1));
    std::string many = head;
    for (int i = 0; i < 1000; ++i) many += "curv 0 1 1 9\nend\n";
    EXPECT_THAT(read_obj_freeform(many, "f.obj").errors, SizeIs(max_polygon_errors));
}

TEST(ObjFreeform, KnowsOneFromATable) {
    for (const std::string text : {"v 0 0 0\n", "# x\n\n  cstype bspline", "\n\\\n o name", "vn\t0 0 1"})
        EXPECT_TRUE(looks_like_obj(text)) << text;
    for (const std::string text : {"", "#", "x,y\n0,0\n", "v,w\n0,1\n", "v", "1 2 3", "deg\n1\n", "{\"points\":[]}"})
        EXPECT_FALSE(looks_like_obj(text)) << text;
}

TEST(ObjFreeform, AnswersClearlyForEveryPrefixAndEveryDamagedByte) {
    const std::string text = "# c\n" + four_vertices +
                             "vt 0 0\ncstype rat bspline\ndeg 1 1\nsurf 0 1 2 3 1/1 2//\\\n 4 -2\nparm u 0 0 1 1\n"
                             "parm v 2 2 3 3.\nend\n";
    const auto expect_clear = [](const std::string& one) {
        const ParsedFreeForms parsed = read_obj_freeform(one, "f.obj");
        ASSERT_EQ(parsed.file.has_value(), parsed.errors.empty()) << one;
        for (const Diagnostic& error : parsed.errors)
            ASSERT_TRUE(!error.message.empty() &&
                        (error.message.starts_with("no curve or surface") || (error.line >= 1 && error.column >= 1)))
                << one;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        expect_clear(text.substr(0, i));
        for (const char damage : {'\0', '\xFF', '\n', '"', '\\', '#'}) {
            std::string damaged = text;
            damaged[i] = damage;
            expect_clear(damaged);
        }
    }
}

} // namespace
} // namespace internode
