// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/token.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace internode {

namespace {

/// A letter for each token.
std::string kinds(std::string_view text) {
    std::string result;
    for (const Token& token : tokenize(text)) result += "rtoameCf\nbu"[static_cast<std::size_t>(token.kind)];
    return result;
}

} // namespace

TEST(Token, HasOneKindForEveryCharacter) {
    EXPECT_EQ(kinds("L1'->(S_)^2"), "ramrmmr");
    EXPECT_EQ(kinds("\"a\\\"b\" \"c"), "to");
    EXPECT_EQ(kinds("\"a\n\""), "o\no");
    EXPECT_EQ(kinds("a//b\r\nc / d\re"), "r\nrmr\nr");
    EXPECT_EQ(kinds("\xE2\x86\x92\xCE\xB5\xE2\x89\xA4\xE2\x89\xA5\xE2\x89\xA0\xC3\xA9"), "aeCCCf");
    EXPECT_EQ(kinds(std::string("a\0\x01\xFF\xFE\x7F", 6)), "rbbb");
    EXPECT_EQ(kinds("// \xFF x"), "b");
    EXPECT_EQ(kinds("\xEF\xBB\xBF"
                    "a"),
              "r");
}

TEST(Token, CoversEveryByteThatIsNoBlank) {
    std::mt19937 draw(1);
    for (int round = 0; round < 2000; ++round) {
        std::string text;
        for (int i = 0; i < 40; ++i) text += static_cast<char>(draw() % 256);
        std::ranges::replace(text, '/', '+');
        std::size_t end = 0;
        for (const Token& token : tokenize(text)) {
            ASSERT_GE(token.begin, end);
            ASSERT_GT(token.bytes, 0u);
            const std::string_view gap = std::string_view(text).substr(end, token.begin - end);
            ASSERT_EQ(gap.find_first_not_of(" \t"), std::string_view::npos);
            end = token.begin + token.bytes;
        }
        ASSERT_EQ(text.find_first_not_of(" \t", end), std::string::npos);
    }
}

} // namespace internode
