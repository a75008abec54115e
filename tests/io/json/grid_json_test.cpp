// SPDX-License-Identifier: MIT

#include "internode/io/json/grid_json.h"

#include "internode/io/file/limits.h"
#include "internode/io/json/input_grid.h"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

namespace internode {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Two rows of three points.
GridDocument small_grid(std::span<const double> coordinates) {
    static const Word u{to_symbol(0), to_symbol(1)};
    static const Word v{zero_interval, to_symbol(0), zero_interval, to_symbol(0), zero_interval};
    GridDocument grid;
    grid.version = "0.1.0";
    grid.command = "internode subdivide";
    grid.sides[0] = {2, Ends::Circular, {"L", "S"}, u, {{"L", 0.2360679774997897, {"-3", "2"}}, {"S", 1, {}}}, {}, {}};
    grid.sides[1] = {2, Ends::Open, {"A"}, v, {}, {}, {}};
    grid.columns = 3;
    grid.points = {1, coordinates};
    return grid;
}

TEST(GridJson, WritesADocument) {
    const std::vector<double> coordinates{0, 1, 0.5, -2, 3, 4};
    StringSink sink;
    EXPECT_TRUE(write_grid_json(sink, small_grid(coordinates)));
    EXPECT_EQ(sink.text(), R"({
  "format": "internode-grid",
  "version": 1,
  "generator": {"version": "0.1.0", "command": "internode subdivide"},
  "degree": [2, 2],
  "closed": [true, false],
  "rational": false,
  "word": [
    ["L", "S"],
    ["0", "A", "0", "A", "0"]
  ],
  "lengths": [
    {
      "L": {"value": 0.2360679774997897, "exact": ["-3", "2"]}
    },
    {}
  ],
  "points": [
    [
      [0],
      [1],
      [0.5]
    ],
    [
      [-2],
      [3],
      [4]
    ]
  ]
}
)");
}

TEST(GridJson, IsReadBack) {
    const std::vector<double> coordinates{0.1, 1e-300, -0.0, 3, 5, 1.7976931348623157e308};
    StringSink sink;
    GridDocument document = small_grid(coordinates);
    document.rational = true;
    document.columns = 1;
    document.points.dimension = 3;
    ASSERT_TRUE(write_grid_json(sink, document));
    const ParsedGrid parsed = read_grid_json(sink.text(), "g");
    ASSERT_TRUE(parsed.grid.has_value());
    EXPECT_EQ(parsed.grid->points, coordinates);
    EXPECT_EQ(parsed.grid->rows, 2u);
    EXPECT_EQ(parsed.grid->columns, 1u);
    EXPECT_EQ(parsed.grid->dimension, 3u);
    EXPECT_TRUE(parsed.grid->rational);
    const auto& [u, v] = parsed.grid->sides;
    EXPECT_EQ(u.degree, 2u);
    EXPECT_EQ(u.closed, true);
    EXPECT_EQ(v.closed, false);
    EXPECT_EQ(u.word_letters.value().at(1).text, "S");
    EXPECT_EQ(v.word_letters.value().at(0).text, "0");
    EXPECT_THAT(u.lengths.at(0).coefficients, ElementsAre(Rational(-3), Rational(2)));
    EXPECT_THAT(v.lengths, IsEmpty());
}

TEST(GridJson, RefusesToWriteWhatDoesNotFit) {
    const std::vector<double> four{1, 2, 3, 4};
    StringSink sink;
    EXPECT_THROW(write_grid_json(sink, small_grid(four)), std::invalid_argument);
    GridDocument rows = small_grid(four);
    rows.columns = 0;
    EXPECT_THROW(write_grid_json(sink, rows), std::invalid_argument);
    rows.columns = 2;
    rows.sides[0].symbols = {"L"};
    EXPECT_THROW(write_grid_json(sink, rows), std::out_of_range);
    const std::vector<double> infinite{1, std::numeric_limits<double>::infinity()};
    GridDocument bad = small_grid(infinite);
    bad.columns = 2;
    EXPECT_THROW(write_grid_json(sink, bad), std::invalid_argument);
}

std::vector<std::string> problems(std::string_view text) {
    const ParsedGrid parsed = read_grid_json(text, "g");
    EXPECT_EQ(parsed.grid.has_value(), parsed.errors.empty());
    std::vector<std::string> messages;
    for (const Diagnostic& error : parsed.errors) {
        EXPECT_GT(error.line, 0u);
        EXPECT_GT(error.column, 0u);
        messages.push_back(error.message);
    }
    return messages;
}

TEST(InputGrid, NeedsItsPointsOnly) {
    const ParsedGrid parsed =
        read_grid_json(R"({"points":[[[1,2],[3,4]]],"degree":[3,null],"word":null,"x-mine":0})", "g");
    ASSERT_TRUE(parsed.grid.has_value());
    EXPECT_EQ(parsed.grid->rows, 1u);
    EXPECT_EQ(parsed.grid->columns, 2u);
    EXPECT_FALSE(parsed.grid->rational);
    EXPECT_EQ(parsed.grid->sides[0].degree, 3u);
    EXPECT_FALSE(parsed.grid->sides[1].degree.has_value());
    EXPECT_FALSE(parsed.grid->sides[0].closed.has_value());
}

TEST(InputGrid, TakesWordsAsTextsOrArrays) {
    const ParsedGrid parsed =
        read_grid_json("\xEF\xBB\xBF"
                       R"({"word":["(LS)^2",["A1","0"]],"points":[[[1]]],"lengths":[{"L":"3/2"},null]})",
                       "g");
    ASSERT_TRUE(parsed.grid.has_value());
    EXPECT_EQ(parsed.grid->sides[0].word_text.value().text, "(LS)^2");
    EXPECT_THAT(parsed.grid->sides[1].word_letters.value(), SizeIs(2));
    EXPECT_THAT(parsed.grid->sides[0].lengths.at(0).coefficients, ElementsAre(Rational(3, 2)));
}

TEST(InputGrid, TakesKnotsOfEitherSide) {
    const auto read = [](const std::string& rest) {
        return read_grid_json("{\"points\":[[[0],[1]],[[2],[3]]]," + rest + "}", "g");
    };
    const ParsedGrid parsed = read(R"("knots":[[0,"1/2",{"exact":["1","2"]}],null],"word":[null,"LL"])");
    ASSERT_TRUE(parsed.grid.has_value());
    EXPECT_THAT(parsed.grid->sides[0].knots.value(),
                ElementsAre(ElementsAre(0), ElementsAre(Rational(1, 2)), ElementsAre(1, 2)));
    EXPECT_FALSE(parsed.grid->sides[1].knots);
    const auto message = [&](const std::string& rest) { return read(rest).errors.at(0).message; };
    EXPECT_THAT(message(R"("origin":[0])"), HasSubstr("array of two"));
    EXPECT_THAT(message(R"("origin":[0,"x"])"), HasSubstr("exact number"));
    EXPECT_THAT(message(R"("knots":[0,1,2])"), HasSubstr("array of two"));
    EXPECT_THAT(message(R"("knots":[0,1])"), HasSubstr("an array of at most 5000000 knots"));
    EXPECT_THAT(message(R"("knots":[["x"],null])"), HasSubstr("exact number"));
}

TEST(InputGrid, RefusesWhatIsNoGrid) {
    const auto with = [](const std::string& members) { return "{" + members + R"(,"points":[[[1],[2]]]})"; };
    EXPECT_THAT(problems("[1]"), ElementsAre("a grid is an object, not an array"));
    EXPECT_THAT(problems("{}"), ElementsAre("the grid has no `points`"));
    EXPECT_THAT(problems("{"), SizeIs(1));
    EXPECT_THAT(problems(with(R"("format":"internode-curve")")), ElementsAre(HasSubstr("internode-grid")));
    EXPECT_THAT(problems(with(R"("version":2)")), ElementsAre("`version` must be 1"));
    EXPECT_THAT(problems(with(R"("degree":3)")), ElementsAre(HasSubstr("array of two")));
    EXPECT_THAT(problems(with(R"("degree":[3,3,3])")), ElementsAre(HasSubstr("array of two")));
    EXPECT_THAT(problems(with(R"("degree":[3,-1])")), ElementsAre(HasSubstr("whole number")));
    EXPECT_THAT(problems(with(R"("closed":[0,true])")), ElementsAre("`closed` must be true or false, not a number"));
    EXPECT_THAT(problems(with(R"("rational":1)")), ElementsAre("`rational` must be true or false, not a number"));
    EXPECT_THAT(problems(with(R"("word":["L",7])")), ElementsAre(HasSubstr("array of symbols or a string")));
    EXPECT_THAT(problems(with(R"("word":["L",[7]])")), ElementsAre(HasSubstr("must be a string")));
    EXPECT_THAT(problems(with(R"("lengths":[[],null])")), ElementsAre("`lengths` must be an object, not an array"));
    EXPECT_THAT(problems(with(R"("lengths":[{"L":{}},null])")), ElementsAre(HasSubstr("needs `exact`")));
    EXPECT_THAT(problems(with(R"("lengths":[{"L":true},null])")), ElementsAre(HasSubstr("an exact number")));
    EXPECT_THAT(problems(with(R"("wrod":0)")), ElementsAre("a grid has no key `wrod`"));
    EXPECT_THAT(problems(with(R"("rational":true)")), ElementsAre(HasSubstr("and the weight")));
}

TEST(InputGrid, RefusesRowsThatDoNotFit) {
    EXPECT_THAT(problems(R"({"points":7})"), ElementsAre("`points` must be an array of rows, not a number"));
    EXPECT_THAT(problems(R"({"points":[]})"), ElementsAre("no point"));
    EXPECT_THAT(problems(R"({"points":[[]]})"), ElementsAre("a row without points"));
    EXPECT_THAT(problems(R"({"points":[7]})"), ElementsAre("a row must be an array of points, not a number"));
    EXPECT_THAT(problems(R"({"points":[[7]]})"), ElementsAre("a point must be an array of numbers, not a number"));
    EXPECT_THAT(problems(R"({"points":[[[1],[2]],[[3]]]})"), ElementsAre("1 points, but the first row has 2"));
    EXPECT_THAT(problems(R"({"points":[[[1],[2,3]]]})"), ElementsAre("2 coordinates, but the first point has 1"));
    EXPECT_THAT(problems(R"({"points":[[[]]]})"), ElementsAre(HasSubstr("1 to 64 coordinates, not 0")));
    EXPECT_THAT(problems(R"({"points":[[["1"]]]})"), ElementsAre("a coordinate must be a number, not a string"));
    EXPECT_THAT(problems(R"({"points":[[[1e999]]]})"), SizeIs(1));
}

TEST(InputGrid, GivesUpAfterManyErrors) {
    std::string text = R"({"points":[[)";
    for (int i = 0; i < 1000; ++i) text += "7,";
    EXPECT_THAT(problems(text + "7]]}"), SizeIs(max_polygon_errors));
}

TEST(InputGrid, AnswersClearlyForEveryPrefixAndEveryDamagedByte) {
    const std::vector<double> coordinates{0, 1, 0.5, -2, 3, 4};
    StringSink sink;
    ASSERT_TRUE(write_grid_json(sink, small_grid(coordinates)));
    const std::string& text = sink.text();
    for (std::size_t i = 0; i + 2 < text.size(); ++i) EXPECT_THAT(problems(text.substr(0, i)), SizeIs(1)) << i;
    for (std::size_t i = 0; i < text.size(); ++i)
        for (const char damage : {'\0', '\xFF', '\n', '"'}) {
            std::string damaged = text;
            damaged[i] = damage;
            (void)problems(damaged);
        }
}

} // namespace
} // namespace internode
