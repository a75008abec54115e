// SPDX-License-Identifier: MIT

#include "internode/io/csv.h"

#include "internode/io/polygon.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;

TEST(Csv, WritesAPointALine) {
    const std::vector<double> coordinates{0, 0.25, -1e-7, 1e22};
    StringSink sink;
    EXPECT_TRUE(write_csv(sink, {2, coordinates}, {.header = {"x", "y"}}));
    EXPECT_EQ(sink.text(), "x,y\n0,0.25\n-1e-07,1e+22\n");
    StringSink bare;
    EXPECT_TRUE(write_csv(bare, {1, coordinates}));
    EXPECT_EQ(bare.text(), "0\n0.25\n-1e-07\n1e+22\n");
    StringSink none;
    EXPECT_TRUE(write_csv(none, {2, {}}));
    EXPECT_EQ(none.text(), "");
}

TEST(Csv, PutsTheParameterFirst) {
    const std::vector<double> coordinates{1, 2, 3, 4};
    const std::vector<double> parameter{0.5, 1.5};
    StringSink sink;
    EXPECT_TRUE(write_csv(sink, {2, coordinates}, {.header = {"t", "x", "y"}, .parameter = parameter}));
    EXPECT_EQ(sink.text(), "t,x,y\n0.5,1,2\n1.5,3,4\n");
}

TEST(Csv, IsReadBackBitForBitWithItsHeader) {
    std::mt19937_64 random(3);
    std::vector<double> coordinates;
    while (coordinates.size() < 3000) {
        const auto value = std::bit_cast<double>(random());
        if (std::isfinite(value)) coordinates.push_back(value);
    }
    StringSink sink;
    const std::vector<std::string> header{"x;\"1\"", "# y", "z\tz"};
    ASSERT_TRUE(write_csv(sink, {3, coordinates}, {.header = header}));
    const std::string text = sink.text();
    EXPECT_EQ(read_polygon_csv(text.substr(text.find('\n') + 1), "p").polygon.value().points, coordinates);
    StringSink plain;
    ASSERT_TRUE(write_csv(plain, {3, coordinates}, {.header = coordinate_names(3)}));
    const auto polygon = read_polygon_csv(plain.text(), "p").polygon;
    EXPECT_EQ(polygon.value().points, coordinates);
    EXPECT_THAT(polygon.value().columns, ElementsAre("x", "y", "z"));
}

TEST(Csv, KeepsHostileNamesOnTheirLine) {
    const std::vector<double> coordinates{1};
    for (const char* name : {"a\nb", "a\r\nb", "a,b", "\"", "", "a;b"}) {
        StringSink sink;
        ASSERT_TRUE(write_csv(sink, {1, coordinates}, {.header = {name}}));
        EXPECT_EQ(std::count(sink.text().begin(), sink.text().end(), '\n'), 2) << name;
        EXPECT_TRUE(sink.text().ends_with("\n1\n"));
    }
}

TEST(Csv, LeavesAMissingNumberEmptyWhenAskedTo) {
    const double missing = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> coordinates{missing, 1, 2, missing};
    StringSink sink;
    EXPECT_TRUE(write_csv(sink, {2, coordinates}, {.header = {}, .parameter = {}, .nan_is_missing = true}));
    EXPECT_EQ(sink.text(), ",1\n2,\n");
    EXPECT_THROW(write_csv(sink, {2, coordinates}), std::invalid_argument);
    const std::vector<double> infinite{std::numeric_limits<double>::infinity()};
    EXPECT_THROW(write_csv(sink, {1, infinite}, {.header = {}, .parameter = {}, .nan_is_missing = true}),
                 std::invalid_argument);
}

TEST(Csv, NamesCoordinates) {
    EXPECT_THAT(coordinate_names(1), ElementsAre("x"));
    EXPECT_THAT(coordinate_names(4), ElementsAre("x1", "x2", "x3", "x4"));
}

TEST(Csv, RefusesWhatDoesNotFit) {
    const std::vector<double> three{1, 2, 3};
    const std::vector<double> not_finite{std::numeric_limits<double>::infinity()};
    StringSink sink;
    EXPECT_THROW(write_csv(sink, {2, three}), std::invalid_argument);
    EXPECT_THROW(write_csv(sink, {0, three}), std::invalid_argument);
    EXPECT_THROW(write_csv(sink, {3, three}, {.header = {"x"}}), std::invalid_argument);
    EXPECT_THROW(write_csv(sink, {3, three}, {.header = {}, .parameter = three}), std::invalid_argument);
    EXPECT_THROW(write_csv(sink, {1, not_finite}), std::invalid_argument);
}

/// Counts, and fails once asked often enough.
class CountingSink final : public Sink {
public:
    bool write(std::string_view bytes) override {
        largest = std::max(largest, bytes.size());
        total += bytes.size();
        return ++calls < 10;
    }
    std::size_t largest = 0;
    std::size_t total = 0;
    int calls = 0;
};

TEST(Csv, StreamsAndStopsWhenItsSinkFails) {
    const std::vector<double> coordinates(2'000'000, 0.1);
    CountingSink sink;
    EXPECT_FALSE(write_csv(sink, {2, coordinates}));
    EXPECT_EQ(sink.calls, 10);
    EXPECT_LT(sink.largest, std::size_t{1} << 17);
}

} // namespace
} // namespace internode
