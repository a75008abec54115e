// SPDX-License-Identifier: MIT

#include "internode/text/utf8.h"

#include <gtest/gtest.h>

namespace internode {

TEST(Utf8, ReadsBackEveryCodePoint) {
    for (char32_t value = 0; value <= 0x10FFFF; ++value) {
        if (value >= 0xD800 && value <= 0xDFFF) continue;
        std::string text;
        append_utf8(text, value);
        const CodePoint point = code_point_at(text, 0);
        ASSERT_TRUE(point.valid && point.value == value && point.bytes == text.size()) << static_cast<unsigned>(value);
    }
}

TEST(Utf8, TakesADamagedByteForItself) {
    for (const std::string_view text :
         {"\x80", "\xC0\x80", "\xC1\xBF", "\xC3", "\xC3(", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80",
          "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xE2\x82"}) {
        const CodePoint point = code_point_at(text, 0);
        EXPECT_FALSE(point.valid);
        EXPECT_EQ(point.bytes, 1u);
        EXPECT_EQ(point.value, static_cast<unsigned char>(text.front()));
    }
}

TEST(Utf8, CountsCodePointsAndDamagedBytes) {
    EXPECT_EQ(count_code_points(""), 0u);
    EXPECT_EQ(count_code_points("a\xC3\xA9\xF0\x9F\x8C\xB1\xFF\xC3"), 5u);
}

} // namespace internode
