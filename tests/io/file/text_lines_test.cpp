// SPDX-License-Identifier: MIT

#include "internode/io/file/text_lines.h"

#include "internode/io/csv.h"
#include "internode/io/json/curve_json.h"
#include "internode/io/obj/obj.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace internode {
namespace {

/// Takes so many writes and fails.
class TiredSink final : public Sink {
public:
    explicit TiredSink(int writes)
        : writes_(writes) {}
    bool write(std::string_view /*bytes*/) override { return --writes_ >= 0; }

private:
    int writes_;
};

TEST(TextLines, AreWrittenInTheirOrderByAnyThreads) {
    const auto line = [](std::size_t i, std::string& text) { text += std::to_string(i) + '\n'; };
    for (const std::size_t count : {0U, 1U, 1023U, 1024U, 1025U, 2048U, 5000U}) {
        std::string expected;
        for (std::size_t i = 0; i < count; ++i) line(i, expected);
        for (const int threads : {1, 2, 3, 0}) {
            StringSink sink;
            EXPECT_TRUE(write_lines(sink, count, threads, line));
            EXPECT_EQ(sink.text(), expected) << count << " lines, " << threads << " threads";
        }
    }
}

TEST(TextLines, StopWhereTheSinkFails) {
    const auto line = [](std::size_t, std::string& text) { text += '\n'; };
    for (const int threads : {1, 2, 0}) {
        TiredSink tired(2);
        EXPECT_FALSE(write_lines(tired, 10'000, threads, line));
        TiredSink fresh(10);
        EXPECT_TRUE(write_lines(fresh, 10'000, threads, line));
    }
}

/// Points of two numbers with 17 digits.
std::vector<double> many_coordinates() {
    std::vector<double> coordinates;
    for (int i = 0; i < 5000; ++i) coordinates.push_back(1.0 / (i + 3));
    return coordinates;
}

std::string csv_of(const std::vector<double>& coordinates, int threads) {
    StringSink sink;
    EXPECT_TRUE(write_csv(sink, {2, coordinates}, {.header = {"x", "y"}, .threads = threads}));
    return sink.text();
}

std::string obj_of(const std::vector<double>& coordinates, int threads) {
    StringSink sink;
    const std::vector<std::string> comments{"made", "here"};
    EXPECT_TRUE(write_obj(sink, {2, coordinates}, Ends::Circular, comments, 7, threads));
    return sink.text();
}

std::string json_of(const std::vector<double>& coordinates, int threads) {
    const Word word(coordinates.size() / 2, to_symbol(1));
    CurveDocument curve;
    curve.symbols = {"L", "S\""};
    curve.word = word;
    curve.knots = coordinates;
    curve.points = {2, coordinates};
    curve.weighted = true;
    curve.threads = threads;
    StringSink sink;
    EXPECT_TRUE(write_curve_json(sink, curve));
    return sink.text();
}

TEST(TextLines, OfPointsAreTheSameBytesForAnyThreads) {
    const std::vector<double> coordinates = many_coordinates();
    for (const auto text_of : {csv_of, obj_of, json_of}) {
        const std::string expected = text_of(coordinates, 1);
        EXPECT_GT(expected.size(), 2500U * 2 * 15);
        for (const int threads : {2, 3, 0}) EXPECT_EQ(text_of(coordinates, threads), expected) << threads << " threads";
    }
}

TEST(TextLines, RefuseNumbersThatAreNotFiniteOnAnyThread) {
    std::vector<double> coordinates = many_coordinates();
    coordinates[4321] = std::numeric_limits<double>::infinity();
    for (const auto text_of : {csv_of, obj_of, json_of})
        for (const int threads : {1, 2, 0}) EXPECT_THROW((void)text_of(coordinates, threads), std::invalid_argument);
}

} // namespace
} // namespace internode
