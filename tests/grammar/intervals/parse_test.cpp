// SPDX-License-Identifier: MIT

#include "internode/grammar/intervals/parse.h"

#include "internode/grammar/intervals/print.h"

#include <gtest/gtest.h>

namespace internode {

namespace {

/// The normal form of a text, or its errors.
std::string normal_form(std::string_view text) {
    const ParsedGrammar parsed = parse_grammar(text, "t");
    return parsed.grammar ? print(*parsed.grammar) : to_string(parsed.errors);
}

struct Case {
    std::string_view text;
    std::string_view printed;
};

constexpr std::string_view fibonacci = "intervals fibonacci\nL -> SL\nS -> L\n";

} // namespace

TEST(Parse, ReadsEveryWayOfWritingFibonacci) {
    constexpr std::array<std::string_view, 14> texts{
        "intervals fibonacci\nL -> S L\nS -> L\n",
        "intervals fibonacci\nL->SL\nS->L",
        "intervals fibonacci, L -> SL, S -> L",
        "intervals fibonacci; L -> SL; S -> L;",
        ";;intervals fibonacci;;\n,L -> SL,,S -> L,\n",
        "  intervals  fibonacci\n\tL ->\tS L\n\n  S -> L\n\n",
        "intervals \"fibonacci\"\nL -> SL\nS -> L\n",
        "intervals \"\\u{66}ibonacci\"\nL -> SL\nS -> L\n",
        "// a comment\nintervals fibonacci // -> ( \"\nL -> SL // more\nS -> L // no newline",
        "intervals fibonacci\r\nL -> SL\r\nS -> L\r\n",
        "intervals fibonacci\rL -> SL\rS -> L\r",
        "\xEF\xBB\xBFintervals fibonacci\nL -> SL\nS -> L\n",
        "intervals fibonacci\nL \xE2\x86\x92 SL\nS\xE2\x86\x92L\n",
        "intervals fibonacci\nL ->\n  S L\nS -> // the rest follows\n\n  L\n",
    };
    for (const std::string_view text : texts) EXPECT_EQ(normal_form(text), fibonacci) << text;
}

TEST(Parse, TakesAFirstArrowForIntervals) {
    EXPECT_EQ(normal_form("L->SL, S->L"), "intervals\nL -> SL\nS -> L\n");
    EXPECT_EQ(normal_form("intervals\nL->SL, S->L"), "intervals\nL -> SL\nS -> L\n");
}

TEST(Parse, PrintsTheNormalForm) {
    const std::vector<Case> cases{
        {"A1->A1A2,A2->A2A2A2", "intervals\nA1 -> A1 A2\nA2 -> A2 A2 A2\n"},
        {"ab->a", "error"},
        {"a->ab,b->a", "intervals\na -> ab\nb -> a\n"},
        {"a->aA,A->a", "intervals\na -> aA\nA -> a\n"},
        {"L_1'->L_1'S2,S2->L_1'", "intervals\nL_1' -> L_1' S2\nS2 -> L_1'\n"},
        {"L0 -> L0 L0", "intervals\nL0 -> L0 L0\n"},
        {"L->L^3S,S->(LS)^2L", "intervals\nL -> LLLS\nS -> LSLSL\n"},
        {"L->L ^ 2 S,S->L^2S", "intervals\nL -> LLS\nS -> LLS\n"},
        {"L->L^2S^2L,S->L", "intervals\nL -> LLSSL\nS -> L\n"},
        {"L->LL,axiom 0 0 L 0 0", "intervals\nL -> LL\naxiom 0 0 L 0 0\n"},
        {"L->LL,axiom 0^3(LL)^2 000", "intervals\nL -> LL\naxiom 0 0 0 LLLL 0 0 0\n"},
        {"L->LL,axiom(LLL)", "intervals\nL -> LL\naxiom (LLL)\n"},
        {"L->LL,axiom (\n LL\n L 0)", "intervals\nL -> LL\naxiom (LLL 0)\n"},
        {"L->LL,axiom (LL)^2", "intervals\nL -> LL\naxiom LLLL\n"},
        {"L->LL,ring,axiom (LL)^2", "intervals\nL -> LL\naxiom (LLLL)\n"},
        {"L->LL,axiom (L),ring", "intervals\nL -> LL\naxiom (L)\n"},
        {"L->LL,length L=3/2", "intervals\nL -> LL\nlength L = 3/2\n"},
        {"L->LL,length L = 6 / 4", "intervals\nL -> LL\nlength L = 3/2\n"},
        {"L->LL,length L = 0.25,length L=1/4", "intervals\nL -> LL\nlength L = 1/4\n"},
        {"L->LL,length L = 1.5e-3", "intervals\nL -> LL\nlength L = 3/2000\n"},
        {"length S=2,length L=1,axiom SL,L->SL,S->L", "error"},
        {"intervals,length S=2,length L=1,axiom SL,L->SL,S->L",
         "intervals\nL -> SL\nS -> L\naxiom SL\nlength S = 2\nlength L = 1\n"},
        {"intervals \"my \\\"own\\\" \xC3\xA9\\\\\"\nA->AA", "intervals \"my \\\"own\\\" \\u{e9}\\\\\"\nA -> AA\n"},
        {"intervals \"\"\nA->AA", "intervals\nA -> AA\n"},
        {"intervals intervals\na->a", "intervals intervals\na -> a\n"},
    };
    for (const auto& [text, printed] : cases) {
        if (printed == "error")
            EXPECT_FALSE(parse_grammar(text, "t").grammar) << text;
        else
            EXPECT_EQ(normal_form(text), printed) << text;
    }
}

TEST(Parse, OrdersSymbolsByTheirRules) {
    const ParsedGrammar parsed = parse_grammar("A -> C B, B -> A, C -> A", "t");
    ASSERT_TRUE(parsed.grammar);
    EXPECT_EQ(parsed.grammar->alphabet.names(), (std::vector<std::string>{"A", "B", "C"}));
    EXPECT_EQ(parsed.grammar->rules.images().front(), (Word{to_symbol(2), to_symbol(1)}));
}

TEST(Parse, ReadsAKeywordAsSymbolsWhereAnArrowFollows) {
    EXPECT_EQ(normal_form("a->x i, x->a, i->a"), "intervals\na -> xi\nx -> a\ni -> a\n");
}

} // namespace internode
