// SPDX-License-Identifier: MIT
//
// Every prefix of every bundled grammar and every damaged byte: a grammar, or errors with a place (P2).

#include "internode/grammar/bundled.h"
#include "internode/grammar/parse.h"
#include "internode/grammar/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace internode {

namespace {

void expect_sound(std::string_view text) {
    const ParsedGrammar parsed = parse_grammar(text, "t");
    ASSERT_EQ(parsed.grammar.has_value(), parsed.errors.empty()) << text;
    for (const Diagnostic& error : parsed.errors) {
        ASSERT_GE(error.line, 1u) << text;
        ASSERT_GE(error.column, 1u) << text;
        ASSERT_GE(error.width, 1u) << text;
        ASSERT_FALSE(error.message.empty()) << text;
    }
    const auto place = [](const Diagnostic& error) { return std::pair(error.line, error.column); };
    ASSERT_TRUE(std::ranges::is_sorted(parsed.errors, {}, place)) << text;
    for (const char c : to_string(parsed.errors))
        ASSERT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= ' ') << text;
    if (!parsed.grammar) return;
    ASSERT_EQ(parse_grammar(print(*parsed.grammar), "p").grammar, parsed.grammar) << text;
}

/// The parts of the language that the bundled grammars do not use.
constexpr std::string_view rich = "intervals \"a\\u{e9}\"; L1 ->\n S^2 (L1 S)^2 // x\nS \xE2\x86\x92 L1\nring\n"
                                  "axiom 0^2 (L1S)^3 0\nlength S = 3/2, length S = 1.5";

} // namespace

TEST(Damage, EveryPrefixIsReadOrRefusedWithAPlace) {
    for (const BundledGrammar& bundled : bundled_grammars(GrammarKind::Intervals))
        for (std::size_t size = 0; size <= bundled.text.size(); ++size) expect_sound(bundled.text.substr(0, size));
    for (std::size_t size = 0; size <= rich.size(); ++size) expect_sound(rich.substr(0, size));
}

TEST(Damage, EveryReplacedByteIsReadOrRefusedWithAPlace) {
    std::vector<std::string_view> texts{rich};
    for (const BundledGrammar& bundled : bundled_grammars(GrammarKind::Intervals)) texts.push_back(bundled.text);
    std::ranges::sort(texts, {}, &std::string_view::size);
    texts.resize(std::min<std::size_t>(texts.size(), 20));
    for (const std::string_view text : texts) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            for (const char byte : {'\0', '\xFF', '\n', '"', '(', ')', '^', ',', '>'}) {
                std::string damaged(text);
                damaged[i] = byte;
                expect_sound(damaged);
            }
        }
    }
}

TEST(Damage, RandomPiecesOfTheLanguageAreReadOrRefusedWithAPlace) {
    const std::vector<std::string> pieces{
        "L",  "S",    "A1", "0",  "->",         "\n",           ",",        "(",         ")",    "^2",
        "^",  " ",    "//", "\"", "=",          "3/2",          "axiom ",   "length ",   "ring", "\\u{e9}",
        "\t", "\xFF", ":",  "<",  "intervals ", "\xE2\x86\x92", "\xCE\xB5", "L -> S L\n"};
    std::mt19937 draw(5);
#ifdef INTERNODE_SANITIZED
    constexpr int rounds = 3'000;
#else
    constexpr int rounds = 30'000;
#endif
    for (int round = 0; round < rounds; ++round) {
        std::string text;
        for (std::size_t i = draw() % 25; i > 0; --i) text += pieces[draw() % pieces.size()];
        expect_sound(text);
    }
}

} // namespace internode
