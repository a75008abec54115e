// SPDX-License-Identifier: MIT

#include "internode/io/file/limits.h"
#include "internode/io/polygon.h"
#include "internode/text/number.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <random>
#include <string>
#include <utility>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

InputPolygon read(std::string_view text) {
    ParsedPolygon parsed = read_polygon_csv(text, "p.csv");
    EXPECT_TRUE(parsed.polygon) << text << '\n' << (parsed.errors.empty() ? "" : parsed.errors.front().message);
    return parsed.polygon ? *std::move(parsed.polygon) : InputPolygon();
}

Diagnostic refusal(std::string_view text) {
    ParsedPolygon parsed = read_polygon_csv(text, "p.csv");
    EXPECT_FALSE(parsed.polygon) << text;
    EXPECT_FALSE(parsed.errors.empty()) << text;
    return parsed.errors.empty() ? Diagnostic{} : parsed.errors.front();
}

TEST(PolygonCsv, ReadsPointsWithAndWithoutHeader) {
    const InputPolygon plain = read("0,0\n0.25,1\n-1e-3,+2");
    EXPECT_EQ(plain.dimension, 2U);
    EXPECT_EQ(plain.size(), 3U);
    EXPECT_THAT(plain.points, ElementsAre(0, 0, 0.25, 1, -0.001, 2));
    EXPECT_THAT(plain.columns, IsEmpty());
    EXPECT_EQ(plain.source, "p.csv");
    const InputPolygon named = read("x , \"y, \"\"north\"\"\"\n1,2\n");
    EXPECT_THAT(named.columns, ElementsAre("x", "y, \"north\""));
    EXPECT_THAT(named.points, ElementsAre(1, 2));
}

TEST(PolygonCsv, ReadsEveryDimensionUpToTheLimit) {
    EXPECT_THAT(read("1\n2\n3\n").points, ElementsAre(1, 2, 3));
    std::string line = "1";
    for (std::size_t i = 1; i < max_dimension; ++i) line += ",1";
    EXPECT_EQ(read(line).dimension, max_dimension);
    const Diagnostic error = refusal(line + ",1");
    EXPECT_EQ(error.column, 2 * max_dimension + 1);
    EXPECT_THAT(error.message, HasSubstr("64"));
}

TEST(PolygonCsv, TakesTheSeparatorOfTheFirstLine) {
    EXPECT_THAT(read("1;2\n3 ; 4\n").points, ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(read("1\t2\n3 \t 4\n").points, ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(read("1;\t2\n3;4\n").points, ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(refusal("1,\t2\n").message, HasSubstr("`1,` is not a number")) << "a tab before a comma";
}

TEST(PolygonCsv, PassesOverCommentsMarksAndBlankLinesAtBothEnds) {
    const InputPolygon polygon =
        read("\xEF\xBB\xBF# comment, 1\r\n\r\nx,y\r\n  \t\r\n1,2\r\n # x\r\n\"3\", 4 \r\n\r\n \r\n");
    EXPECT_THAT(polygon.columns, ElementsAre("x", "y"));
    EXPECT_THAT(polygon.points, ElementsAre(1, 2, 3, 4));
}

std::vector<InputPolygon> parts(std::string_view text) {
    ParsedPolygons parsed = read_polygons_csv(text, "p.csv");
    EXPECT_TRUE(parsed.errors.empty()) << to_string(parsed.errors);
    return std::move(parsed.polygons);
}

TEST(PolygonCsv, IsPartedByBlankLines) {
    const std::vector<InputPolygon> two = parts("x,y\n0,0\n1,1\n \t\n2,2\n# c\n3,3\n4,4\n\n");
    ASSERT_EQ(two.size(), 2U);
    EXPECT_THAT(two[0].points, ElementsAre(0, 0, 1, 1));
    EXPECT_THAT(two[1].points, ElementsAre(2, 2, 3, 3, 4, 4));
    EXPECT_THAT(two[1].columns, ElementsAre("x", "y"));
    EXPECT_EQ(two[0].break_text, "");
    EXPECT_EQ(two[1].break_text, "\n");
    EXPECT_EQ(two[1].line, 5U);
    EXPECT_EQ(parts("1,1\n\n\n\n2,2\n")[1].break_text, "\n\n");
    EXPECT_EQ(parts("x,y\n1,1\n\nx,y\n2,2\n").size(), 2U);
}

TEST(PolygonCsv, IsPartedByHeads) {
    const std::vector<InputPolygon> two = parts("> road A\n0\t0\n1\t1\n>\n2\t2\n");
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(two[0].break_text, "> road A\n");
    EXPECT_EQ(two[1].break_text, ">\n");
    EXPECT_EQ(parts("0,0\n\n> b\n\n2,2\n")[1].break_text, "\n> b\n");
    EXPECT_EQ(parts("> alone\n0,0\n").size(), 1U);
}

TEST(PolygonCsv, RefusesAPartWithoutPoints) {
    const Diagnostic between = refusal("0,0\n> a\n> b\n1,1\n");
    EXPECT_EQ(between.line, 2U);
    EXPECT_THAT(between.message, HasSubstr("no point follows"));
    EXPECT_EQ(refusal("0,0\n> a\n").line, 2U);
    EXPECT_THAT(refusal("0,0\n\n1\n").message, HasSubstr("the first line has 2"));
    const Diagnostic second = refusal("0,0\n\n1,1\n");
    EXPECT_EQ(second.line, 3U);
    EXPECT_THAT(second.message, HasSubstr("a second polygon"));
}

/// Enough lines for several windows; `odd` of them, spread unevenly, are what a run of points must stop at.
std::string long_text(std::size_t lines, std::size_t odd, bool quoted) {
    std::mt19937_64 random(7);
    std::string text = "x,y\n";
    for (std::size_t i = 0; i < lines; ++i) {
        const std::string x = to_string(static_cast<double>(random()) * 0x1p-64);
        const std::string y = to_string(-static_cast<double>(random()) * 0x1p-70);
        text += quoted ? '"' + x + "\", \"" + y + "\"\n" : x + ", " + y + (i % 5 == 0 ? "\r\n" : "\n");
        if (odd == 0 || random() % (lines / odd) != 0) continue;
        constexpr std::string_view kinds[] = {"# a comment\n", "\n", "> a part\n", "\"1\", 2\n", " \t 3 ,4\n"};
        text += kinds[random() % std::size(kinds)];
    }
    return text;
}

TEST(PolygonCsv, ReadsLongRunsOfPointsLikeSingleLines) {
    for (const std::size_t odd : {0U, 1U, 9U, 3'000U})
        for (const std::size_t lines : {6'000U, 60'000U}) {
            const std::vector<InputPolygon> expected =
                parts(long_text(lines, odd, true) + "0,0\n"); // quotes stop every run
            const std::string text = long_text(lines, odd, false) + "0,0\n";
            for (const int threads : {1, 2, 0}) {
                const ParsedPolygons read = read_polygons_csv(text, "p.csv", threads);
                ASSERT_EQ(read.polygons.size(), expected.size()) << odd << " odd lines, " << threads << " threads";
                for (std::size_t i = 0; i < expected.size(); ++i) {
                    EXPECT_EQ(read.polygons[i].points, expected[i].points);
                    EXPECT_EQ(read.polygons[i].line, expected[i].line);
                    EXPECT_EQ(read.polygons[i].break_text, expected[i].break_text);
                }
            }
        }
}

TEST(PolygonCsv, FindsTheFaultBehindALongRun) {
    const std::string points = long_text(40'000, 0, false);
    const std::pair<std::string_view, std::string_view> faults[] = {{"1,2,3", "3 coordinates"},
                                                                    {"1,2,x", "3 coordinates"},
                                                                    {"1", "1 coordinate,"},
                                                                    {"1,x", "`x`"},
                                                                    {"1,", "an empty field"}};
    for (const auto& [line, message] : faults) {
        const ParsedPolygons read = read_polygons_csv(points + std::string(line) + "\n5,6\n", "p.csv", 2);
        ASSERT_EQ(read.errors.size(), 1U) << line;
        EXPECT_EQ(read.errors.front().line, 40'002U);
        EXPECT_THAT(read.errors.front().message, HasSubstr(message));
    }
}

TEST(PolygonCsv, KeepsNumbersBitForBit) {
    const InputPolygon polygon = read("0.1,-0,5e-324,1.7976931348623157e308");
    EXPECT_EQ(std::bit_cast<std::uint64_t>(polygon.points[1]), std::bit_cast<std::uint64_t>(-0.0));
    EXPECT_EQ(polygon.points[2], 5e-324);
    EXPECT_EQ(polygon.points[3], 1.7976931348623157e308);
}

TEST(PolygonCsv, RefusesRaggedLinesWithBothCounts) {
    const Diagnostic error = refusal("1,2\n3,4,5\n");
    EXPECT_EQ(error.line, 2U);
    EXPECT_EQ(error.column, 5U);
    EXPECT_THAT(error.message, HasSubstr("3 coordinates"));
    EXPECT_THAT(error.message, HasSubstr("has 2"));
    EXPECT_EQ(error.source_line, "3,4,5");
    EXPECT_THAT(refusal("1,2\n3\n").message, HasSubstr("1 coordinate,"));
    EXPECT_THAT(refusal("x,y\n3;4\n").hint, HasSubstr("separated by `,`"));
    EXPECT_THAT(refusal("1,2\n3,4,\n").message, HasSubstr("3 coordinates"));
}

TEST(PolygonCsv, RefusesNumbersThatAreNotFinite) {
    for (const char* text : {"1,nan\n", "1,-inf\n", "1,Infinity\n", "nan,1\n", "inf,NaN\n"})
        EXPECT_THAT(refusal(text).message, HasSubstr("not a finite number")) << text;
    const Diagnostic error = refusal("x,y\n1,2\n1,1e400\n");
    EXPECT_EQ(error.line, 3U);
    EXPECT_EQ(error.column, 3U);
    EXPECT_EQ(error.width, 5U);
    EXPECT_THAT(error.message, HasSubstr("range of doubles"));
}

TEST(PolygonCsv, RefusesADecimalCommaWithAHint) {
    const Diagnostic error = refusal("x;y\n1,5;2\n");
    EXPECT_EQ(error.line, 2U);
    EXPECT_EQ(error.column, 1U);
    EXPECT_THAT(error.hint, HasSubstr("write 1.5"));
    EXPECT_THAT(refusal("1,5\t2,5\n").hint, HasSubstr("write 1.5"));
}

TEST(PolygonCsv, RefusesWhatIsNoNumber) {
    EXPECT_THAT(refusal("1,2\nx,y\n").message, HasSubstr("`x` is not a number"));
    EXPECT_THAT(refusal("1,\n").message, HasSubstr("empty field"));
    EXPECT_THAT(refusal("x,\n").message, HasSubstr("`x` is not a number"));
    EXPECT_THAT(refusal("1 2\n3 4\n").hint, HasSubstr("separated by `,`"));
    EXPECT_THAT(refusal("1,2 # comment\n").message, HasSubstr("is not a number"));
    EXPECT_THAT(refusal("1," + std::string(1'000'000, '9') + "x\n").message, HasSubstr("..."));
}

TEST(PolygonCsv, RefusesDamagedQuotes) {
    const Diagnostic open = refusal("1,2\n3,\"4\n");
    EXPECT_EQ(open.column, 3U);
    EXPECT_THAT(open.message, HasSubstr("not closed"));
    EXPECT_THAT(refusal("\"1\"x,2\n").message, HasSubstr("after a closed quote"));
    EXPECT_THAT(refusal("\"1\"\"\n").message, HasSubstr("not closed"));
}

TEST(PolygonCsv, RefusesATextWithoutAPoint) {
    for (const char* text : {"", "\n", "# nothing\n", "x,y\n", "\xEF\xBB\xBF", "\r\n\r\n"}) {
        const Diagnostic error = refusal(text);
        EXPECT_EQ(error.message, "no point");
        EXPECT_EQ(error.line, 0U);
    }
}

TEST(PolygonCsv, ReportsAllBadLinesUpToALimit) {
    const ParsedPolygon two = read_polygon_csv("1,2\na,b\n3,4\n5\n", "p");
    ASSERT_EQ(two.errors.size(), 2U);
    EXPECT_EQ(two.errors[0].line, 2U);
    EXPECT_EQ(two.errors[1].line, 4U);
    std::string many = "1,2\n";
    for (int i = 0; i < 100'000; ++i) many += "x\n";
    EXPECT_EQ(read_polygon_csv(many, "p").errors.size(), max_polygon_errors);
}

TEST(PolygonCsv, CountsColumnsInCodePoints) {
    const Diagnostic error = refusal("\xCF\x86,y\n\"1\",\xCF\x86\xCF\x86\n");
    EXPECT_EQ(error.line, 2U);
    EXPECT_EQ(error.column, 5U);
    EXPECT_EQ(error.width, 2U);
}

/// Success, or a message with a place in the text (line 0 only for "no point").
void expect_clear_answer(std::string_view text) {
    const ParsedPolygon parsed = read_polygon(text, "p");
    ASSERT_EQ(parsed.polygon.has_value(), parsed.errors.empty());
    for (const Diagnostic& error : parsed.errors) {
        ASSERT_FALSE(error.message.empty());
        ASSERT_TRUE(error.message == "no point" || (error.line >= 1 && error.column >= 1)) << error.message;
        ASSERT_LE(error.line, 1U + static_cast<std::size_t>(std::ranges::count(text, '\n')));
    }
}

TEST(PolygonCsv, AnswersClearlyForEveryPrefixAndEveryDamagedByte) {
    const std::string csv = "\xEF\xBB\xBF# c\r\nx,\"y\"\r\n0,0.25\r\n1e-3,-2\r\n\"3\",4\r\n";
    const std::string json = "{\"format\": \"internode-curve\", \"version\": 1, \"degree\": 3, \"closed\": false,\n"
                             " \"word\": [\"L\", \"S\"], \"lengths\": {\"L\": \"3/2\", \"S\": {\"exact\": [\"1\"]}},\n"
                             " \"points\": [[0, 0.5], [1e0, -2]]}\n";
    for (const std::string& text : {csv, json}) {
        ASSERT_TRUE(read_polygon(text, "p").polygon);
        for (std::size_t i = 0; i <= text.size(); ++i) expect_clear_answer(std::string_view(text).substr(0, i));
        for (std::size_t i = 0; i < text.size(); ++i)
            for (const char damage : {'\0', '\xFF', '\n', '"', '{', '9', ' '}) {
                std::string damaged = text;
                damaged[i] = damage;
                expect_clear_answer(damaged);
            }
    }
}

TEST(PolygonCsv, IsToldFromJsonByItsFirstCharacter) {
    EXPECT_EQ(read_polygon("\xEF\xBB\xBF \n[[1,2]]", "p").polygon.value().dimension, 2U);
    EXPECT_EQ(read_polygon(" 1,2,3", "p").polygon.value().dimension, 3U);
}

} // namespace
} // namespace internode
