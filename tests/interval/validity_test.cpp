// SPDX-License-Identifier: MIT

#include "internode/interval/validity.h"

#include "tests/fixtures/interval_grammars.h"

#include <cmath>
#include <gmock/gmock.h>

namespace internode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using tests::fibonacci_grammar;
using tests::make_grammar;
using tests::slow_growth;
using tests::with_axiom;
using tests::with_length;

std::vector<Number> exact(const std::vector<Quantity>& quantities) {
    std::vector<Number> result;
    for (const Quantity& quantity : quantities) result.push_back(quantity.exact.value());
    return result;
}

std::vector<std::string> messages(const Verdict& verdict) {
    std::vector<std::string> result;
    for (const Reason& reason : verdict.reasons) result.push_back(reason.message);
    return result;
}

std::vector<ReasonCode> codes(const Verdict& verdict) {
    std::vector<ReasonCode> result;
    for (const Reason& reason : verdict.reasons) result.push_back(reason.code);
    return result;
}

TEST(Validity, FibonacciHasTheGoldenRatio) {
    const Verdict verdict = validate(fibonacci_grammar());
    ASSERT_EQ(verdict.decision, Decision::Valid);
    EXPECT_TRUE(verdict.exact);
    EXPECT_THAT(verdict.reasons, IsEmpty());
    EXPECT_THAT(verdict.theorems, ElementsAre("3.7", "3.8"));
    EXPECT_THAT(verdict.field->minimal_polynomial(), ElementsAre(-1, -1, 1));
    const Number& phi = verdict.field->generator();
    EXPECT_THAT(exact(verdict.lengths), ElementsAre(phi, Number(1)));
    EXPECT_THAT(exact(verdict.frequencies), ElementsAre(1 / phi, 1 / (phi * phi)));
    EXPECT_EQ(verdict.ratio.value, 1.618033988749895);
    EXPECT_EQ(verdict.pisot, true);
    EXPECT_EQ(verdict.period, 1U);
    EXPECT_EQ(verdict.free_lengths, 1U);
    EXPECT_EQ(verdict.system->ratio_name(), "φ");
    EXPECT_EQ(verdict.system->ratio(), phi);
}

TEST(Validity, RefusesAFinalClassThatNeverSplits) {
    const Verdict verdict = validate(make_grammar({{"A1", "A1 A1 A2"}, {"A2", "A2"}}));
    EXPECT_EQ(verdict.decision, Decision::Invalid);
    EXPECT_THAT(codes(verdict), ElementsAre(ReasonCode::NeverSplits));
    EXPECT_THAT(messages(verdict),
                ElementsAre("class {A2} never splits (its own ratio is 1) but the system's ratio is 2"));
    EXPECT_FALSE(verdict.system);
    EXPECT_THAT(verdict.lengths, IsEmpty());
}

TEST(Validity, RefusesARatioOfOne) {
    const Verdict verdict = validate(make_grammar({{"A1", "A2"}, {"A2", "A1"}}));
    EXPECT_EQ(verdict.decision, Decision::Invalid);
    EXPECT_THAT(codes(verdict), ElementsAre(ReasonCode::RatioOne));
    EXPECT_THAT(messages(verdict), ElementsAre("ρ = 1: lengths cannot shrink geometrically"));
}

TEST(Validity, AcceptsAGraphThatIsNotStronglyConnected) {
    const Verdict verdict = validate(make_grammar({{"A1", "A1 A2"}, {"A2", "A2 A2 A2"}}));
    ASSERT_EQ(verdict.decision, Decision::Valid);
    EXPECT_THAT(verdict.theorems, ElementsAre("criterion"));
    EXPECT_EQ(*verdict.ratio.exact, Number(3));
    EXPECT_THAT(exact(verdict.lengths), ElementsAre(Number(1), Number(2)));
    EXPECT_THAT(exact(verdict.frequencies), ElementsAre(Number(0), Number(1)));
}

TEST(Validity, EveryFinalClassHasAFreeLength) {
    const Verdict verdict = validate(make_grammar({{"A1", "A1 A1"}, {"A2", "A2 A2"}}));
    ASSERT_EQ(verdict.decision, Decision::Valid);
    EXPECT_EQ(verdict.free_lengths, 2U);
    EXPECT_THAT(exact(verdict.lengths), ElementsAre(Number(1), Number(1)));
    EXPECT_THAT(verdict.frequencies, IsEmpty()) << "they depend on an axiom";
}

TEST(Validity, SlowGrowthHasPowersOfItsRatioForLengths) {
    for (std::size_t n = 2; n <= 12; ++n) {
        const Verdict verdict = validate(slow_growth(n));
        ASSERT_EQ(verdict.decision, Decision::Valid) << n;
        EXPECT_THAT(verdict.theorems, ElementsAre("3.7"));
        EXPECT_EQ(verdict.period, n);
        std::vector<Integer> polynomial(n + 1);
        polynomial.front() = -2;
        polynomial.back() = 1;
        EXPECT_EQ(verdict.field->minimal_polynomial(), polynomial);
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_EQ(*verdict.lengths[i].exact, pow(verdict.field->generator(), static_cast<int>(n - 1 - i)));
    }
}

TEST(Validity, NamesEveryReasonInReadingOrder) {
    const Verdict verdict = validate(make_grammar(
        {{"A", "A A A B C D"}, {"B", "B B"}, {"C", "C C C"}, {"D", "D"}, {"E", "E E E E C"}, {"F", "E F F F F"}}));
    EXPECT_THAT(messages(verdict),
                ElementsAre("class {B} (ratio 2) produces only itself but the system's ratio is 4, that of class {E}",
                            "class {C} (ratio 3) produces only itself but the system's ratio is 4, that of class {E}",
                            "class {D} never splits (its own ratio is 1) but the system's ratio is 4",
                            "class {F} (ratio 4) also produces class {E} of the same ratio: no finite length fits"));
    EXPECT_THAT(codes(verdict), ElementsAre(ReasonCode::FinalTooSmall, ReasonCode::FinalTooSmall,
                                            ReasonCode::NeverSplits, ReasonCode::BasicNotFinal));
}

TEST(Validity, RefusesTwoFinalClassesOfDifferentRatio) {
    const Verdict verdict = validate(make_grammar({{"A", "B C"}, {"B", "B B"}, {"C", "C C C"}}));
    EXPECT_THAT(codes(verdict), ElementsAre(ReasonCode::FinalDisagree));
    EXPECT_THAT(messages(verdict),
                ElementsAre("classes {B} (ratio 2) and {C} (ratio 3) are both final and cannot share one ratio"));
    EXPECT_THAT(verdict.reasons.front().symbols, ElementsAre(Symbol{1}, Symbol{2}));
}

TEST(Validity, RefusesABasicClassThatProducesAnotherOne) {
    const Verdict verdict = validate(make_grammar({{"A", "A A B"}, {"B", "B B"}}));
    EXPECT_THAT(messages(verdict),
                ElementsAre("class {A} (ratio 2) also produces class {B} of the same ratio: no finite length fits"));
    const Verdict far = validate(make_grammar({{"A", "A A M"}, {"M", "B"}, {"B", "B B"}}));
    EXPECT_THAT(codes(far), ElementsAre(ReasonCode::BasicNotFinal)) << "with a symbol between the two";
}

TEST(Validity, LeavesOutWhatTheAxiomCannotProduce) {
    const IntervalGrammar grammar = make_grammar({{"L", "S L"}, {"S", "L"}, {"X", "X L"}});
    EXPECT_EQ(validate(grammar).decision, Decision::Valid) << "X is not basic";
    const IntervalGrammar stuck = make_grammar({{"L", "S L"}, {"S", "L"}, {"X", "X"}});
    EXPECT_EQ(validate(stuck).decision, Decision::Invalid);
    const Verdict verdict = validate(with_axiom(stuck, "0 0 L S 0 0"));
    ASSERT_EQ(verdict.decision, Decision::Valid);
    EXPECT_THAT(verdict.occurs, ElementsAre(true, true, false));
    EXPECT_THAT(verdict.theorems, ElementsAre("3.7", "3.8"));
    EXPECT_THAT(verdict.classes, SizeIs(1));
    EXPECT_EQ(*verdict.lengths[2].exact, Number(0));
    EXPECT_EQ(*verdict.frequencies[2].exact, Number(0));
    EXPECT_FALSE(verdict.system->occurs(Symbol{2}));
    EXPECT_EQ(validate(with_axiom(stuck, "0 0")).decision, Decision::Invalid) << "nothing occurs";
}

TEST(Validity, ShareOfAFinalClassComesFromTheAxiom) {
    // P turns into one B and two C before everything doubles: 1 : 2, plus the B of the axiom.
    const IntervalGrammar grammar = make_grammar({{"P", "B C C"}, {"B", "B B"}, {"C", "C C"}});
    EXPECT_THAT(validate(grammar).frequencies, IsEmpty());
    const Verdict alone = validate(with_axiom(grammar, "P"));
    EXPECT_THAT(exact(alone.frequencies), ElementsAre(Number(0), Number(Rational(1, 3)), Number(Rational(2, 3))));
    const Verdict both = validate(with_axiom(grammar, "P B B 0"));
    // After s steps: B = 2^(s-1) + 2 2^s, C = 2 2^(s-1).
    EXPECT_THAT(exact(both.frequencies), ElementsAre(Number(0), Number(Rational(5, 7)), Number(Rational(2, 7))));
    EXPECT_EQ(both.free_lengths, 2U);
}

TEST(Validity, AnImprimitiveClassHasWeightedFrequencies) {
    const Verdict verdict = validate(make_grammar({{"A1", "A2 A2"}, {"A2", "A1"}}));
    ASSERT_EQ(verdict.decision, Decision::Valid);
    EXPECT_EQ(verdict.period, 2U);
    const Number root = verdict.field->generator();
    EXPECT_THAT(exact(verdict.frequencies), ElementsAre(root - 1, 2 - root));
    EXPECT_EQ(verdict.pisot, false) << "−√2 is a conjugate";
}

TEST(Validity, PeriodIsACommonMultiple) {
    const IntervalGrammar grammar =
        make_grammar({{"A", "B"}, {"B", "A A A A"}, {"C", "D"}, {"D", "E"}, {"E", "C C C C C C C C"}});
    const Verdict verdict = validate(grammar);
    ASSERT_EQ(verdict.decision, Decision::Valid) << "both ratios are 2";
    EXPECT_EQ(verdict.period, 6U);
    EXPECT_THAT(verdict.classes, SizeIs(2));
    EXPECT_EQ(verdict.classes[0].period, 2U);
    EXPECT_EQ(verdict.classes[1].period, 3U);
}

TEST(Validity, EqualRatiosOfDifferentBlocksAreEqualExactly) {
    // x² − x − 1 divides both characteristic polynomials.
    const Verdict verdict = validate(make_grammar({{"A", "A B"}, {"B", "A"}, {"P", "Q R"}, {"Q", "P Q"}, {"R", "P"}}));
    const Verdict other = validate(make_grammar({{"A", "A B"}, {"B", "A"}, {"P", "Q"}, {"Q", "P R"}, {"R", "P Q"}}));
    EXPECT_EQ(verdict.decision, Decision::Invalid);
    EXPECT_EQ(other.decision, Decision::Valid) << "x³ − 2x − 1 = (x + 1)(x² − x − 1)";
    EXPECT_EQ(other.free_lengths, 2U);
}

TEST(Validity, ADeclaredLengthScalesItsFinalClass) {
    const Verdict verdict = validate(with_length(fibonacci_grammar(), "L", Rational(3, 2)));
    ASSERT_EQ(verdict.decision, Decision::Valid);
    const Number& phi = verdict.field->generator();
    EXPECT_THAT(exact(verdict.lengths), ElementsAre(Number(Rational(3, 2)), Number(Rational(3, 2)) / phi));
    const IntervalGrammar two = make_grammar({{"B", "B B"}, {"C", "C C"}});
    EXPECT_THAT(exact(validate(with_length(two, "C", 5)).lengths), ElementsAre(Number(1), Number(5)));
}

TEST(Validity, RefusesDeclaredLengthsThatDisagree) {
    const Verdict verdict = validate(with_length(with_length(fibonacci_grammar(), "S", 1), "L", Rational(8, 5)));
    EXPECT_EQ(verdict.decision, Decision::Invalid);
    EXPECT_THAT(codes(verdict), ElementsAre(ReasonCode::LengthsDisagree));
    EXPECT_THAT(messages(verdict), ElementsAre("length L = 8/5 disagrees: with the lengths before it, L has length "
                                               "φ ≈ 1.618033989 (residual -0.018)"));
    EXPECT_FALSE(verdict.system);
    EXPECT_THAT(verdict.theorems, IsEmpty());
    EXPECT_EQ(validate(with_length(with_length(fibonacci_grammar(), "S", 1), "S", 1)).decision, Decision::Valid);
    EXPECT_EQ(validate(with_length(with_length(fibonacci_grammar(), "S", 1), "S", 2)).decision, Decision::Invalid);
}

TEST(Validity, ALengthThatCombinesFinalClassesFixesTheLastScale) {
    // ρ = 2: a_P = (a_B + a_C) / 2.
    const IntervalGrammar grammar = make_grammar({{"P", "B C"}, {"B", "B B"}, {"C", "C C"}});
    EXPECT_THAT(exact(validate(grammar).lengths), ElementsAre(Number(1), Number(1), Number(1)));
    const IntervalGrammar given = with_length(grammar, "P", 3);
    EXPECT_THAT(exact(validate(with_length(given, "B", 1)).lengths), ElementsAre(Number(3), Number(1), Number(5)));
    EXPECT_THAT(codes(validate(given)), ElementsAre(ReasonCode::LengthsDisagree)) << "neither B nor C is given";
    EXPECT_THAT(codes(validate(with_length(given, "B", 6))), ElementsAre(ReasonCode::LengthsDisagree))
        << "nothing is left for C";
    EXPECT_EQ(validate(with_length(with_length(given, "B", 4), "C", 2)).decision, Decision::Valid);
    EXPECT_EQ(validate(with_length(with_length(given, "B", 4), "C", 3)).decision, Decision::Invalid);
}

TEST(Validity, BoundsDecideWhereTheySeparate) {
    const ValidityLimits bounds{0, 32};
    const Verdict whole = validate(fibonacci_grammar(), bounds);
    EXPECT_EQ(whole.decision, Decision::Valid) << "one class needs no number at all";
    EXPECT_FALSE(whole.exact);
    EXPECT_FALSE(whole.system);
    ASSERT_THAT(whole.lengths, SizeIs(2));
    EXPECT_NEAR(whole.lengths[0].value, 1.618033988749895, 1e-12);
    EXPECT_LT(whole.lengths[0].bounds.lower, whole.lengths[0].bounds.upper);
    EXPECT_NEAR(whole.frequencies[0].value, 0.6180339887498949, 1e-12);
    EXPECT_EQ(validate(make_grammar({{"L", "S L"}, {"S", "L X"}, {"X", "X X X"}}), bounds).decision, Decision::Valid);
    EXPECT_EQ(validate(make_grammar({{"L", "S L X"}, {"S", "L"}, {"X", "X"}}), bounds).decision, Decision::Invalid);
}

TEST(Validity, OverlappingBoundsAreUndecided) {
    const IntervalGrammar equal = make_grammar({{"A", "A B"}, {"B", "A"}, {"P", "Q"}, {"Q", "P R"}, {"R", "P Q"}});
    const Verdict verdict = validate(equal, {0, 32});
    EXPECT_EQ(verdict.decision, Decision::Undecided);
    EXPECT_THAT(codes(verdict), ElementsAre(ReasonCode::Overlap));
    EXPECT_THAT(verdict.reasons.front().symbols, SizeIs(5));
    EXPECT_THAT(verdict.reasons.front().message, ::testing::HasSubstr("could not be told apart"));
    EXPECT_FALSE(verdict.classes[0].basic.has_value());
    EXPECT_THAT(verdict.lengths, IsEmpty());
    // A field too large to compute in is still good to compare ratios with.
    const Verdict compared = validate(equal, {200, 1});
    EXPECT_EQ(compared.decision, Decision::Valid);
    EXPECT_FALSE(compared.exact);
}

TEST(Validity, DeclaredLengthsAreCheckedAgainstBoundsToo) {
    const ValidityLimits bounds{0, 32};
    const IntervalGrammar given = with_length(fibonacci_grammar(), "S", 2);
    EXPECT_EQ(validate(given, bounds).lengths[1].exact, Number(2));
    EXPECT_NEAR(validate(given, bounds).lengths[0].value, 3.23606797749979, 1e-12);
    EXPECT_EQ(validate(with_length(given, "L", 3), bounds).decision, Decision::Invalid);
    // Lengths (2, 1): bounds cannot refute them, and confirm them only if they shrink to points.
    const IntervalGrammar rational = make_grammar({{"X", "X Y Y"}, {"Y", "X"}});
    const IntervalGrammar right = with_length(with_length(rational, "X", 2), "Y", 1);
    EXPECT_EQ(validate(right).decision, Decision::Valid);
    EXPECT_NE(validate(right, bounds).decision, Decision::Invalid);
}

TEST(Validity, NamesOfReasonsAreStable) {
    EXPECT_EQ(to_string(ReasonCode::NeverSplits), "never-splits");
    EXPECT_EQ(to_string(ReasonCode::FinalTooSmall), "final-too-small");
    EXPECT_EQ(to_string(ReasonCode::FinalDisagree), "final-disagree");
    EXPECT_EQ(to_string(ReasonCode::BasicNotFinal), "basic-not-final");
    EXPECT_EQ(to_string(ReasonCode::RatioOne), "ratio-one");
    EXPECT_EQ(to_string(ReasonCode::LengthsDisagree), "lengths-disagree");
    EXPECT_EQ(to_string(ReasonCode::Overlap), "overlap");
}

TEST(Validity, IsExactForSixtyFourSymbolsAndDegree32) {
    // A_1 -> A_64^4, A_i -> A_(i-1): ρ^64 = 4, so ρ^32 = 2 and a_i = ρ^(64-i).
    constexpr std::size_t n = 64;
    IntervalGrammar grammar = slow_growth(n);
    std::vector<Word> images = grammar.rules.images();
    images.front().assign(4, to_symbol(n - 1));
    grammar.rules = Morphism(std::move(images));
    const Verdict verdict = validate(grammar);
    ASSERT_TRUE(verdict.system);
    std::vector<Integer> polynomial(33);
    polynomial.front() = -2;
    polynomial.back() = 1;
    EXPECT_EQ(verdict.field->minimal_polynomial(), polynomial);
    for (std::size_t i = 0; i < n; ++i)
        EXPECT_EQ(*verdict.lengths[i].exact, pow(verdict.field->generator(), static_cast<int>(n - 1 - i)));
}

TEST(Validity, BeyondDegree32ThereAreBoundsOnly) {
    const Verdict verdict = validate(slow_growth(33));
    EXPECT_EQ(verdict.decision, Decision::Valid);
    EXPECT_FALSE(verdict.exact);
    EXPECT_FALSE(verdict.system);
    EXPECT_LE(verdict.ratio.bounds.lower, verdict.ratio.bounds.upper);
    EXPECT_NEAR(verdict.ratio.value, std::pow(2, 1.0 / 33), 1e-12);
    EXPECT_TRUE(validate(slow_growth(32)).system);
}

TEST(Validity, TenThousandSymbolsAreNoTrouble) {
    IntervalGrammar chain;
    std::vector<Word> images;
    constexpr std::size_t n = 10'000;
    for (std::size_t i = 0; i < n; ++i) {
        chain.alphabet.add(std::string("A").append(std::to_string(i)));
        images.push_back(i + 1 < n ? Word{to_symbol(i + 1), to_symbol(n - 1)} : Word{to_symbol(i), to_symbol(i)});
    }
    chain.rules = Morphism(std::move(images));
    const Verdict verdict = validate(chain);
    ASSERT_EQ(verdict.decision, Decision::Valid);
    EXPECT_THAT(verdict.classes, SizeIs(n));
    EXPECT_EQ(*verdict.lengths.front().exact, Number(1)) << "a_i = (a_(i+1) + a_n) / 2";
    EXPECT_EQ(validate(slow_growth(n)).decision, Decision::Valid) << "one class: a ratio near 1 needs no number";
}

// A starts the cycle A, B, A, …: C comes in the steps 0, 2, 4, … and has 1/2 + 1/8 + … = 2/3 of all intervals in the
// end.
TEST(Validity, FrequenciesOfSeveralFinalClassesCountWhatArrivesFromAnyClass) {
    IntervalGrammar grammar = with_axiom(make_grammar({{"A", "B C"}, {"B", "A D"}, {"C", "C C"}, {"D", "D D"}}), "A");
    grammar = with_length(with_length(std::move(grammar), "C", 1), "D", 1);
    const Verdict verdict = validate(grammar);
    EXPECT_THAT(exact(verdict.frequencies),
                ElementsAre(Number(0), Number(0), Number(Rational(2, 3)), Number(Rational(1, 3))));
}

} // namespace
} // namespace internode
