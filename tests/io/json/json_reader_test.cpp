// SPDX-License-Identifier: MIT

#include "internode/io/json/json_reader.h"

#include "internode/io/file/limits.h"
#include "tests/fixtures/small_stack.h"

#include <string>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::HasSubstr;

JsonValue read(std::string_view text) {
    ParsedJson json = read_json(text, "t.json");
    EXPECT_FALSE(json.error.has_value()) << (json.error ? json.error->message : "");
    return json.value ? *std::move(json.value) : JsonValue({}, {});
}

Diagnostic refusal(std::string_view text) {
    ParsedJson json = read_json(text, "t.json");
    EXPECT_FALSE(json.value) << text;
    EXPECT_TRUE(json.error) << text;
    return json.error.value_or(Diagnostic{});
}

std::string number(const JsonValue& value) {
    return value.number() == nullptr ? "none" : value.number()->text;
}

TEST(JsonReader, KeepsNumbersAsTheyStand) {
    const JsonValue root = read(" [0.10, -0, 1e5, 12345678901234567890123, -7 , 1E-400,3]");
    const JsonArray& items = *root.array();
    const std::vector<std::string> texts{"0.10", "-0", "1e5", "12345678901234567890123", "-7", "1E-400", "3"};
    ASSERT_EQ(items.size(), texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(number(items[i]), texts[i]);
    EXPECT_EQ(number(read("42")), "42");
    EXPECT_EQ(number(read(" -0.5\n")), "-0.5");
}

TEST(JsonReader, ReadsEveryKindOfValue) {
    const JsonValue root = read(R"({"n":null,"t":true,"f":false,"s":"a\u00e9\n\"b","a":[],"o":{}})");
    EXPECT_TRUE(root.find("n")->is_null());
    EXPECT_TRUE(*root.find("t")->boolean());
    EXPECT_FALSE(*root.find("f")->boolean());
    EXPECT_EQ(*root.find("s")->string(), "a\xC3\xA9\n\"b");
    EXPECT_TRUE(root.find("a")->array()->empty());
    EXPECT_TRUE(root.find("o")->object()->empty());
    EXPECT_EQ(root.find("x"), nullptr);
    EXPECT_EQ(root.find("a")->find("x"), nullptr);
    const std::vector<std::string_view> kinds{"null", "a boolean", "a boolean", "a string", "an array", "an object"};
    for (std::size_t i = 0; i < kinds.size(); ++i) EXPECT_EQ((*root.object())[i].value.kind(), kinds[i]);
}

TEST(JsonReader, KnowsWhereEachValueBegins) {
    const JsonValue root = read("{\n  \"a\" : [1,\n 22 , \"é\", true],\r\n\t\"bé\":{ } , \"c\": null}");
    const JsonArray& items = *root.find("a")->array();
    const auto at = [](const JsonValue& value) { return std::pair(value.place().line, value.place().column); };
    EXPECT_EQ(at(root), std::pair(std::size_t{1}, std::size_t{1}));
    EXPECT_EQ(at(*root.find("a")), std::pair(std::size_t{2}, std::size_t{9}));
    EXPECT_EQ(at(items[0]), std::pair(std::size_t{2}, std::size_t{10}));
    EXPECT_EQ(at(items[1]), std::pair(std::size_t{3}, std::size_t{2}));
    EXPECT_EQ(at(items[2]), std::pair(std::size_t{3}, std::size_t{7}));
    EXPECT_EQ(at(items[3]), std::pair(std::size_t{3}, std::size_t{12}));
    EXPECT_EQ(at(*root.find("b\xC3\xA9")), std::pair(std::size_t{4}, std::size_t{7}));
    EXPECT_EQ(at(*root.find("c")), std::pair(std::size_t{4}, std::size_t{18}));
    EXPECT_EQ((*root.object())[1].place.column, 2U);
}

TEST(JsonReader, RefusesAKeyTwiceAtItsSecondPlace) {
    const Diagnostic error = refusal("{\"a\":1,\n \"b\":{\"a\":2}, \"a\":3}");
    EXPECT_EQ(error.line, 2U);
    EXPECT_EQ(error.column, 15U);
    EXPECT_THAT(error.message, HasSubstr("`a`"));
    EXPECT_EQ(error.source_line, " \"b\":{\"a\":2}, \"a\":3}");
    EXPECT_EQ(read(R"([{"a":1},{"a":1}])").array()->size(), 2U);
}

TEST(JsonReader, TakesDepth200AndRefuses201AndAMillion) {
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    EXPECT_TRUE(read_json(nested(max_json_depth), "t").value);
    for (const std::size_t depth : {max_json_depth + 1, std::uint64_t{1'000'000}}) {
        const Diagnostic error = refusal(nested(depth));
        EXPECT_EQ(error.column, max_json_depth + 1);
        EXPECT_THAT(error.message, HasSubstr("200"));
    }
    std::string objects;
    for (int i = 0; i < 1'000'000; ++i) objects += "{\"a\":";
    EXPECT_THAT(refusal(objects).message, HasSubstr("200"));
}

TEST(JsonReader, TakesAsManyValuesAsAllowedAndRefusesOneMore) {
    const std::string_view text = R"({"a": [1, 2], "b": null})";
    EXPECT_TRUE(read_json(text, "t", 5).value);
    const ParsedJson refused = read_json(text, "t", 4);
    EXPECT_FALSE(refused.value);
    EXPECT_EQ(refused.error.value().message, "more than 4 values");
}

TEST(JsonReader, NeedsNoStackForDepth) {
    tests::run_on_stack(std::size_t{8} << 20, [] {
        EXPECT_THAT(refusal(std::string(1'000'000, '[')).message, HasSubstr("200"));
        EXPECT_TRUE(read_json(std::string(200, '[') + std::string(200, ']'), "t").value);
    });
}

TEST(JsonReader, RefusesWhatIsNoJson) {
    for (const char* text :
         {"",         " ",           "{",      "[",        "[1",           "[1,",     "[1,]",   "{\"a\"}",
          "{\"a\":}", "{\"a\":1,}",  "{a:1}",  "'a'",      "01",           "+1",      ".5",     "1.",
          "1e",       "-",           "tru",    "nul",      "[1 2]",        "1 2",     "[]]",    "\"a",
          "\"\\x\"",  "\"\\ud800\"", "\"\n\"", "\"\xFF\"", "\"\xC0\x80\"", "// c\n1", "[1]/**/"}) {
        const Diagnostic error = refusal(text);
        EXPECT_GE(error.line, 1U) << text;
        EXPECT_GE(error.column, 1U) << text;
        EXPECT_THAT(error.message, HasSubstr("not JSON")) << text;
        EXPECT_EQ(error.source, "t.json");
    }
}

TEST(JsonReader, RefusesNumbersThatAreNotFinite) {
    for (const char* text : {"NaN", "[Infinity]", "[1,-Infinity]", "nan", "inf"})
        EXPECT_THAT(refusal(text).hint, HasSubstr("NaN")) << text;
    const Diagnostic error = refusal("[1,\n  1e400]");
    EXPECT_EQ(error.line, 2U);
    EXPECT_EQ(error.column, 3U);
    EXPECT_THAT(error.message, HasSubstr("range of doubles"));
}

TEST(JsonReader, RefusesAByteZeroThatWouldEndTheText) {
    const Diagnostic error = refusal(std::string_view("[1]\n\0garbage", 12));
    EXPECT_EQ(error.line, 2U);
    EXPECT_EQ(error.column, 1U);
}

TEST(JsonReader, PassesOverAByteOrderMark) {
    EXPECT_EQ(read("\xEF\xBB\xBF[1]").array()->front().place().column, 2U);
}

TEST(JsonReader, SaysWhereASyntaxErrorIs) {
    const Diagnostic error = refusal("[1,\n 2,\n x]");
    EXPECT_EQ(error.line, 3U);
    EXPECT_EQ(error.column, 2U);
    EXPECT_EQ(error.source_line, " x]");
}

TEST(JsonReader, DoesNotQuoteALineOfAMegabyte) {
    EXPECT_EQ(refusal("[\"" + std::string(1'000'000, 'a') + "\" x]").source_line, "");
}

TEST(JsonReader, RefusesEveryPrefixWithAPlace) {
    const std::string text = "{\"a\": [1.5e-3, true, null, \"x\\u00e9\"],\n \"b\": {\"c\": -0}}";
    ASSERT_TRUE(read_json(text, "t").value);
    for (std::size_t size = 0; size < text.size(); ++size) {
        const Diagnostic error = refusal(std::string_view(text).substr(0, size));
        EXPECT_GE(error.line, 1U);
        EXPECT_LE(error.column, text.size() + 1);
    }
}

} // namespace
} // namespace internode
