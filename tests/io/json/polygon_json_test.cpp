// SPDX-License-Identifier: MIT

#include "internode/io/file/limits.h"
#include "internode/io/polygon.h"
#include "tests/fixtures/stride.h"

#include <string>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

InputPolygon read_curve(std::string_view text) {
    ParsedPolygon parsed = read_polygon_json(text, "p.json");
    EXPECT_TRUE(parsed.polygon) << text << '\n' << (parsed.errors.empty() ? "" : parsed.errors.front().message);
    return parsed.polygon ? *std::move(parsed.polygon) : InputPolygon();
}

Diagnostic curve_refusal(std::string_view text) {
    ParsedPolygon parsed = read_polygon_json(text, "p.json");
    EXPECT_FALSE(parsed.polygon) << text;
    EXPECT_FALSE(parsed.errors.empty()) << text;
    return parsed.errors.empty() ? Diagnostic{} : parsed.errors.front();
}

TEST(PolygonJson, ReadsACurveWithEveryKey) {
    const InputPolygon curve =
        read_curve(R"({"format":"internode-curve","version":1,"generator":{"version":"0","command":""},
        "degree":3,"closed":true,"word":["L","S1","0"],"points":[[0,1],[2.5,-0],[1e2,3]],"x-note":[],
        "lengths":{"L":"3/2","S1":0.1,"T":{"value":0.2360679774997897,"exact":["-3","2"]}}})");
    EXPECT_EQ(curve.degree, 3U);
    EXPECT_EQ(curve.closed, true);
    EXPECT_EQ(curve.dimension, 2U);
    EXPECT_THAT(curve.points, ElementsAre(0, 1, 2.5, -0.0, 100, 3));
    ASSERT_TRUE(curve.word_letters);
    ASSERT_EQ(curve.word_letters->size(), 3U);
    EXPECT_EQ((*curve.word_letters)[1].text, "S1");
    EXPECT_EQ((*curve.word_letters)[1].place.line, 2U);
    EXPECT_EQ((*curve.word_letters)[1].place.column, 46U);
    EXPECT_FALSE(curve.word_text);
    ASSERT_EQ(curve.lengths.size(), 3U);
    EXPECT_EQ(curve.lengths[0].symbol.text, "L");
    EXPECT_THAT(curve.lengths[0].coefficients, ElementsAre(Rational(3, 2)));
    EXPECT_THAT(curve.lengths[1].coefficients, ElementsAre(Rational(1, 10)));
    EXPECT_THAT(curve.lengths[2].coefficients, ElementsAre(Rational(-3), Rational(2)));
}

TEST(PolygonJson, ReadsBarePointsAndAWordAsText) {
    const InputPolygon bare = read_curve("[[1],[2]]");
    EXPECT_EQ(bare.dimension, 1U);
    EXPECT_FALSE(bare.degree || bare.closed || bare.word_text || bare.word_letters);
    const InputPolygon word =
        read_curve("{\"points\":[[1,2,3]],\n\"word\":\"(LS)^4\",\"degree\":null,\"lengths\":null}");
    EXPECT_EQ(word.word_text.value().text, "(LS)^4");
    EXPECT_EQ(word.word_text.value().place.line, 2U);
    EXPECT_FALSE(word.degree);
}

TEST(PolygonJson, ReadsKnotsAndWeights) {
    const InputPolygon curve = read_curve(R"({"degree":1,"points":[[0,1],[2,3],[4,5]],"weights":[1,0.5,2e-1],
        "knots":[0,"1/3",0.5,1,{"exact":["1/2","2"]}]})");
    EXPECT_THAT(curve.weights, ElementsAre(1, 0.5, 0.2));
    EXPECT_THAT(curve.knots.value(),
                ElementsAre(ElementsAre(0), ElementsAre(Rational(1, 3)), ElementsAre(Rational(1, 2)), ElementsAre(1),
                            ElementsAre(Rational(1, 2), 2)));
    const InputPolygon none = read_curve(R"({"points":[[0]],"knots":null,"weights":null})");
    EXPECT_FALSE(none.knots);
    EXPECT_TRUE(none.weights.empty());
}

TEST(PolygonJson, RefusesKnotsAndWeightsThatAreNone) {
    const auto message = [](const std::string& rest) {
        return curve_refusal("{\"points\":[[0],[1]]," + rest + "}").message;
    };
    EXPECT_THAT(message("\"knots\":3"), HasSubstr("must be an array"));
    EXPECT_THAT(message("\"knots\":[0,true]"), HasSubstr("exact number"));
    EXPECT_THAT(message("\"knots\":[0,\"nan\"]"), HasSubstr("exact number"));
    EXPECT_THAT(message("\"knots\":[0,{\"value\":1}]"), HasSubstr("needs `exact`"));
    EXPECT_THAT(message("\"weights\":1"), HasSubstr("must be an array"));
    EXPECT_THAT(message("\"weights\":[1]"), HasSubstr("1 weights, but 2 points"));
    for (const std::string bad : {"0", "-1", "1e-101", "1e101", "\"1\"", "null"}) {
        const Diagnostic error = curve_refusal("{\"points\":[[0],[1]],\n\"weights\":[1," + bad + "]}");
        EXPECT_THAT(error.message, HasSubstr("from 1e-100 to 1e+100"));
        EXPECT_EQ(error.line, 2U);
        EXPECT_EQ(error.column, 14U);
    }
}

TEST(PolygonJson, RefusesTheFirstKnotBeyondTheLimit) {
    if (!tests::in_full()) GTEST_SKIP() << "five million knots";
    std::string many = "{\"points\":[[0],[1]],\"knots\":[0";
    for (std::uint64_t i = 0; i < max_knots; ++i) many += ",0";
    EXPECT_THAT(curve_refusal(many + "]}").message, HasSubstr("5000001 knots, more than the limit of 5000000"));
}

TEST(PolygonJson, RefusesUnknownKeysWithWhatWasMeant) {
    const Diagnostic error = curve_refusal("{\"points\":[[1]],\n \"degre\":3}");
    EXPECT_EQ(error.line, 2U);
    EXPECT_EQ(error.column, 2U);
    EXPECT_THAT(error.message, HasSubstr("`degre`"));
    EXPECT_THAT(error.hint, HasSubstr("`degree`"));
    EXPECT_THAT(curve_refusal(R"({"points":[[1]],"qqqqqqqqqqq":3})").hint, HasSubstr("x-"));
}

TEST(PolygonJson, RefusesEachValueOfTheWrongKind) {
    const auto with = [](const std::string& entry) {
        return curve_refusal("{\"points\":[[1,2]]," + entry + "}").message;
    };
    EXPECT_THAT(with(R"("format":"internode-masks")"), HasSubstr("internode-curve"));
    EXPECT_THAT(with(R"("format":null)"), HasSubstr("internode-curve"));
    for (const char* version : {"2", "\"1\"", "1.0", "null"})
        EXPECT_THAT(with(std::string("\"version\":") + version), HasSubstr("must be 1"));
    for (const char* degree : {"-1", "1.5", "3e0", "\"3\"", "true", "1000001", "99999999999999999999999"})
        EXPECT_THAT(with(std::string("\"degree\":") + degree), HasSubstr("`degree`")) << degree;
    EXPECT_THAT(with(R"("closed":0)"), HasSubstr("not a number"));
    EXPECT_THAT(with(R"("word":3)"), HasSubstr("`word`"));
    EXPECT_THAT(with(R"("word":["L",3])"), HasSubstr("symbol of `word`"));
    EXPECT_THAT(with(R"("lengths":[])"), HasSubstr("`lengths`"));
}

TEST(PolygonJson, RefusesLengthsThatAreNotExact) {
    const auto with = [](const std::string& length) {
        return curve_refusal("{\"points\":[[1,2]],\"lengths\":{\"L\":" + length + "}}");
    };
    for (const char* length :
         {"\"x\"", "\"1/0\"", "\"\"", "true", "null", "[1]", "\"1e999999\"", "{\"exact\":[\"a\"]}"})
        EXPECT_THAT(with(length).message, HasSubstr("exact number")) << length;
    for (const char* length : {"{}", "{\"value\":1}", "{\"exact\":[]}", "{\"exact\":3}"})
        EXPECT_THAT(with(length).message, HasSubstr("needs `exact`")) << length;
    EXPECT_EQ(with("true").column, 34U);
    EXPECT_THAT(with("\"" + std::string(max_digits + 1, '1') + "\"").message, HasSubstr("1000"));
}

TEST(PolygonJson, RefusesPointsThatAreNone) {
    EXPECT_THAT(curve_refusal("3").message, HasSubstr("object or an array"));
    EXPECT_THAT(curve_refusal("{}").message, HasSubstr("no `points`"));
    EXPECT_THAT(curve_refusal("[]").message, HasSubstr("no point"));
    EXPECT_THAT(curve_refusal("{\"points\":null}").message, HasSubstr("not null"));
    EXPECT_THAT(curve_refusal("{\"points\":{}}").message, HasSubstr("not an object"));
    EXPECT_THAT(curve_refusal("[1,2]").hint, HasSubstr("[[0], [1]]"));
    EXPECT_THAT(curve_refusal("[[]]").message, HasSubstr("not 0"));
    EXPECT_THAT(curve_refusal("[[1,\"2\"]]").message, HasSubstr("not a string"));
    const Diagnostic ragged = curve_refusal("[[1,2],\n [3,4,5]]");
    EXPECT_EQ(ragged.line, 2U);
    EXPECT_EQ(ragged.column, 2U);
    EXPECT_THAT(ragged.message, HasSubstr("3 coordinates"));
    EXPECT_THAT(ragged.message, HasSubstr("has 2"));
    std::string wide = "[[1";
    for (std::size_t i = 0; i < max_dimension; ++i) wide += ",1";
    EXPECT_THAT(curve_refusal(wide + "]]").message, HasSubstr("64"));
}

TEST(PolygonJson, ReportsAllErrorsInTheOrderOfTheText) {
    const ParsedPolygon parsed = read_polygon_json("{\"points\":[[1],[\n1,2],[3]],\n\"degree\":-1,\"b\":0}", "p");
    ASSERT_EQ(parsed.errors.size(), 3U);
    EXPECT_EQ(parsed.errors[0].line, 1U);
    EXPECT_EQ(parsed.errors[1].line, 3U);
    EXPECT_EQ(parsed.errors[2].column, 13U);
    std::string many = "[[1,2]";
    for (int i = 0; i < 10'000; ++i) many += ",[1]";
    EXPECT_EQ(read_polygon_json(many + "]", "p").errors.size(), max_polygon_errors);
}

TEST(PolygonJson, PassesSyntaxErrorsOn) {
    EXPECT_EQ(curve_refusal("[[1,2],[3,NaN]]").column, 11U);
    EXPECT_THAT(curve_refusal("{\"points\":[[1]],\"points\":[[2]]}").message, HasSubstr("twice"));
}

} // namespace
} // namespace internode
