// SPDX-License-Identifier: MIT

#include "internode/grammar/intervals/print.h"

#include "internode/algebra/fraction.h"
#include "internode/grammar/bundled.h"
#include "internode/grammar/intervals/parse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace internode {

namespace {

/// Draws grammars with every feature of the language.
class RandomGrammar {
public:
    explicit RandomGrammar(unsigned seed)
        : generator_(seed) {}

    IntervalGrammar operator()() {
        IntervalGrammar grammar;
        grammar.name = name();
        const std::size_t n = 1 + below(6);
        while (grammar.alphabet.size() < n) grammar.alphabet.add(symbol());
        std::vector<Word> images;
        for (std::size_t i = 0; i < n; ++i) images.push_back(word(n, 1 + below(5), false));
        grammar.rules = Morphism(images);
        if (below(2) == 0)
            grammar.axiom = Axiom{word(n, 1 + below(20), true), below(2) == 0 ? Ends::Open : Ends::Circular};
        for (std::size_t i = n; i-- > 0;) {
            if (below(3) != 0) continue;
            const Rational length = fraction(1 + below(1000), 1 + below(1000));
            grammar.lengths.push_back({to_symbol(i), length});
        }
        return grammar;
    }

private:
    std::size_t below(std::size_t bound) { return generator_() % bound; }

    std::string pick(const std::vector<std::string>& pieces, std::size_t count) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i) text += pieces[below(pieces.size())];
        return text;
    }
    std::string symbol() {
        return pick({"A", "B", "L", "s", "x"}, 1) + pick({"0", "1", "'", "_"}, below(2) * below(4));
    }
    std::string name() {
        return pick(
            {"a", "B", "7", "_", "'", "-", " ", "\"", "\\", "//", "\xC3\xA9", "\xE2\x80\xAE", "\xF0\x9F\x8C\xB1"},
            below(6));
    }
    Word word(std::size_t n, std::size_t size, bool zeros) {
        Word letters;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t letter = below(zeros ? n + 1 : n);
            letters.push_back(letter == n ? zero_interval : to_symbol(letter));
        }
        return letters;
    }

    std::mt19937 generator_;
};

void expect_round_trip(const IntervalGrammar& grammar) {
    const std::string text = print(grammar);
    EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); })) << text;
    const ParsedGrammar again = parse_grammar(text, "printed");
    ASSERT_TRUE(again.grammar) << text << to_string(again.errors);
    EXPECT_EQ(*again.grammar, grammar) << text;
}

} // namespace

TEST(Print, IsReadBackForRandomGrammars) {
    RandomGrammar draw(20260101);
    for (int i = 0; i < 5000; ++i) expect_round_trip(draw());
}

TEST(Print, IsReadBackForEveryBundledGrammar) {
    for (const BundledGrammar& bundled : bundled_grammars(GrammarKind::Intervals)) {
        const ParsedGrammar parsed = parse_grammar(bundled.text, bundled.name);
        ASSERT_TRUE(parsed.grammar) << to_string(parsed.errors);
        expect_round_trip(*parsed.grammar);
    }
}

TEST(Print, OfWhatWasPrintedIsTheSame) {
    RandomGrammar draw(7);
    for (int i = 0; i < 200; ++i) {
        const std::string text = print(draw());
        EXPECT_EQ(print(*parse_grammar(text, "printed").grammar), text);
    }
}

} // namespace internode
