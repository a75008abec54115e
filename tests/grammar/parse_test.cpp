// SPDX-License-Identifier: MIT
//
// One way in for every kind: parse() finds the kind, and reads as the reader of that kind alone reads.

#include "internode/grammar/parse.h"

#include "internode/grammar/bundled.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/grammar/print.h"

#include <gtest/gtest.h>

#include <string>

namespace internode {

namespace {

template<class Kind>
void expect_same(const Parsed<Grammar>& any, const Parsed<Kind>& one, std::string_view text) {
    ASSERT_EQ(to_string(any.errors), to_string(one.errors)) << text;
    ASSERT_EQ(any.grammar.has_value(), one.grammar.has_value()) << text;
    if (!any.grammar) return;
    ASSERT_TRUE(std::holds_alternative<Kind>(*any.grammar)) << text;
    ASSERT_EQ(std::get<Kind>(*any.grammar), *one.grammar) << text;
}

void expect_as_its_kind_reads(std::string_view text) {
    const Parsed<Grammar> any = parse(text, "t");
    ASSERT_EQ(any.grammar.has_value(), any.errors.empty()) << text;
    if (any.grammar) {
        ASSERT_EQ(kind_of(*any.grammar), kind_of(text)) << text;
    }
    if (kind_of(text) == GrammarKind::Points)
        expect_same(any, parse_point_grammar(text, "t"), text);
    else
        expect_same(any, parse_grammar(text, "t"), text);
}

} // namespace

TEST(ParseAny, EveryBundledGrammarSurvivesPrintingAndReading) {
    for (const BundledGrammar& bundled : bundled_grammars()) {
        const Parsed<Grammar> read = parse(bundled.text, bundled.name);
        ASSERT_TRUE(read.grammar) << to_string(read.errors);
        EXPECT_EQ(kind_of(*read.grammar), bundled.kind) << bundled.name;
        EXPECT_EQ(name_of(*read.grammar), bundled.name);
        const std::string printed = print(*read.grammar);
        const Parsed<Grammar> again = parse(printed, "printed");
        ASSERT_TRUE(again.grammar) << to_string(again.errors);
        EXPECT_EQ(*again.grammar, *read.grammar) << bundled.name;
        EXPECT_EQ(print(*again.grammar), printed);
    }
}

TEST(ParseAny, EveryPrefixIsReadAsItsKindReadsIt) {
    for (const BundledGrammar& bundled : bundled_grammars()) {
        const std::size_t stride = bundled.text.size() < 300 ? 1 : 7;
        for (std::size_t size = 0; size <= bundled.text.size(); size += stride) {
            expect_as_its_kind_reads(bundled.text.substr(0, size));
            if (HasFatalFailure()) return;
        }
    }
}

TEST(ParseAny, TheKindIsNamedByTheFirstStatement) {
    const auto kind = [](std::string_view text) { return kind_of(parse(text, "t").grammar.value()); };
    EXPECT_EQ(kind("points x\nP(v) -> P(v)"), GrammarKind::Points);
    EXPECT_EQ(kind("// points\n\n;points,P(v) -> P(v)"), GrammarKind::Points);
    EXPECT_EQ(kind("intervals x\nL -> L L"), GrammarKind::Intervals);
    EXPECT_EQ(kind("L -> L L"), GrammarKind::Intervals);
    EXPECT_EQ(kind("// points\nL -> L L"), GrammarKind::Intervals);
}

TEST(ParseAny, SquareBracketsBelongToPointGrammars) {
    EXPECT_TRUE(parse("points\nP(v) -> [ P(v)\nP(v) ] P(v)", "t").grammar);
    EXPECT_FALSE(parse("L -> [ L L ] L", "t").grammar);
}

TEST(ParseAny, KindsToComeAreRefusedByName) {
    for (const std::string kind : {"patches", "mesh"}) {
        const Parsed<Grammar> read = parse(kind + " x\nL -> L L", "t");
        ASSERT_EQ(read.errors.size(), 1u);
        EXPECT_EQ(read.errors[0].message,
                  "a grammar of kind `" + kind + "`: this version reads `intervals` and `points` only");
    }
}

TEST(ParseAny, AReaderOfOneKindRefusesTheOther) {
    const ParsedGrammar intervals = parse_grammar("points x\nP(v) -> P(v)", "t");
    ASSERT_EQ(intervals.errors.size(), 1u);
    EXPECT_EQ(intervals.errors[0].message, "a point grammar where an interval grammar is wanted");
    const ParsedPointGrammar points = parse_point_grammar("intervals x\nL -> L L", "t");
    ASSERT_EQ(points.errors.size(), 1u);
    EXPECT_EQ(points.errors[0].message, "a grammar of kind `intervals` where a point grammar is wanted");
}

TEST(ParseAny, ATextThatIsTooLargeIsNotRead) {
    const std::string text((std::size_t{16} << 20) + 1, '\n');
    const Parsed<Grammar> read = parse(text, "t");
    ASSERT_EQ(read.errors.size(), 1u);
    EXPECT_EQ(read.errors[0].message, "a text of 16777217 bytes, more than 16777216");
}

} // namespace internode
