// SPDX-License-Identifier: MIT

#include "internode/io/json/curve_json.h"

#include "internode/io/polygon.h"

#include <stdexcept>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;

CurveDocument small_curve(std::span<const double> coordinates) {
    static const Word word{to_symbol(0), zero_interval, to_symbol(1)};
    CurveDocument curve;
    curve.version = "0.1.0";
    curve.command = "internode subdivide";
    curve.degree = 2;
    curve.ends = Ends::Circular;
    curve.symbols = {"L", "S"};
    curve.word = word;
    curve.lengths = {{"L", 0.2360679774997897, {"-3", "2"}}, {"S", 1, {}}};
    curve.points = {2, coordinates};
    return curve;
}

TEST(CurveJson, WritesADocument) {
    const std::vector<double> coordinates{0, 1, 0.5, -2};
    StringSink sink;
    EXPECT_TRUE(write_curve_json(sink, small_curve(coordinates)));
    EXPECT_EQ(sink.text(), R"({
  "format": "internode-curve",
  "version": 1,
  "generator": {"version": "0.1.0", "command": "internode subdivide"},
  "degree": 2,
  "closed": true,
  "word": ["L", "0", "S"],
  "lengths": {
    "L": {"value": 0.2360679774997897, "exact": ["-3", "2"]}
  },
  "points": [
    [0, 1],
    [0.5, -2]
  ]
}
)");
}

TEST(CurveJson, PutsOriginAndKnotsBesideTheWord) {
    const std::vector<double> coordinates{0, 1, 0.5, -2};
    CurveDocument curve = small_curve(coordinates);
    curve.origin = {5.5, {"11/2", "0"}};
    curve.knots = {5.5, 6, 7};
    StringSink sink;
    ASSERT_TRUE(write_curve_json(sink, curve));
    EXPECT_THAT(sink.text(), testing::HasSubstr("  \"origin\": {\"value\": 5.5, \"exact\": [\"11/2\", \"0\"]},\n"
                                                "  \"knots\": [5.5, 6, 7],\n  \"points\""));
    const InputPolygon back = read_polygon(sink.text(), "p").polygon.value();
    EXPECT_EQ(back.origin.value(), (InputNumber{Rational("11/2"), 0}));
    EXPECT_EQ(back.knots.value().size(), 3U);
}

TEST(CurveJson, WritesSeveralAsOneDocumentThatIsReadBack) {
    const std::vector<double> coordinates{0, 1, 0.5, -2};
    const std::vector<CurveDocument> curves(2, small_curve(coordinates));
    StringSink sink;
    ASSERT_TRUE(write_curves_json(sink, curves));
    const ParsedPolygons back = read_polygons(sink.text(), "p");
    ASSERT_EQ(back.polygons.size(), 2U);
    EXPECT_EQ(back.polygons[1].points, coordinates);
    EXPECT_GT(back.polygons[1].line, back.polygons[0].line);
    const auto refusal = [](std::string_view text) { return to_string(read_polygons(text, "p").errors); };
    const std::string head = R"({"format":"internode-curves")";
    EXPECT_THAT(refusal(head + "}"), testing::HasSubstr("no `curves`"));
    EXPECT_THAT(refusal(head + R"(,"curves":[]})"), testing::HasSubstr("no curve"));
    EXPECT_THAT(refusal(head + R"(,"curves":3})"), testing::HasSubstr("must be an array"));
    EXPECT_THAT(refusal(head + R"(,"curves":[{"points":[[0]]}],"color":1})"), testing::HasSubstr("no key `color`"));
    EXPECT_THAT(refusal(head + R"(,"curves":[{"points":[[0]]},{}]})"), testing::HasSubstr("no `points`"));
}

TEST(CurveJson, PutsWeightsBesideThePoints) {
    const std::vector<double> coordinates{0, 1, 0.5, -2, 3, 0.25};
    CurveDocument curve = small_curve(coordinates);
    curve.points.dimension = 3;
    curve.weighted = true;
    StringSink sink;
    ASSERT_TRUE(write_curve_json(sink, curve));
    EXPECT_THAT(sink.text(), testing::HasSubstr("    [0, 1],\n    [-2, 3]\n  ],\n  \"weights\": [0.5, 0.25]\n}"));
    const InputPolygon back = read_polygon(sink.text(), "p").polygon.value();
    EXPECT_THAT(back.points, ElementsAre(0, 1, -2, 3));
    EXPECT_THAT(back.weights, ElementsAre(0.5, 0.25));
    curve.points.dimension = 1;
    EXPECT_THROW(write_curve_json(sink, curve), std::invalid_argument);
}

TEST(CurveJson, IsReadBack) {
    const std::vector<double> coordinates{0.1, 1e-300, -0.0, 3};
    StringSink sink;
    ASSERT_TRUE(write_curve_json(sink, small_curve(coordinates)));
    const InputPolygon back = read_polygon(sink.text(), "p").polygon.value();
    EXPECT_EQ(back.points, coordinates);
    EXPECT_EQ(back.degree, 2U);
    EXPECT_EQ(back.closed, true);
    ASSERT_EQ(back.word_letters.value().size(), 3U);
    EXPECT_EQ((*back.word_letters)[2].text, "S");
    EXPECT_THAT(back.lengths.at(0).coefficients, ElementsAre(Rational(-3), Rational(2)));
}

TEST(CurveJson, RefusesWhatDoesNotFit) {
    const std::vector<double> three{1, 2, 3};
    const std::vector<double> two{1, 2};
    StringSink sink;
    EXPECT_THROW(write_curve_json(sink, small_curve(three)), std::invalid_argument);
    CurveDocument nameless = small_curve(two);
    nameless.symbols = {"L"};
    EXPECT_THROW(write_curve_json(sink, nameless), std::out_of_range);
}

} // namespace
} // namespace internode
