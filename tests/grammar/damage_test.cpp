// SPDX-License-Identifier: MIT
//
// Every prefix of every bundled grammar and every damaged byte: a grammar, or errors with a place (P2).

#include "internode/grammar/bundled.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/intervals/print.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/grammar/points/print_points.h"
#include "tests/fixtures/stride.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace internode {

namespace {

void expect_sound(const std::vector<Diagnostic>& errors, std::string_view text) {
    for (const Diagnostic& error : errors) {
        ASSERT_GE(error.line, 1u) << text;
        ASSERT_GE(error.column, 1u) << text;
        ASSERT_GE(error.width, 1u) << text;
        ASSERT_FALSE(error.message.empty()) << text;
    }
    const auto place = [](const Diagnostic& error) { return std::pair(error.line, error.column); };
    ASSERT_TRUE(std::ranges::is_sorted(errors, {}, place)) << text;
    for (const char c : to_string(errors)) ASSERT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= ' ') << text;
}

void expect_sound(std::string_view text) {
    const ParsedGrammar parsed = parse_grammar(text, "t");
    ASSERT_EQ(parsed.grammar.has_value(), parsed.errors.empty()) << text;
    expect_sound(parsed.errors, text);
    if (!parsed.grammar) return;
    ASSERT_EQ(parse_grammar(print(*parsed.grammar), "p").grammar, parsed.grammar) << text;
}

void expect_sound_points(std::string_view text) {
    const ParsedPointGrammar parsed = parse_point_grammar(text, "t");
    ASSERT_EQ(parsed.grammar.has_value(), parsed.errors.empty()) << text;
    expect_sound(parsed.errors, text);
    if (!parsed.grammar) return;
    ASSERT_EQ(parse_point_grammar(print(*parsed.grammar), "p").grammar, parsed.grammar) << text;
}

/// The parts of the language that the bundled grammars do not use.
constexpr std::string_view rich = "intervals \"a\\u{e9}\"; L1 ->\n S^2 (L1 S)^2 // x\nS \xE2\x86\x92 L1\nring\n"
                                  "axiom 0^2 (L1S)^3 0\nlength S = 3/2, length S = 1.5";

/// The same of point grammars.
constexpr std::string_view rich_points =
    "points \"a\\u{e9}\"; ring, t = 1/2 // x\nf(s, t) = max(s, 1) - abs(t)\n"
    "input # P(v) #\naxiom [ P((0, .5)) ?Q(t)^2 ] E\ntable p\n"
    "l: # E < P(v) > E:v.x \xE2\x89\xA4 1 and not (f(v.y, 2) = 1) -> P(-1/16 \xC2\xB7 v) : 2\nE -> \xCE\xB5\n"
    "cycle p^(2 t)\ninterpretation\nP(v) \xE2\x86\x92 L(v, v/2 * 3)";

const auto point_texts = static_cast<std::size_t>(tests::times(40, 3));

/// The shortest of the bundled ones, and the rich one.
std::vector<std::string_view> texts_of_points() {
    std::vector<std::string_view> texts;
    for (const BundledGrammar& bundled : bundled_grammars(GrammarKind::Points)) texts.push_back(bundled.text);
    std::ranges::sort(texts, {}, &std::string_view::size);
    texts.resize(std::min(texts.size(), point_texts));
    texts.push_back(rich_points);
    return texts;
}

} // namespace

TEST(Damage, EveryPrefixOfAPointGrammarIsReadOrRefusedWithAPlace) {
    for (const std::string_view text : texts_of_points())
        for (std::size_t size = 0; size <= text.size(); ++size) expect_sound_points(text.substr(0, size));
}

TEST(Damage, EveryReplacedByteOfAPointGrammarIsReadOrRefusedWithAPlace) {
    for (const std::string_view text : texts_of_points()) {
        for (std::size_t i = text.find("points"); i < text.size(); ++i) {
            for (const char byte :
                 {'\0', '\xFF', '\n', '(', ')', '[', '^', ',', '>', '-', '/', '.', '0', 'P', ':', '='}) {
                std::string damaged(text);
                damaged[i] = byte;
                expect_sound_points(damaged);
            }
        }
    }
}

TEST(Damage, RandomPiecesOfPointGrammarsAreReadOrRefusedWithAPlace) {
    const std::vector<std::string> pieces{"P(v)",
                                          "E",
                                          "P(u)",
                                          "(",
                                          ")",
                                          "[",
                                          "]",
                                          "<",
                                          ">",
                                          ":",
                                          "->",
                                          "\n",
                                          ",",
                                          "v",
                                          "u",
                                          "t",
                                          "1/2",
                                          "3",
                                          ".5",
                                          "-",
                                          "+",
                                          "*",
                                          "/",
                                          ".x",
                                          "min(",
                                          "and",
                                          "not ",
                                          "==",
                                          "<=",
                                          "f(",
                                          "^2",
                                          "|",
                                          "#",
                                          "?Q",
                                          " ",
                                          "=",
                                          "\xFF",
                                          "t=1\n",
                                          "input ",
                                          "axiom ",
                                          "ring\n",
                                          "table p\n",
                                          "cycle p\n",
                                          "P(v)->P(v)\n",
                                          "interpretation\n"};
    std::mt19937 draw(6);
    const int rounds = tests::times(30'000);
    for (int round = 0; round < rounds; ++round) {
        std::string text = "points\n";
        for (std::size_t i = draw() % 25; i > 0; --i) text += pieces[draw() % pieces.size()];
        expect_sound_points(text);
        if (HasFatalFailure()) return;
    }
}

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
    const int rounds = tests::times(30'000);
    for (int round = 0; round < rounds; ++round) {
        std::string text;
        for (std::size_t i = draw() % 25; i > 0; --i) text += pieces[draw() % pieces.size()];
        expect_sound(text);
    }
}

} // namespace internode
