// SPDX-License-Identifier: MIT

#include "internode/grammar/intervals/parse.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace internode {

namespace {

Alphabet letters() {
    Alphabet alphabet;
    alphabet.add("L");
    alphabet.add("S");
    return alphabet;
}

std::string read(std::string_view text) {
    const Alphabet alphabet = letters();
    const ParsedWord word = parse_word(text, alphabet, "<word>");
    if (!word.errors.empty())
        return fmt::format("{}:{} {}|{}", word.errors.front().line, word.errors.front().column,
                           word.errors.front().message, word.errors.front().hint);
    EXPECT_EQ(word.says_ends, word.axiom.ends == Ends::Circular);
    const std::string letters_read = to_string(word.axiom.word, alphabet);
    return word.says_ends ? "(" + letters_read + ")" : letters_read;
}

} // namespace

TEST(ParseWord, ReadsLettersZerosPowersAndCircles) {
    EXPECT_EQ(read("SLLS"), "SLLS");
    EXPECT_EQ(read(" S L\nL S\n"), "SLLS");
    EXPECT_EQ(read("0^3 (LS)^4 0^3"), "0 0 0 LSLSLSLS 0 0 0");
    EXPECT_EQ(read("(L S)"), "(LS)");
    EXPECT_EQ(read("00L"), "0 0 L");
}

TEST(ParseWord, RefusesWhatIsNoWord) {
    EXPECT_EQ(read(""), "1:1 a word without letters|write `L S L`, `0^3 (L S)^4 0^3` or `(L S)` for a circle");
    EXPECT_EQ(read("L Q"), "1:3 `Q` is no symbol of the grammar|");
    EXPECT_EQ(read("L s"), "1:3 `s` is no symbol of the grammar|did you mean `S`?");
    EXPECT_EQ(read("L0"), "1:1 `L0` is no symbol of the grammar|`L0` is one symbol: write `L 0`");
    EXPECT_EQ(read("L,S"), "1:2 `,` has no meaning in a word|letters stand side by side or between blanks");
    EXPECT_EQ(read("(L"), "1:1 `(` is never closed|");
    EXPECT_EQ(read("L)"), "1:2 `)` was never opened|");
    EXPECT_EQ(read("L -> S"), "1:3 a second `->` in one statement|begin each rule on a line of its own, or after `,`");
    EXPECT_EQ(read("L\xFF"), "1:2 the byte \\xFF is no text|");
    EXPECT_EQ(read("L^10000001"), "1:3 this power makes a word of more than 10000000 letters|");
}

TEST(ParseWord, HoldsTenMillionLetters) {
    const ParsedWord word = parse_word("(L S)^5000000", letters(), "<word>");
    EXPECT_TRUE(word.errors.empty());
    EXPECT_EQ(word.axiom.word.size(), 10'000'000u);
}

} // namespace internode
