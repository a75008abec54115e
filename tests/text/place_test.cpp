// SPDX-License-Identifier: MIT

#include "internode/text/place.h"

#include "internode/io/file/limits.h"

#include <gtest/gtest.h>

namespace internode {
namespace {

TEST(TextPlace, CountsLinesAndCodePointsFromOne) {
    const std::string text = "ab\n\xCF\x86x\r\n\ny";
    const std::vector<std::pair<std::size_t, std::size_t>> places{{1, 1}, {1, 2}, {1, 3}, {2, 1}, {2, 2}, {2, 2},
                                                                  {2, 3}, {2, 4}, {3, 1}, {4, 1}, {4, 2}};
    ASSERT_EQ(places.size(), text.size() + 1);
    TextPlace known;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const TextPlace place = place_of(text, i);
        known = place_of(text, i, i == 0 ? 0 : i - 1, known);
        EXPECT_EQ(known.line, place.line);
        EXPECT_EQ(known.column, place.column);
        if (i == 4) continue; // inside a code point
        EXPECT_EQ(place.line, places[i].first) << i;
        EXPECT_EQ(place.column, places[i].second) << i;
    }
}

TEST(TextPlace, APieceHasAColumnPerCodePointAndOneAtLeast) {
    EXPECT_EQ(columns_of(""), 1U);
    EXPECT_EQ(columns_of("a"), 1U);
    EXPECT_EQ(columns_of("\xCF\x86x-9"), 4U);
}

TEST(TextPlace, ShowsTheLineOfTheOffence) {
    const std::string text = "ab\ncde\r\nf";
    for (const std::size_t offset : {3U, 4U, 6U}) {
        EXPECT_EQ(diagnostic_at(text, offset, "s", "m").source_line, "cde");
        EXPECT_EQ(diagnostic_at(text, place_of(text, offset), "s", "m").source_line, "cde");
    }
    EXPECT_EQ(diagnostic_at(text, 1000, "s", "m").source_line, "f");
    EXPECT_EQ(diagnostic_at(text, TextPlace{9, 1}, "s", "m").source_line, "f");
    EXPECT_EQ(diagnostic_at("", 0, "s", "m").line, 1U);
    EXPECT_EQ(diagnostic_at(std::string(max_shown_line_bytes + 1, 'a'), 3, "s", "m").source_line, "");
    EXPECT_EQ(diagnostic_at(std::string(max_shown_line_bytes, 'a'), 3, "s", "m").source_line.size(),
              max_shown_line_bytes);
}

} // namespace
} // namespace internode
