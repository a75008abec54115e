// SPDX-License-Identifier: MIT
//
// Knots -> word -> curve is the curve that de Boor's recursion finds on the knots themselves; and every refusal.

#include "internode/curve/knot_vector.h"

#include "internode/algebra/fraction.h"
#include "internode/curve/refinement.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/stride.h"
#include "tests/fixtures/words.h"
#include "tests/reference/de_boor.h"

#include <cmath>
#include <gmock/gmock.h>

namespace internode {
namespace {

using namespace tests::letters;
using reference::DeBoorCurve;
using reference::Real;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using tests::Random;
using tests::system_with;

const int rounds = tests::times(40, 2);

std::vector<Number> exact(const std::vector<std::string>& texts) {
    std::vector<Number> numbers;
    for (const std::string& text : texts) numbers.emplace_back(parse_rational(text).value());
    return numbers;
}

KnotVector open(int degree, std::size_t points, const std::vector<std::string>& knots) {
    return {.degree = degree, .ends = Ends::Open, .points = points, .knots = exact(knots)};
}

KnotVector closed(int degree, std::size_t points, const std::vector<std::string>& knots) {
    return {.degree = degree, .ends = Ends::Circular, .points = points, .knots = exact(knots)};
}

IntervalSystem halving() {
    return system_with({"AA"});
}

KnotWord fitted(const IntervalSystem& system, const KnotVector& knots) {
    FittedKnots result = fit_knots(system, knots);
    if (!result.fitted) throw std::logic_error("the knots do not fit: " + result.problems.front());
    return *result.fitted;
}

void expect_refused(const IntervalSystem& system, const KnotVector& knots, const std::string& words) {
    const FittedKnots result = fit_knots(system, knots);
    EXPECT_FALSE(result.fitted) << words;
    ASSERT_FALSE(result.problems.empty()) << words;
    EXPECT_THAT(result.problems.front(), HasSubstr(words));
}

TEST(KnotVector, OneSymbolPerDistinctLengthInOrderOfAppearance) {
    const KnotWord word = fitted(halving(), open(2, 6, {"0", "0", "0", "1", "1.5", "2", "3", "3", "3"}));
    EXPECT_THAT(word.word, ElementsAre(o, o, a, b, b, a, o, o));
    EXPECT_THAT(word.system.alphabet().names(), ElementsAre("A1", "A2"));
    EXPECT_EQ(word.system.lengths()[1], Number(Rational(1, 2)));
    EXPECT_EQ(word.system.ratio(), Number(2));
}

TEST(KnotVector, ASingleLengthKeepsTheNameOfTheGrammar) {
    const KnotWord word = fitted(system_with({"AAA"}), closed(3, 2, {"0", "3/2", "3"}));
    EXPECT_THAT(word.word, ElementsAre(a, a));
    EXPECT_THAT(word.system.alphabet().names(), ElementsAre("A"));
    EXPECT_EQ(word.system.length(a), Number(Rational(3, 2)));
    EXPECT_EQ(word.system.ratio(), Number(3));
}

TEST(KnotVector, LengthsAreCalledEqualOnlyIfTheyAre) {
    // As doubles 0.1 + 0.2 and 0.3 differ; as decimals they are the same; and 1e-30 is a length like any other.
    EXPECT_THAT(fitted(halving(), closed(1, 3, {"0", "0.1", "0.2", "0.3"})).word, ElementsAre(a, a, a));
    EXPECT_THAT(fitted(halving(), closed(1, 2, {"1", "2", "3.000000000000000000000000000001"})).word,
                ElementsAre(a, b));
}

TEST(KnotVector, WithoutTheOuterTwoKnotsTheWordHasZerosThere) {
    EXPECT_THAT(fitted(halving(), open(2, 4, {"0", "0", "1", "3", "3"})).word, ElementsAre(o, o, a, b, o, o));
    EXPECT_THAT(fitted(halving(), open(2, 3, {"0", "1", "2", "4"})).word, ElementsAre(o, a, a, b, o));
    EXPECT_THAT(fitted(halving(), open(1, 2, {"0", "1"})).word, ElementsAre(o, a, o));
}

TEST(KnotVector, ASymbolPerLengthIsASystemThatValidateKnows) {
    const KnotWord word = fitted(system_with({"AAA"}), open(1, 4, {"0", "0", "1", "1.25", "7", "7"}));
    const Verdict verdict = validate(word.system.grammar());
    ASSERT_TRUE(verdict.system);
    EXPECT_EQ(verdict.free_lengths, 3U);
    EXPECT_EQ(verdict.system->ratio(), word.system.ratio());
    EXPECT_EQ(verdict.system->lengths(), word.system.lengths());
    EXPECT_EQ(verdict.system->period(), word.system.period());
}

TEST(KnotVector, AGrammarFitsAtOneScale) {
    // A -> AB, B -> BBB has ratio 3 and lengths 1 and 2.
    const KnotWord word = fitted(system_with({"AB", "BBB"}), closed(2, 3, {"0", "1.5", "4.5", "6"}));
    EXPECT_THAT(word.word, ElementsAre(a, b, a));
    EXPECT_EQ(word.system.length(a), Number(Rational(3, 2)));
    EXPECT_EQ(word.system.length(b), Number(3));
}

TEST(KnotVector, AGrammarFitsInItsField) {
    const IntervalSystem fibonacci = tests::fibonacci();
    const Number phi = fibonacci.ratio();
    const Number scale(Rational(2, 7));
    KnotVector knots;
    knots.degree = 2;
    knots.ends = Ends::Circular;
    knots.points = 3;
    for (const Number& knot : {Number(5), Number(5) + scale * phi, Number(5) + scale * (phi + Number(1)),
                               Number(5) + scale * (phi + phi + Number(1))})
        knots.knots.push_back(knot);
    const KnotWord word = fitted(fibonacci, knots);
    EXPECT_THAT(word.word, ElementsAre(a, b, a));
    EXPECT_EQ(word.system.length(b), scale);
}

TEST(KnotVector, LengthsThatAreSaidSettleTheScale) {
    const IntervalSystem fibonacci = tests::fibonacci();
    KnotVector knots = closed(2, 2, {"0", "1", "2"});
    expect_refused(fibonacci, knots, "2 scales");
    knots.fixed = {b}; // S = 1, as the system has it
    EXPECT_THAT(fitted(fibonacci, knots).word, ElementsAre(b, b));
    knots.knots = exact({"0", "2", "4"});
    expect_refused(fibonacci, knots, "is 2: no symbol has that length");
}

TEST(KnotVector, FreeLengthsAndEqualLengthsAreAmbiguous) {
    const KnotVector knots = closed(2, 2, {"0", "1", "3"});
    expect_refused(system_with({"AA", "BB"}), knots, "free of each other");
    KnotVector half_said = knots;
    half_said.fixed = {a}; // A = 1: then B = 2
    EXPECT_THAT(fitted(system_with({"AA", "BB"}), half_said).word, ElementsAre(a, b));
    expect_refused(system_with({"AB", "BA"}), closed(2, 2, {"0", "1", "2"}), "both A and B");
}

TEST(KnotVector, IntervalsThatNoScaleFitsAreNamed) {
    expect_refused(system_with({"AB", "BBB"}), closed(2, 2, {"0", "1", "4"}), "1, 3 are not lengths of the grammar");
    expect_refused(tests::fibonacci(), closed(2, 2, {"0", "1", "2.618"}), "1, 809/500 are not lengths");
}

TEST(KnotVector, ARefusalListsTheLengthsOfEightSymbolsAtMost) {
    const KnotVector knots = closed(2, 2, {"0", "1", "3"});
    std::string listed = "at any scale: A = 1";
    for (const char next : std::string("BCDEFGH")) listed += std::string(", ") + next + " = 1";
    const auto refusal = [&knots](const std::vector<std::string>& rules) {
        return fit_knots(system_with(rules), knots).problems.at(0);
    };
    EXPECT_THAT(refusal({"AB", "BC", "CD", "DE", "EF", "FG", "GH", "HA"}), EndsWith(listed));
    EXPECT_THAT(refusal({"AB", "BC", "CD", "DE", "EF", "FG", "GH", "HI", "IA"}), EndsWith(listed + ", …"));
}

TEST(KnotVector, RefusesAnotherNumberOfKnots) {
    expect_refused(halving(), open(2, 4, {"0", "0", "0", "1", "2", "2"}), "needs 7 knots, or 5 without");
    expect_refused(halving(), open(2, 2, {"0", "0", "1", "1", "1"}), "at least 3 points, not 2");
    expect_refused(halving(), closed(2, 4, {"0", "1", "2", "3"}), "4 points needs 5 knots");
    expect_refused(halving(), open(2, 3, {}), "not 0");
}

TEST(KnotVector, RefusesKnotsThatDecrease) {
    expect_refused(halving(), open(1, 3, {"0", "0", "2", "3/2", "3"}), "knot 4 is 3/2, less than knot 3, which is 2");
}

TEST(KnotVector, RefusesMultiplicitiesThatDoNotFit) {
    expect_refused(halving(), open(2, 5, {"0", "0", "0", "0", "1", "2", "2", "2"}),
                   "knot 0 (knots 1 to 4) has multiplicity 4: at most 3 end a curve of degree 2");
    expect_refused(halving(), open(2, 6, {"0", "0", "0", "1", "1", "1", "2", "2", "2"}),
                   "knot 1 (knots 4 to 6) has multiplicity 3: at most 2 fit inside a curve of degree 2");
    expect_refused(halving(), open(2, 5, {"0", "0", "0", "1", "2", "2"}), "at most 2 end");
    expect_refused(halving(), closed(2, 4, {"0", "0", "1", "2", "2"}), "multiplicity 3: at most 2 fit inside");
    expect_refused(halving(), open(2, 3, {"1", "1", "1", "1", "1", "1"}), "all knots are equal");
    EXPECT_TRUE(fit_knots(halving(), closed(2, 4, {"0", "0", "1", "2", "3"})).fitted);
}

TEST(KnotVector, RefusesADomainThatBeginsOrEndsWithNothing) {
    expect_refused(halving(), open(2, 5, {"-1", "0", "1", "1", "2", "3", "4", "5"}),
                   "the domain goes from knot 3 to knot 6, and its first interval is empty: knots 3 and 4 are both 1");
    expect_refused(halving(), open(2, 5, {"0", "1", "2", "3", "4", "4", "5", "6"}), "its last interval is empty");
}

TEST(KnotVector, RefusesADegreeOfZero) {
    EXPECT_THROW((void)fit_knots(halving(), open(0, 1, {"0", "1"})), std::invalid_argument);
}

/// Knots with repetitions, at the ends up to d + 1 times.
KnotVector random_knots(Random& random, int degree, bool is_closed) {
    const std::size_t d = static_cast<std::size_t>(degree);
    KnotVector knots;
    knots.degree = degree;
    knots.ends = is_closed ? Ends::Circular : Ends::Open;
    knots.points = d + 1 + random.below(8);
    const std::size_t count = is_closed ? knots.points + 1 : knots.points + (random.below(2) == 0 ? d + 1 : d - 1);
    const bool clamp = !is_closed && random.below(2) == 0;
    const std::size_t still = clamp ? (count == knots.points + d + 1 ? d : d - 1) : 0; // empty intervals at each end
    Rational knot = fraction(static_cast<long>(random.below(7)), 3);
    for (std::size_t i = 0; i < count; ++i) {
        knots.knots.emplace_back(knot);
        if (i < still || i + 1 + still >= count || random.below(4) == 0) continue;
        knot += fraction(static_cast<long>(1 + random.below(9)), static_cast<long>(1 + random.below(3)));
    }
    return knots;
}

/// The spline on the knots themselves, the domain shifted to 0; the outer knots repeated where they are left out, a
/// closed curve unrolled.
DeBoorCurve on_its_own_knots(const KnotVector& vector, const std::vector<double>& points) {
    const auto d = static_cast<std::size_t>(vector.degree);
    const std::size_t n = vector.points;
    DeBoorCurve curve;
    curve.degree = d;
    std::vector<Real> t;
    for (const Number& knot : vector.knots) t.push_back(static_cast<Real>(knot.to_double()));
    if (vector.ends == Ends::Open) {
        if (t.size() == n + d - 1) {
            t.insert(t.begin(), t.front());
            t.push_back(t.back());
        }
        for (const double point : points) curve.points.push_back({point});
    } else {
        // Point k - d of the closed curve has the support from t_{k-d}: knots of d periods lie before.
        const Real period = t.back() - t.front();
        std::vector<Real> unrolled;
        for (std::size_t k = 0; k < n + 2 * d + 1; ++k) {
            const std::size_t place = k + d * n - d;
            unrolled.push_back(t[place % n] + (static_cast<Real>(place / n) - static_cast<Real>(d)) * period);
        }
        for (std::size_t k = 0; k < n + d; ++k) curve.points.push_back({points[(k + d * n - d) % n]});
        t = unrolled;
    }
    const Real shift = t[d];
    for (const Real knot : t) curve.knots.push_back(knot - shift);
    return curve;
}

Real difference_of_first_coordinates(const DeBoorCurve& coarse, const DeBoorCurve& fine) {
    Real worst = std::max(std::abs(coarse.begin() - fine.begin()), std::abs(coarse.end() - fine.end()));
    for (std::size_t j = fine.degree; j < fine.points.size(); ++j) {
        const Real length = fine.knots[j + 1] - fine.knots[j];
        if (length <= 0) continue;
        for (const Real part : {Real(0.25L), Real(0.75L)}) {
            const Real x = fine.knots[j] + part * length;
            worst =
                std::max(worst, std::abs(reference::de_boor(coarse, x)[0] - reference::de_boor_piece(fine, j, x)[0]));
        }
    }
    return worst;
}

TEST(KnotVector, GivesTheCurveOfItsKnots) {
    Random random(20);
    int accepted = 0;
    for (int time = 0; time < rounds; ++time)
        for (int degree = 1; degree <= 6; ++degree)
            for (const bool is_closed : {false, true}) {
                const KnotVector knots = random_knots(random, degree, is_closed);
                const FittedKnots word = fit_knots(halving(), knots);
                if (!word.fitted) continue;
                ++accepted;
                CurveData data{degree, knots.ends, word.fitted->word, 1, {}};
                for (std::size_t k = 0; k < knots.points; ++k) data.points.push_back(random.coordinate());
                const Curve curve = tests::curve_of(word.fitted->system, data);
                const DeBoorCurve truth = on_its_own_knots(knots, data.points);
                EXPECT_LE(difference_of_first_coordinates(truth, reference::de_boor_curve(curve)), 1e-12);
                EXPECT_LE(difference_of_first_coordinates(truth, reference::de_boor_curve(refine(curve, 2))), 1e-12)
                    << degree << is_closed;
            }
    EXPECT_GE(accepted, rounds * 4);
}

} // namespace
} // namespace internode
