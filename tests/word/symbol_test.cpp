// SPDX-License-Identifier: MIT

#include "internode/word/symbol.h"
#include "tests/fixtures/words.h"
#include "tests/reference/persistent_words.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <unordered_set>

using namespace internode;
using tests::word;

TEST(Alphabet, NumbersNamesInTheOrderOfTheirAppearance) {
    Alphabet alphabet;
    EXPECT_EQ(alphabet.add("S"), to_symbol(0));
    EXPECT_EQ(alphabet.add("L"), to_symbol(1));
    EXPECT_EQ(alphabet.add("S"), to_symbol(0));
    EXPECT_EQ(alphabet.size(), 2U);
    EXPECT_EQ(alphabet.find("L"), to_symbol(1));
    EXPECT_EQ(alphabet.find("X"), std::nullopt);
    EXPECT_EQ(alphabet.name(to_symbol(1)), "L");
}

TEST(Alphabet, KnowsTheZeroIntervalWithoutHoldingIt) {
    const Alphabet alphabet;
    EXPECT_EQ(alphabet.name(zero_interval), "0");
    EXPECT_EQ(alphabet.size(), 0U);
}

TEST(Alphabet, RefusesASymbolOfAnotherAlphabet) {
    Alphabet alphabet;
    alphabet.add("S");
    EXPECT_THROW((void)alphabet.name(to_symbol(1)), std::out_of_range);
}

TEST(Alphabet, IsEqualByNamesAndTheirOrder) {
    Alphabet sl;
    Alphabet ls;
    for (const char* name : {"S", "L"}) sl.add(name);
    for (const char* name : {"L", "S"}) ls.add(name);
    EXPECT_FALSE(sl == ls);
    EXPECT_TRUE(sl == Alphabet(sl));
}

TEST(WordText, RunsSingleCharactersTogetherAndSetsZerosApart) {
    Alphabet alphabet;
    for (const char* name : {"S", "L"}) alphabet.add(name);
    EXPECT_EQ(to_string(word("abba"), alphabet), "SLLS");
    EXPECT_EQ(to_string(word("00ba00"), alphabet), "0 0 LS 0 0");
    EXPECT_EQ(to_string(word("b0a"), alphabet), "L 0 S");
    EXPECT_EQ(to_string(Word{}, alphabet), "");
}

TEST(WordText, SeparatesNamesOfSeveralCharacters) {
    Alphabet alphabet;
    for (const char* name : {"A1", "B"}) alphabet.add(name);
    EXPECT_EQ(to_string(word("aab0"), alphabet), "A1 A1 B 0");
}

TEST(WordHash, SeparatesTheWordsOfUpToSevenLettersOverThree) {
    std::unordered_set<std::size_t> hashes;
    std::size_t count = 0;
    std::vector<Word> level{Word{}};
    for (int size = 0; size <= 7; ++size) {
        std::vector<Word> longer;
        for (const Word& start : level) {
            hashes.insert(WordHash{}(start));
            ++count;
            for (std::size_t letter = 0; letter < 3; ++letter) {
                longer.push_back(start);
                longer.back().push_back(to_symbol(letter));
            }
        }
        level = longer;
    }
    EXPECT_EQ(hashes.size(), count);
}
