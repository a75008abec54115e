// SPDX-License-Identifier: MIT

#include "internode/grammar/points/parse_points.h"
#include "internode/report/json/point_validation_json.h"
#include "internode/report/text/point_validation_text.h"
#include "tests/fixtures/point_systems.h"
#include "tests/report/systems.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tests::point_grammar;

std::string text_of(std::string_view text) {
    const PointGrammar grammar = point_grammar(text);
    return point_validation_text(make_point_validation(grammar), grammar, {text, "test.lsys"});
}

std::string json_of(std::string_view text) {
    const PointGrammar grammar = point_grammar(text);
    return point_validation_json(make_point_validation(grammar), grammar, {text, "test.lsys"},
                                 {"0.1.0", "internode validate"});
}

const std::string chaikin = "points chaikin\nring\nP(u) < P(v) > P(p) -> P(1/4 u + 3/4 v) P(3/4 v + 1/4 p)\n";
const std::string wrong = "points wrong\nt = 1/2\nring\np1: P(u) < P(v) ->\n    P((1-t) u - t v) P(v)\n";
const std::string number = "points number\nP(v) -> P(v + 1)\n";
const std::string open_four = "points\nP(u) < P(v) > P(p) P(q) -> P(v) P(-1/16 u + 9/16 v + 9/16 p - 1/16 q)\n";

TEST(PointValidationText, SaysWhatChaikinIs) {
    const std::string text = text_of(chaikin);
    EXPECT_THAT(text, HasSubstr("chaikin: valid\n"));
    EXPECT_THAT(text, HasSubstr("a(z) = 1/4 z^-1 (1 + z)^3"));
    EXPECT_THAT(text, HasSubstr("uniform quadratic B-spline"));
    EXPECT_THAT(text, HasSubstr("Chaikin's corner cutting"));
    EXPECT_THAT(text, HasSubstr("`intervals A -> A A` at degree 2"));
    EXPECT_THAT(text, HasSubstr("C^1 (proved); Hölder exponent 2 (proved)"));
    EXPECT_THAT(text, HasSubstr("(k - 1/2)/2"));
}

TEST(PointValidationText, NamesTheRuleTheSumAndTheLine) {
    const std::string text = text_of(wrong);
    EXPECT_THAT(text, HasSubstr("wrong: not valid\n"));
    EXPECT_THAT(text,
                HasSubstr("line 5: rule 1 (`p1`), module 1: in `(1 - t) u - t v` the coefficients sum to 1 - 2 t"));
}

TEST(PointValidationText, NamesPointsThatStay) {
    const std::string text = text_of(open_four);
    EXPECT_THAT(text, HasSubstr("The grammar is not valid\n"));
    EXPECT_THAT(text, HasSubstr("inside the word"));
    EXPECT_THAT(text, HasSubstr("not complete"));
}

TEST(PointValidationText, NamesModulesOfTheAxiomThatStay) {
    const std::string rule = "P(u) < P(v) > P(p) P(q) -> P(v) P(-1/16 u + 9/16 v + 9/16 p - 1/16 q)\n";
    EXPECT_THAT(text_of("points\naxiom P((0, 0)) P((1, 0)) P((2, 1)) P((3, 0)) P((4, 0))\n" + rule),
                HasSubstr(", from the axiom\n"));
    EXPECT_THAT(text_of(open_four), Not(HasSubstr("from the axiom")));
}

TEST(PointValidationJson, HasARuleForPlacesInRulesOnly) {
    const std::string json = json_of("points\naxiom P((0, 0))\nP(v) -> P(v) P((1, 1))\n");
    EXPECT_THAT(json, HasSubstr(R"("part": "axiom", "pass": null, "rule": null,)"));
    EXPECT_THAT(json, HasSubstr(R"("part": "rule", "pass": null, "rule": 0,)"));
}

TEST(PointValidationText, NamesProblemsOfKinds) {
    const std::string text = text_of(number);
    EXPECT_THAT(text, HasSubstr("number: not valid\n  - line 2: "));
    EXPECT_THAT(text, Not(HasSubstr("coverage")));
}

TEST(PointValidationText, ListsAtMostTwentyFindings) {
    std::string text = "points\n";
    for (int i = 0; i < 30; ++i) text += "P(v) -> P(2 v)\n";
    EXPECT_THAT(text_of(text), HasSubstr("and 10 more"));
}

TEST(PointValidationText, ShowsNamesWithoutObeyingThem) {
    PointGrammar grammar = point_grammar(chaikin);
    grammar.name = testing_report::hostile;
    const std::string text =
        point_validation_text(make_point_validation(grammar), grammar, {chaikin, testing_report::hostile});
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find("\xE2\x80\xAE"), std::string::npos);
}

TEST(PointValidationJson, IsInert) {
    PointGrammar grammar = point_grammar(chaikin);
    grammar.name = testing_report::hostile;
    testing_report::expect_inert(point_validation_json(make_point_validation(grammar), grammar,
                                                       {chaikin, testing_report::hostile}, {"0.1.0", "internode"}));
}

TEST(PointValidationJson, SaysTheSameAsTheText) {
    const std::string json = json_of(chaikin);
    EXPECT_THAT(json, HasSubstr(R"("format": "internode-point-validation")"));
    EXPECT_THAT(json, HasSubstr(R"("valid": true)"));
    EXPECT_THAT(json, HasSubstr(R"("symbol": "1/4 z^-1 (1 + z)^3")"));
    EXPECT_THAT(json, HasSubstr(R"("family": "chaikin")"));
    EXPECT_THAT(json, HasSubstr(R"({"lower": 2, "upper": 2, "upper_is_proved": true})"));
    EXPECT_THAT(json, HasSubstr(R"("intervals": {"arity": 2, "degree": 2, "moved": 1})"));
}

TEST(PointValidationJson, FindingsHaveTheirPlace) {
    EXPECT_THAT(json_of(wrong), HasSubstr(R"("verdict": "sum-is-not-one", "sum": "1 - 2 t")"));
    EXPECT_THAT(json_of(wrong), HasSubstr(R"("line": 5)"));
    EXPECT_THAT(json_of(number), HasSubstr(R"("coverage": null)"));
    EXPECT_THAT(json_of(open_four), HasSubstr(R"("ends_complete": false)"));
}

TEST(PlaceText, NamesEveryPart) {
    const PointGrammar grammar =
        point_grammar("points\naxiom P((0, 0))\ninput P(v)\nq: P(v) -> P(v) P(v)\ninterpretation\nP(v) -> Q(v)\n");
    EXPECT_EQ(place_text(grammar, {.part = GrammarPart::Axiom}), "the axiom, module 1");
    EXPECT_EQ(place_text(grammar, {.part = GrammarPart::Input}), "the input, module 1");
    EXPECT_EQ(place_text(grammar, {.part = GrammarPart::Rule, .module = 1}), "rule 1 (`q`), module 2");
    EXPECT_EQ(place_text(grammar, {.part = GrammarPart::Interpretation}), "interpretation 1, rule 1, module 1");
}

} // namespace
} // namespace internode
