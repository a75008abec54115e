// SPDX-License-Identifier: MIT

#include "internode/point/check/affine.h"

#include "internode/grammar/bundled.h"
#include "internode/grammar/points/parse_points.h"
#include "tests/fixtures/point_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace internode {
namespace {

using tests::point_grammar;
using tests::point_system;

std::vector<AffineFinding> findings_of(std::string_view text, const PointSettings& settings = {}) {
    return affine_findings(point_system(point_grammar(text), settings));
}

/// Of a grammar with one point expression in its only rule.
AffineFinding only_finding(std::string_view text, const PointSettings& settings = {}) {
    auto findings = findings_of(text, settings);
    std::erase_if(findings, [](const AffineFinding& finding) { return finding.where.part != GrammarPart::Rule; });
    EXPECT_EQ(findings.size(), 1U);
    return findings.at(0);
}

TEST(Affine, SumsOfNumbers) {
    EXPECT_EQ(only_finding("points\nring\nP(u) < P(v) -> P(1/4 u + 3/4 v)").verdict, AffineVerdict::Affine);
    const AffineFinding wrong = only_finding("points\nring\nP(u) < P(v) -> P(1/4 u + v)");
    EXPECT_EQ(wrong.verdict, AffineVerdict::SumIsNotOne);
    EXPECT_EQ(wrong.sum, "5/4");
    EXPECT_EQ(wrong.where.part, GrammarPart::Rule);
    EXPECT_EQ(wrong.where.rule, 0U);
    EXPECT_EQ(only_finding("points\nP(v) -> P(v - v)").sum, "0");
    EXPECT_EQ(only_finding("points\nring\nP(u) < P(v) -> P(v + 3 (u - v) / 4 - 0 v)").verdict, AffineVerdict::Affine);
}

TEST(Affine, SumsAreIdentitiesInConstantsAndNumbers) {
    EXPECT_EQ(only_finding("points\nt = 1/3\nring\nP(u) < P(v) -> P((1-t) u + t v)").verdict, AffineVerdict::Affine);
    const AffineFinding wrong = only_finding("points\nt = 1/3\nring\nP(u) < P(v) -> P((1-t) u - t v)");
    EXPECT_EQ(wrong.verdict, AffineVerdict::SumIsNotOne);
    EXPECT_EQ(wrong.sum, "1 - 2 t");
    EXPECT_EQ(only_finding("points\nring\ninput P(v, 3)\nP(u, n) < P(v, k) -> P((1/n) u + ((n-1)/n) v, n)").verdict,
              AffineVerdict::Affine);
    const AffineFinding number = only_finding("points\nring\ninput P(v, 3)\nP(u, n) < P(v, k) -> P(u/n + v/k, n)");
    EXPECT_EQ(number.sum, "(n + k)/(n k)");
    EXPECT_EQ(number.verdict, AffineVerdict::SumIsNotOne);
}

TEST(Affine, ConstantsThatFitOnlyWithTheirValuesAreSaidToBe) {
    const char* text = "points\na = 1/4\nb = 3/4\nring\nP(u) < P(v) -> P(a u + b v)";
    const AffineFinding finding = only_finding(text);
    EXPECT_EQ(finding.verdict, AffineVerdict::AffineForTheseConstants);
    EXPECT_EQ(finding.sum, "a + b");
    PointSettings settings;
    settings.constants["a"] = Rational(1, 3);
    EXPECT_EQ(only_finding(text, settings).verdict, AffineVerdict::SumIsNotOne);
    EXPECT_FALSE(is_sound(finding.verdict)) << "no identity in the constants";
}

TEST(Affine, ConstantsOfConstantsAreWrittenOutUnlessSet) {
    const char* text = "points\na = 1/4\nb = 1 - a\nring\nP(u) < P(v) -> P(a u + b v)";
    EXPECT_EQ(only_finding(text).verdict, AffineVerdict::Affine);
    PointSettings settings;
    settings.constants["b"] = Rational(1, 2);
    EXPECT_EQ(only_finding(text, settings).verdict, AffineVerdict::SumIsNotOne);
    EXPECT_EQ(only_finding(text, settings).sum, "a + b");
}

TEST(Affine, FunctionsAreWrittenOut) {
    EXPECT_EQ(only_finding("points\nf(x) = 1 - x\ng(x, y) = f(x) f(y)\nring\ninput P(v, 1/2)\n"
                           "P(u, s) < P(v, t) -> P(g(s, t) u + (s + t - s t) v, s)")
                  .verdict,
              AffineVerdict::Affine);
}

TEST(Affine, FunctionsThatAreNoQuotientsAreVariables) {
    const std::string head = "points\nring\ninput P(v, 1/2)\nP(u, s) < P(v, t) -> ";
    EXPECT_EQ(only_finding(head + "P(min(s, t) u + (1 - min(t, s)) v, s)").verdict, AffineVerdict::Affine);
    EXPECT_EQ(only_finding(head + "P(sqrt(s) u + (1 - sqrt(s)) v, s)").verdict, AffineVerdict::Affine);
    const AffineFinding wrong = only_finding(head + "P(min(s, 1) u + v, s)");
    EXPECT_EQ(wrong.verdict, AffineVerdict::SumIsNotOne) << "refuted by an example";
    EXPECT_EQ(wrong.sum, "1 + min(1, s)");
    // min + max of two is their sum: an identity that the check does not know.
    const AffineFinding open = only_finding(head + "P((min(s, t) + max(s, t)) u + (1 - s - t) v, s)");
    EXPECT_EQ(open.verdict, AffineVerdict::NotDecided);
    EXPECT_FALSE(open.reason.empty());
    EXPECT_EQ(only_finding("points\nring\nP(u) < P(v) -> P(sqrt(1/4) u + min(1/2, 3) v)").verdict,
              AffineVerdict::Affine);
}

TEST(Affine, CoordinatesAndLiteralsAreMeant) {
    EXPECT_EQ(only_finding("points\nring\nP(u) < P(v) -> P(1/2 u + 1/2 v + (0, 1))").verdict,
              AffineVerdict::MixesCoordinates);
    EXPECT_EQ(only_finding("points\nP(v) -> P((v.y, v.x))").verdict, AffineVerdict::MixesCoordinates);
    EXPECT_EQ(only_finding("points\nring\nP(u) < P(v) -> P(v.x u + (1 - v.x) v)").verdict,
              AffineVerdict::MixesCoordinates);
    EXPECT_TRUE(is_sound(AffineVerdict::MixesCoordinates));
}

TEST(Affine, EveryPartOfAGrammarIsLookedAt) {
    const auto findings = findings_of("points\n"
                                      "input P(2 v) | P(v) | P(3 v)\n"
                                      "axiom P((0, 0)) P(4 (1, 0))\n"
                                      "P(u) < P(v) -> P(5 u) P(v)\n"
                                      "interpretation\n"
                                      "P(v) -> Q(6 v)\n"
                                      "interpretation\n"
                                      "Q(v) -> L(v, 7 v)\n");
    std::vector<std::string> found;
    for (const AffineFinding& finding : findings)
        if (finding.verdict == AffineVerdict::SumIsNotOne) found.push_back(finding.sum);
    EXPECT_EQ(found, (std::vector<std::string>{"2", "3", "5", "6", "7"}));
    EXPECT_EQ(std::ranges::count(findings, AffineVerdict::MixesCoordinates, &AffineFinding::verdict), 2);
    EXPECT_EQ(findings.size(), 10U);
}

TEST(Affine, BoundsWhatItReads) {
    std::string text = "points\nf0(x) = x x + x\n";
    for (int i = 1; i < 12; ++i) {
        const std::string before = "f" + std::to_string(i - 1);
        text += "f" + std::to_string(i) + "(x) = " + before + "(" + before + "(x))\n";
    }
    text += "ring\ninput P(v, 1/2)\nP(u, s) < P(v, t) -> P(f11(s) u + (1 - f11(s)) v, s)";
    const CheckedPointSystem checked = make_point_system(point_grammar(text));
    if (!checked.system) GTEST_SKIP() << "refused before it is checked";
    const auto findings = affine_findings(*checked.system);
    EXPECT_EQ(findings.back().verdict, AffineVerdict::NotDecided);
    EXPECT_FALSE(findings.back().reason.empty());
}

TEST(Affine, PlacesLeadBackToTheGrammar) {
    const PointGrammar grammar =
        point_grammar("points\ninput # P(2 v) #\nP(u) < P(v) -> P(v) P(3 u)\ninterpretation\nP(v) -> Q(4 v)");
    for (const AffineFinding& finding : affine_findings(point_system(grammar))) {
        EXPECT_EQ(expression_at(grammar, finding.where), expression_at(grammar, finding.where));
        EXPECT_EQ(formals_at(grammar, finding.where).size(), finding.where.part == GrammarPart::Rule ? 2U : 1U);
    }
    EXPECT_THROW((void)expression_at(grammar, {.part = GrammarPart::Rule, .rule = 1}), std::out_of_range);
    EXPECT_THROW((void)expression_at(grammar, {.part = GrammarPart::Rule, .module = 2}), std::out_of_range);
}

std::vector<PointGrammar> bundled_point_grammars() {
    std::vector<PointGrammar> grammars;
    for (const BundledGrammar& bundled : bundled_grammars())
        if (kind_of(bundled.text) == GrammarKind::Points) grammars.push_back(point_grammar(bundled.text));
    return grammars;
}

PointSettings settings_for(const PointGrammar& grammar) {
    PointSettings settings;
    settings.dimension = make_point_system(grammar, settings).system ? 2 : 3;
    return settings;
}

TEST(Affine, EveryBundledGrammarIsSound) {
    const auto grammars = bundled_point_grammars();
    for (const PointGrammar& grammar : grammars)
        for (const AffineFinding& finding : affine_findings(point_system(grammar, settings_for(grammar))))
            EXPECT_TRUE(is_sound(finding.verdict)) << grammar.name << " " << finding.sum << " " << finding.reason;
}

/// The same grammar with one literal of one expression changed.
PointGrammar with_error(PointGrammar grammar, const ArgumentPlace& where, std::size_t literal) {
    // The grammar is this function's own: only the way to the expression is const.
    const_cast<Expression&>(expression_at(grammar, where)).numbers[literal] += Rational(1, 7);
    return grammar;
}

TEST(Affine, FindsOneChangedCoefficientInEveryBundledGrammar) {
    std::size_t planted = 0;
    const auto grammars = bundled_point_grammars();
    for (const PointGrammar& grammar : grammars) {
        const PointSettings settings = settings_for(grammar);
        for (const AffineFinding& sound : affine_findings(point_system(grammar, settings))) {
            // A literal point or a coordinate: wherever it is moved to is a place again, and meant.
            if (sound.verdict == AffineVerdict::MixesCoordinates) continue;
            for (std::size_t literal = 0; literal < expression_at(grammar, sound.where).numbers.size(); ++literal) {
                const auto findings =
                    affine_findings(point_system(with_error(grammar, sound.where, literal), settings));
                const auto found = std::ranges::find(findings, sound.where, &AffineFinding::where);
                ASSERT_NE(found, findings.end());
                EXPECT_EQ(found->verdict, AffineVerdict::SumIsNotOne)
                    << grammar.name << ", rule " << sound.where.rule << ", literal " << literal;
                EXPECT_NE(found->sum, "1");
                EXPECT_EQ(std::ranges::count_if(findings, [](const auto& f) { return !is_sound(f.verdict); }), 1);
                ++planted;
            }
        }
    }
    EXPECT_GE(planted, 3 * grammars.size());
}

TEST(Affine, WrongSumsAreThoseOfTheWordsThatTheSystemHas) {
    const std::string text = "points\naxiom P(2 (1, 1)) Q\ninput P(1/2 v)\nt = 1/4\nP(v) -> P(0.99 v) P(v)\n"
                             "P(u) < P(v) -> P(t u + (1 - t) v) P(3 t v + t u)\nQ -> Q\n";
    const auto sums = [&](PointStart start) {
        std::vector<std::string> found;
        for (const AffineFinding& finding : wrong_sums(point_system(point_grammar(text), {.start = start})))
            found.push_back(finding.sum);
        return found;
    };
    EXPECT_EQ(sums(PointStart::Input), (std::vector<std::string>{"1/2", "99/100"}));
    EXPECT_EQ(sums(PointStart::Axiom), std::vector<std::string>{"99/100"});
}

} // namespace
} // namespace internode
