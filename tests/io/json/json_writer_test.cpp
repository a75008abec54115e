// SPDX-License-Identifier: MIT

#include "internode/io/json/json_writer.h"

#include "internode/io/json/json_reader.h"

#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>

namespace internode {
namespace {

constexpr JsonWriter::Layout line = JsonWriter::Layout::Line;

/// Fails once `limit` bytes have come.
class FullSink final : public Sink {
public:
    explicit FullSink(std::size_t limit)
        : room_(limit) {}
    bool write(std::string_view bytes) override {
        if (bytes.size() > room_)
            room_ = 0;
        else
            room_ -= bytes.size();
        return room_ > 0;
    }

private:
    std::size_t room_;
};

TEST(JsonWriter, LaysOutBlocksAndLines) {
    StringSink sink;
    JsonWriter json(sink);
    json.begin_object().key("a").integer(1).key("b").begin_array(line).number(0.5).number(-0.0).null().end_array();
    json.key("c").begin_array().begin_array(line).integer(1).integer(2).end_array().begin_array(line).end_array();
    json.end_array().key("d").begin_object().end_object().key("e").begin_object(line).key("x").boolean(true);
    json.key("y").begin_array().string("s").integer(18446744073709551615U).end_array().end_object().end_object();
    EXPECT_TRUE(json.finish());
    EXPECT_EQ(sink.text(), R"({
  "a": 1,
  "b": [0.5, -0, null],
  "c": [
    [1, 2],
    []
  ],
  "d": {},
  "e": {"x": true, "y": ["s", 18446744073709551615]}
}
)");
}

TEST(JsonWriter, EscapesWhatCouldActOutsideJson) {
    EXPECT_EQ(json_quoted("</script>&"), R"("\u003c/script\u003e\u0026")");
    EXPECT_EQ(json_quoted("\"\\\n\r\t\x01\x7F"), R"("\"\\\n\r\t\u0001\u007f")");
    EXPECT_EQ(json_quoted("\xE2\x80\xA8\xE2\x80\xA9\xE2\x80\xAE\xEF\xBB\xBF\xC2\x85"),
              R"("\u2028\u2029\u202e\ufeff\u0085")");
    EXPECT_EQ(json_quoted(std::string_view("\0", 1)), R"("\u0000")");
    EXPECT_EQ(json_quoted("φ é 𝄞"), "\"φ é 𝄞\"");
}

TEST(JsonWriter, ReplacesBytesThatAreNotUtf8) {
    EXPECT_EQ(json_quoted("a\xFFz"), R"("a\ufffdz")");
    EXPECT_EQ(json_quoted("\xC0\x80"), R"("\ufffd\ufffd")");
    EXPECT_EQ(json_quoted("\xED\xA0\x80"), R"("\ufffd\ufffd\ufffd")");
    EXPECT_EQ(json_quoted("\xF0\x9D\x84"), R"("\ufffd\ufffd\ufffd")");
}

TEST(JsonWriter, IsReadBackForEveryPairOfBytes) {
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) {
            const std::string text{static_cast<char>(a), static_cast<char>(b)};
            const ParsedJson json = read_json(json_quoted(text), "t");
            ASSERT_TRUE(json.value) << a << ' ' << b;
            if (a < 128 && b < 128) {
                ASSERT_EQ(*json.value->string(), text);
            }
        }
}

TEST(JsonWriter, RefusesNumbersThatJsonHasNot) {
    StringSink sink;
    JsonWriter json(sink);
    EXPECT_THROW(json.number(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
    EXPECT_THROW(json.number(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(JsonWriter, SaysThatItsSinkHasFailed) {
    FullSink sink(100'000);
    JsonWriter json(sink);
    json.begin_array();
    for (std::size_t i = 0; i < 50'000; ++i) json.integer(i);
    EXPECT_FALSE(json.good());
    json.end_array();
    EXPECT_FALSE(json.finish());
}

TEST(JsonWriter, ManyValuesAreThoseOfOneAfterAnother) {
    for (const JsonWriter::Layout layout : {JsonWriter::Layout::Block, line})
        for (const std::size_t count : {0U, 1U, 2U, 1024U, 1025U, 3000U}) {
            StringSink expected;
            JsonWriter one_by_one(expected);
            one_by_one.begin_object().key("a").begin_array(layout).boolean(true);
            for (std::size_t i = 0; i < count; ++i) one_by_one.integer(i);
            one_by_one.null().end_array().end_object();
            ASSERT_TRUE(one_by_one.finish());
            for (const int threads : {1, 2, 0}) {
                StringSink sink;
                JsonWriter together(sink);
                together.begin_object().key("a").begin_array(layout).boolean(true);
                together.values(count, threads, [](std::size_t i, std::string& text) { text += std::to_string(i); });
                together.null().end_array().end_object();
                ASSERT_TRUE(together.finish());
                EXPECT_EQ(sink.text(), expected.text()) << count << " values, " << threads << " threads";
            }
        }
}

TEST(JsonWriter, RowsAreArraysOfValuesOneAfterAnother) {
    for (const std::size_t columns : {1U, 2U, 7U, 1024U})
        for (const std::size_t rows : {0U, 1U, 2U, 700U}) {
            StringSink expected;
            JsonWriter one_by_one(expected);
            one_by_one.begin_object().key("a").begin_array().boolean(true);
            for (std::size_t row = 0; row < rows; ++row) {
                one_by_one.begin_array();
                for (std::size_t i = 0; i < columns; ++i) one_by_one.integer(row * columns + i);
                one_by_one.end_array();
            }
            one_by_one.null().end_array().end_object();
            ASSERT_TRUE(one_by_one.finish());
            for (const int threads : {1, 2, 0}) {
                StringSink sink;
                JsonWriter together(sink);
                together.begin_object().key("a").begin_array().boolean(true);
                together.rows(rows * columns, columns, threads,
                              [](std::size_t i, std::string& text) { text += std::to_string(i); });
                together.null().end_array().end_object();
                ASSERT_TRUE(together.finish());
                EXPECT_EQ(sink.text(), expected.text()) << rows << " rows of " << columns;
            }
        }
}

} // namespace
} // namespace internode
