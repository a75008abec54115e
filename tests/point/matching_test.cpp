// SPDX-License-Identifier: MIT

#include "internode/point/matching.h"

#include "tests/fixtures/stride.h"
#include "tests/reference/slow_matching.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace internode {
namespace {

const std::size_t longest = tests::in_full() ? 7 : 5;

PointGrammar letters_of_branches(bool ring) {
    PointGrammar grammar;
    grammar.ring = ring;
    for (const char* name : {"A", "B", "[", "]"}) grammar.letters.add(name);
    return grammar;
}

Word word_of(std::string_view text, const PointGrammar& grammar) {
    Word word;
    for (const char letter : text) word.push_back(*grammar.letters.find(std::string_view(&letter, 1)));
    return word;
}

/// All texts of the given letters up to a length, the empty one first.
std::vector<std::string> all_texts(std::string_view letters, std::size_t length) {
    std::vector<std::string> texts{""};
    for (std::size_t i = 0; i < texts.size(); ++i)
        if (texts[i].size() < length)
            for (const char letter : letters) texts.push_back(texts[i] + letter);
    return texts;
}

TEST(Matching, NeighboursAreThoseOfTheDefinitionInAllSmallWords) {
    for (const bool ring : {false, true}) {
        const PointGrammar grammar = letters_of_branches(ring);
        for (const std::string& text : all_texts("AB[]", longest)) {
            const Word word = word_of(text, grammar);
            const WordShape shape(word, grammar);
            for (std::size_t i = 0; i < word.size(); ++i) {
                ASSERT_EQ(shape.before(i), reference::module_before(text, ring, i)) << text << " at " << i;
                ASSERT_EQ(shape.after(i), reference::module_after(text, ring, i)) << text << " at " << i;
            }
        }
    }
}

TEST(Matching, RulesFitWhereTheDefinitionSaysInAllSmallWords) {
    for (const bool ring : {false, true}) {
        const PointGrammar grammar = letters_of_branches(ring);
        std::vector<std::size_t> modules;
        for (const std::string& text : all_texts("AB[]", longest - 2)) {
            const Word word = word_of(text, grammar);
            const WordShape shape(word, grammar);
            for (const std::string& left : all_texts("AB", 2))
                for (const std::string& right : all_texts("AB", 2))
                    for (const std::string predecessor : {"A", "AB"}) {
                        PointRule rule;
                        rule.left = word_of(left, grammar);
                        rule.predecessor = word_of(predecessor, grammar);
                        rule.right = word_of(right, grammar);
                        for (std::size_t i = 0; i < word.size(); ++i)
                            ASSERT_EQ(shape.fits(rule, i, modules),
                                      reference::fits(text, ring, i, left, predecessor, right))
                                << left << " < " << predecessor << " > " << right << " in " << text << " at " << i;
                    }
        }
    }
}

TEST(Matching, NamesTheModulesInTheOrderOfTheFormals) {
    const PointGrammar grammar = letters_of_branches(false);
    const Word word = word_of("AB[A]ABA", grammar);
    PointRule rule;
    rule.left = word_of("AB", grammar);
    rule.predecessor = word_of("AB", grammar);
    rule.right = word_of("A", grammar);
    std::vector<std::size_t> modules;
    ASSERT_TRUE(WordShape(word, grammar).fits(rule, 5, modules));
    EXPECT_EQ(modules, (std::vector<std::size_t>{0, 1, 5, 6, 7}));
}

TEST(Matching, StepsOverBranches) {
    const PointGrammar grammar = letters_of_branches(false);
    const std::string text = "A[B][BB]B";
    const Word word = word_of(text, grammar);
    const WordShape shape(word, grammar);
    EXPECT_EQ(shape.before(8), 0U);
    EXPECT_EQ(shape.after(0), 8U);
    EXPECT_EQ(shape.before(2), 0U);
    EXPECT_EQ(shape.before(5), 0U);
    EXPECT_EQ(shape.after(2), std::nullopt);
}

TEST(Matching, ARingOfOneModuleReadsItselfAsOftenAsNeeded) {
    const PointGrammar grammar = letters_of_branches(true);
    const Word word = word_of("A", grammar);
    PointRule rule;
    rule.left = word_of("AAA", grammar);
    rule.predecessor = word_of("A", grammar);
    rule.right = word_of("AA", grammar);
    std::vector<std::size_t> modules;
    ASSERT_TRUE(WordShape(word, grammar).fits(rule, 0, modules));
    EXPECT_EQ(modules, std::vector<std::size_t>(6, 0));
}

TEST(Matching, ComparesNoMoreLettersThanTheRuleHas) {
    const PointGrammar grammar = letters_of_branches(false);
    std::string text = "A";
    for (int i = 0; i < 10'000; ++i) text += "[B]";
    const Word word = word_of(text + "A", grammar);
    const WordShape shape(word, grammar);
    PointRule rule;
    rule.left = word_of("A", grammar);
    rule.predecessor = word_of("B", grammar);
    std::vector<std::size_t> modules;
    std::uint64_t compared = 0;
    for (std::size_t i = 0; i < word.size(); ++i) static_cast<void>(shape.fits(rule, i, modules, &compared));
    EXPECT_LE(compared, 4 * word.size());
}

} // namespace
} // namespace internode
