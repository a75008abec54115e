// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/name.h"

#include <gtest/gtest.h>

namespace internode {

TEST(GrammarName, IsPlainOrQuoted) {
    EXPECT_EQ(read_grammar_name("fibonacci_2'"), "fibonacci_2'");
    EXPECT_EQ(read_grammar_name("\"slow-growth-2\""), "slow-growth-2");
    EXPECT_EQ(read_grammar_name("\"\""), "");
    EXPECT_EQ(read_grammar_name("\"a \\\"b\\\" \\\\\""), "a \"b\" \\");
    EXPECT_EQ(read_grammar_name("\"\\u{1F331}\""), "\xF0\x9F\x8C\xB1");
}

TEST(GrammarName, RefusesControlCharactersAndOtherEscapes) {
    for (const std::string_view text : {"", "2a", "a-b", "\"", "\"a", "\"a\"b\"", "\"\\n\"", "\"\\u{}\"", "\"\\u{a}\"",
                                        "\"\\u{7f}\"", "\"\\u{d800}\"", "\"\\u{110000}\"", "\"\\u{1234567}\"",
                                        "\"\\u{12\"", "\"\\u12\"", "\"\\u{xyz}\"", "\"a\tb\"", "\"\xFF\"", "\"\\\""})
        EXPECT_FALSE(read_grammar_name(text)) << text;
}

TEST(GrammarName, IsWrittenInAscii) {
    EXPECT_EQ(write_grammar_name("fibonacci"), "fibonacci");
    EXPECT_EQ(write_grammar_name("slow-growth"), "\"slow-growth\"");
    EXPECT_EQ(write_grammar_name("\"\\"), "\"\\\"\\\\\"");
    EXPECT_EQ(write_grammar_name("\xC3\xA9\xE2\x80\xAE"), "\"\\u{e9}\\u{202e}\"");
    EXPECT_EQ(write_grammar_name("a\n\xFF"), "\"a\\u{fffd}\\u{fffd}\"");
}

} // namespace internode
