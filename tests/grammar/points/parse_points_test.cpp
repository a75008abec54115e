// SPDX-License-Identifier: MIT
//
// What a point grammar's text means, statement by statement.

#include "internode/grammar/points/parse_points.h"

#include "internode/grammar/lexing/grammar_kind.h"
#include "internode/grammar/points/print_points.h"
#include "tests/fixtures/source_folder.h"

#include <gmock/gmock.h>

#include <fstream>

namespace internode {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

PointGrammar grammar_of(std::string_view statements) {
    const ParsedPointGrammar parsed = parse_point_grammar("points\n" + std::string(statements), "t");
    EXPECT_TRUE(parsed.grammar) << to_string(parsed.errors);
    return parsed.grammar.value_or(PointGrammar{});
}

/// The normal form of one rule.
std::string rule(std::string_view text) {
    const PointGrammar grammar = grammar_of(text);
    return grammar.rules.empty() ? std::string() : print(grammar.rules.back(), grammar);
}

/// The normal form of a value over the formals u and v.
std::string value(const std::string& text) {
    const PointGrammar grammar = grammar_of("t = 1/2, f(x) = 2x\nP(u) < P(v) -> P(" + text + ")");
    return grammar.rules.empty() ? std::string()
                                 : print(grammar.rules[0].successor[0].arguments[0], grammar.rules[0].formals, grammar);
}

std::vector<std::string> names(const std::vector<Symbol>& letters, const PointGrammar& grammar) {
    std::vector<std::string> result;
    for (const Symbol letter : letters) result.push_back(grammar.letters.name(letter));
    return result;
}

} // namespace

TEST(ParsePoints, ARuleHasItsPartsInTheirPlaces) {
    const PointGrammar grammar = grammar_of("p1: # P(a) E < P(v, s) Q' > E P(b) #: s < 1 -> P(v, 2) E : 1/2");
    const PointRule& read = grammar.rules.at(0);
    EXPECT_EQ(read.label, "p1");
    EXPECT_THAT(names(read.left, grammar), ElementsAre("#", "P", "E"));
    EXPECT_THAT(names(read.predecessor, grammar), ElementsAre("P/2", "Q'"));
    EXPECT_THAT(names(read.right, grammar), ElementsAre("E", "P", "#"));
    EXPECT_THAT(read.formals, ElementsAre("a", "v", "s", "b"));
    EXPECT_TRUE(read.condition && read.weight);
    EXPECT_EQ(read.successor.size(), 2u);
    EXPECT_EQ(read.place.offset, 7u);
}

TEST(ParsePoints, AColonAfterASingleNameEndsALabelUnlessAParenthesisFollows) {
    EXPECT_EQ(rule("p : P(v) -> ."), "p : P(v) -> .");
    EXPECT_EQ(rule("p : E -> ."), "p : E -> .");
    EXPECT_EQ(rule("t = 1\nE : (t < 2) -> ."), "E : (t < 2) -> .");
    EXPECT_EQ(rule("t = 1\nE : (t) < 2 and t > 0 -> ."), "E : (t < 2 and t > 0) -> .");
    EXPECT_EQ(rule("t = 1\nE : ((t + 1) t < 2) -> ."), "E : (t + 1) t < 2 -> .");
    EXPECT_EQ(rule("t = 1\nE E : t < 2 -> ."), "E E : t < 2 -> .");
    EXPECT_EQ(rule("p : E : 1 < 2 -> ."), "p : E : 1 < 2 -> .");
    EXPECT_EQ(rule("# : (1 < 2) -> #"), "# : 1 < 2 -> #");
}

TEST(ParsePoints, LettersStandSideBySideOrApart) {
    EXPECT_EQ(rule("IP(v)I -> P ( v ) ^ 2EF2'G_1"), "I P(v) I -> P(v) P(v) E F2' G_1");
    EXPECT_EQ(rule("E -> [E[E]]E"), "E -> [ E [ E ] ] E");
    EXPECT_EQ(rule("E -> [\n E\n ] E"), "E -> [ E ] E");
    EXPECT_EQ(rule("E -> \xCE\xB5"), "E -> .");
    EXPECT_EQ(rule("P(v)?Q(a,b) \xE2\x86\x92 P(v) ?Q(a, b)"), "P(v) ?Q(a, b) -> P(v) ?Q(a, b)");
}

TEST(ParsePoints, ALetterWithAnotherNumberOfParametersIsAnotherSymbol) {
    const PointGrammar grammar = grammar_of("axiom A(1) B(2, 3)\nA(x) : x > 2 -> B(2x)\nA(w) < B(x, y) -> A(w + x)");
    EXPECT_THAT(grammar.letters.names(), ElementsAre("A", "B", "B/1"));
    EXPECT_THAT(grammar.arity, ElementsAre(1u, 2u, 1u));
    EXPECT_EQ(find_letter(grammar, "B", 1), to_symbol(2));
    EXPECT_EQ(find_letter(grammar, "B", 2), to_symbol(1));
    EXPECT_EQ(find_letter(grammar, "B", 3), std::nullopt);
    EXPECT_EQ(letter_text(grammar, to_symbol(2)), "B");
    EXPECT_EQ(print(grammar.rules[0], grammar), "A(x) : x > 2 -> B(2 x)");
}

TEST(ParsePoints, FractionsAreNumbersAndJuxtapositionMultiplies) {
    EXPECT_EQ(value("1/4u+3/4v"), "1/4 u + 3/4 v");
    EXPECT_EQ(value("1/4 \xC2\xB7 u + .75 v"), "1/4 u + 3/4 v");
    EXPECT_EQ(value("(1-t)u + t v"), "(1 - t) u + t v");
    EXPECT_EQ(value("2u(v+1)"), "2 u (v + 1)");
    EXPECT_EQ(value("-1/16 u - 1/16 v"), "-1/16 u - 1/16 v");
    EXPECT_EQ(value("f(v) u f(2)"), "f(v) u f(2)");
    EXPECT_EQ(value("t(v)"), "t v");
    EXPECT_EQ(value("u/3/4"), "u/3/4");
    EXPECT_EQ(value("u * 3/4"), "u * 3/4");
    EXPECT_EQ(value("(u * 3)/4"), "u * (3)/4");
    EXPECT_EQ(value("u/(3/4)"), "u/(3/4)");
    EXPECT_EQ(value("u/.75"), "u/(3/4)");
    EXPECT_EQ(value("u / -2/3"), "u/-2/3");
    EXPECT_EQ(value("6/3/4 v"), "1/2 v");
    EXPECT_EQ(value("u/v * t"), "u/v * t");
    EXPECT_EQ(value("u v/t"), "u v/t");
}

TEST(ParsePoints, LiteralsAreFoldedExactly) {
    EXPECT_EQ(value("1 - 1/4"), "3/4");
    EXPECT_EQ(value("(1 - 1/4) v"), "3/4 v");
    EXPECT_EQ(value("-(2 * 0.1) v"), "-1/5 v");
    EXPECT_EQ(value("v + 1 + 1"), "v + 1 + 1");
    EXPECT_EQ(value("1 + 1 + v"), "2 + v");
    EXPECT_EQ(value("min(1, 2)"), "min(1, 2)");
}

TEST(ParsePoints, OperationsBindAsInMathematics) {
    EXPECT_EQ(value("u-(v-t)"), "u - (v - t)");
    EXPECT_EQ(value("(u-v)-t"), "u - v - t");
    EXPECT_EQ(value("-u v"), "-u v");
    EXPECT_EQ(value("-(u v)"), "-(u v)");
    EXPECT_EQ(value("--u"), "--u");
    EXPECT_EQ(value("u - -v"), "u - -v");
    EXPECT_EQ(value("u * -v"), "u * -v");
    EXPECT_EQ(value("-u.x"), "-u.x");
    EXPECT_EQ(value("(u + v).y"), "(u + v).y");
    EXPECT_EQ(value("min(u, min(v, t))"), "min(u, min(v, t))");
    EXPECT_EQ(value("min(min(u, v), t)"), "min(u, v, t)");
    EXPECT_EQ(value("max(u, v, t, 1)"), "max(u, v, t, 1)");
    EXPECT_EQ(value("floor(u) abs(v) sqrt(t)"), "floor(u) abs(v) sqrt(t)");
    EXPECT_EQ(rule("A(x, y) : not x<1 and y=2 or x\xE2\x89\xA5y -> ."),
              "A(x, y) : not x < 1 and y == 2 or x >= y -> .");
    EXPECT_EQ(rule("A(x, y) : not (x \xE2\x89\xA4 1 and (y \xE2\x89\xA0 2 or x>y)) -> ."),
              "A(x, y) : not (x <= 1 and (y != 2 or x > y)) -> .");
}

TEST(ParsePoints, FormalsHideDefinitions) {
    const PointGrammar grammar = grammar_of("t = 1/2\nf(s, t) = min(s, 1) + min(t, 1)\nP(v, f) -> P(t v, f(2))");
    EXPECT_THAT(grammar.definitions.at(1).formals, ElementsAre("s", "t"));
    EXPECT_EQ(print(grammar.definitions[1].value, grammar.definitions[1].formals, grammar), "min(s, 1) + min(t, 1)");
    EXPECT_EQ(print(grammar.rules[0], grammar), "P(v, f) -> P(t v, f * 2)");
}

TEST(ParsePoints, TheInputNamesItsPoint) {
    const PointGrammar one = grammar_of("w = 2\ninput P(w p, w) E\nP(v, s) -> .");
    EXPECT_EQ(one.input->formal, "p");
    EXPECT_FALSE(one.input->has_ends);
    EXPECT_THAT(one.input->first, IsEmpty());
    const PointGrammar marked = grammar_of("input # P(v) #\nP(v) -> .");
    EXPECT_TRUE(marked.input->has_ends);
    EXPECT_EQ(marked, grammar_of("input # P(v) | P(v) |\n P(v) #\nP(v) -> ."));
    EXPECT_EQ(grammar_of("E -> E").input, std::nullopt);
}

TEST(ParsePoints, TablesHoldTheRulesAfterThem) {
    const PointGrammar grammar = grammar_of("n = 2\nA -> A\ntable p\nB -> B\ntable q, C -> C, cycle p q^n q^0 p^(n+1) "
                                            "q^3\ninterpretation\nD -> D\ninterpretation");
    EXPECT_THAT(grammar.tables, ElementsAre("p", "q"));
    EXPECT_EQ(grammar.rules.at(0).table, std::nullopt);
    EXPECT_EQ(grammar.rules.at(1).table, 0u);
    EXPECT_EQ(grammar.rules.at(2).table, 1u);
    ASSERT_EQ(grammar.cycle.size(), 5u);
    EXPECT_EQ(grammar.cycle[0].count, std::nullopt);
    EXPECT_EQ(grammar.cycle[1].table, 1u);
    ASSERT_EQ(grammar.interpretations.size(), 2u);
    EXPECT_EQ(grammar.interpretations[0].size(), 1u);
    EXPECT_EQ(grammar.interpretations[0][0].table, std::nullopt);
}

TEST(ParsePoints, StatementsMayComeInAnyOrder) {
    const PointGrammar grammar = grammar_of("P(v) : t < 1 -> Q(v)\naxiom Q((0, t))\nt = 1/2\nring\ninput P(v)");
    EXPECT_TRUE(grammar.ring);
    EXPECT_THAT(grammar.letters.names(), ElementsAre("P", "Q"));
    EXPECT_EQ(print(grammar), "points\nring\nt = 1/2\ninput P(v)\naxiom Q((0, t))\nP(v) : t < 1 -> Q(v)\n");
}

TEST(ParsePoints, TheKindIsTheFirstWord) {
    EXPECT_EQ(kind_of("points x\nP(v) -> P(v)"), GrammarKind::Points);
    EXPECT_EQ(kind_of("// points\n\n;points"), GrammarKind::Points);
    EXPECT_EQ(kind_of("intervals x"), GrammarKind::Intervals);
    EXPECT_EQ(kind_of("P(v) -> P(v)"), GrammarKind::Intervals);
    EXPECT_EQ(kind_of("pointsx"), GrammarKind::Intervals);
    EXPECT_EQ(kind_of(""), GrammarKind::Intervals);
    EXPECT_EQ(grammar_of("E -> E").name, "");
    EXPECT_EQ(parse_point_grammar("points \"a b\"; E -> E", "t").grammar->name, "a b");
}

TEST(ParsePoints, PlacesPointIntoTheText) {
    const std::string text = "points\nP(u) < P(v) ->\n  P(1/2 u + 1/2 v)";
    const PointGrammar grammar = *parse_point_grammar(text, "t").grammar;
    const Expression& position = grammar.rules[0].successor[0].arguments[0];
    EXPECT_EQ(text.substr(position.place.offset, position.place.bytes), "1/2 u + 1/2 v");
    EXPECT_EQ(to_string(diagnostic_at(text, "t", position.place, "the coefficients sum to 1", "fine")),
              "t:3:5: error: the coefficients sum to 1\n      P(1/2 u + 1/2 v)\n        ^^^^^^^^^^^^^\nhint: fine\n");
}

TEST(ParsePoints, TheGrammarsOfTheDocumentationAreRead) {
    std::ifstream page(tests::in_source_folder("docs/language.md"));
    std::vector<std::string> texts(1);
    bool in_fence = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("```")) in_fence = !in_fence; // examples of errors stand between fences
        const bool is_code = !in_fence && line.starts_with("    ");
        if (is_code)
            texts.back() += line.substr(4) + '\n';
        else if (!texts.back().empty())
            texts.emplace_back();
    }
    int read = 0;
    for (const std::string& text : texts) {
        if (kind_of(text) != GrammarKind::Points) continue;
        EXPECT_TRUE(parse_point_grammar(text, "t").grammar) << to_string(parse_point_grammar(text, "t").errors);
        ++read;
    }
    EXPECT_GE(read, 2);
}

TEST(DiagnosticAt, OfNoBytesMeansTheWholeGrammar) {
    const std::string text = "points\nP(v) -> P(v)";
    const Diagnostic rule = diagnostic_at(text, "g", SourcePlace{7, 1}, "a rule", "a hint");
    EXPECT_EQ(rule.line, 2U);
    EXPECT_EQ(rule.source_line, "P(v) -> P(v)");
    const Diagnostic whole = diagnostic_at(text, "g", SourcePlace{}, "all of it", "a hint");
    EXPECT_EQ(whole.line, 0U);
    EXPECT_EQ(to_string(whole), "g: error: all of it\nhint: a hint\n");
}

} // namespace internode
