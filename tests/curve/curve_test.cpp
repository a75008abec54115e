// SPDX-License-Identifier: MIT

#include "internode/curve/curve.h"

#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/words.h"

#include <gmock/gmock.h>
#include <limits>

namespace internode {
namespace {

using namespace tests::letters;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tests::fibonacci;

CurveData open_data(int degree, Word word) {
    CurveData data;
    data.degree = degree;
    const std::size_t points = word.size() - static_cast<std::size_t>(degree);
    data.word = std::move(word);
    data.points.assign(points * 2, 0.5);
    return data;
}

CurveData closed_data(int degree, Word word) {
    CurveData data;
    data.degree = degree;
    data.ends = Ends::Circular;
    data.points.assign(word.size() * 2, 0.5);
    data.word = std::move(word);
    return data;
}

std::vector<std::string> problems(const CurveData& data) {
    const CheckedCurve checked = make_curve(fibonacci(), data);
    EXPECT_EQ(checked.curve.has_value(), checked.problems.empty());
    return checked.problems;
}

TEST(Curve, KeepsWhatItIsGiven) {
    CurveData data = open_data(2, {a, b, a, a, b, a});
    data.points[3] = 7;
    const CheckedCurve checked = make_curve(fibonacci(), data);
    ASSERT_TRUE(checked.curve.has_value());
    EXPECT_EQ(checked.curve->degree(), 2);
    EXPECT_EQ(checked.curve->ends(), Ends::Open);
    EXPECT_EQ(checked.curve->word(), data.word);
    EXPECT_EQ(checked.curve->points(), data.points);
    EXPECT_EQ(checked.curve->size(), 4u);
    EXPECT_EQ(checked.curve->dimension(), 2u);
    EXPECT_EQ(checked.curve->step(), 0);
}

TEST(Curve, TheDomainOfAnOpenCurveLeavesOutDegreeLettersAtEachEnd) {
    const CheckedCurve checked = make_curve(fibonacci(), open_data(2, {a, b, a, a, b, b}));
    ASSERT_TRUE(checked.curve.has_value());
    EXPECT_THAT(checked.curve->domain(), ElementsAre(a, a));
}

TEST(Curve, TheDomainOfAClosedCurveIsItsWord) {
    const CheckedCurve checked = make_curve(fibonacci(), closed_data(3, {a, b}));
    ASSERT_TRUE(checked.curve.has_value());
    EXPECT_THAT(checked.curve->domain(), ElementsAre(a, b));
}

TEST(Curve, TakesASingleClosedPointAndTheLeastOpenPolygon) {
    EXPECT_THAT(problems(closed_data(5, {a})), IsEmpty());
    EXPECT_THAT(problems(open_data(3, {a, a, a, b, a, a, a})), IsEmpty());
}

TEST(Curve, TakesDegreesFrom1To12) {
    EXPECT_THAT(problems(closed_data(12, {a, b})), IsEmpty());
    for (const int degree : {-1, 0, 13}) {
        CurveData data = closed_data(1, {a, b});
        data.degree = degree;
        EXPECT_THAT(problems(data), ElementsAre("the degree must be between 1 and 12, not " + std::to_string(degree)));
    }
}

TEST(Curve, RefusesAWordOfAnotherSizeWithTheNumbers) {
    CurveData data = open_data(3, Word(12, a));
    data.points.assign(20, 0);
    EXPECT_THAT(problems(data),
                ElementsAre("an open curve of degree 3 with 10 points needs a word of 13 letters, not 12"));
    data.ends = Ends::Circular;
    EXPECT_THAT(problems(data),
                ElementsAre("a closed curve of degree 3 with 10 points needs a word of 10 letters, not 12"));
}

TEST(Curve, RefusesTooFewPoints) {
    EXPECT_THAT(problems(open_data(3, {a, a, a, b, a, a})),
                ElementsAre("an open curve of degree 3 needs at least 4 points, not 3"));
    EXPECT_THAT(problems(closed_data(3, {})), ElementsAre("a closed curve of degree 3 needs at least 1 point, not 0"));
}

TEST(Curve, RefusesBrokenRowsAndNoCoordinates) {
    CurveData data = closed_data(3, {a, b});
    data.points.pop_back();
    EXPECT_THAT(problems(data), ElementsAre("3 coordinates do not make whole points of 2 coordinates"));
    data.dimension = 0;
    EXPECT_THAT(problems(data), ElementsAre("a point needs at least one coordinate"));
}

TEST(Curve, NamesTheRowAndColumnOfACoordinateThatIsNotFinite) {
    CurveData data = closed_data(2, {a, b, a});
    data.points[3] = std::numeric_limits<double>::infinity();
    data.points[4] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(problems(data), ElementsAre("row 2, column 2 is inf: every coordinate must be a finite number",
                                            "row 3, column 1 is nan: every coordinate must be a finite number"));
}

TEST(Curve, CountsTheCoordinatesThatItDoesNotList) {
    CurveData data = closed_data(2, Word(20, a));
    data.points.assign(40, std::numeric_limits<double>::infinity());
    const std::vector<std::string> found = problems(data);
    ASSERT_EQ(found.size(), 6u);
    EXPECT_EQ(found.back(), "and 35 more coordinates are not finite");
}

TEST(Curve, RefusesALetterOfAnotherAlphabet) {
    EXPECT_THAT(problems(closed_data(2, {a, to_symbol(2)})),
                ElementsAre("letter 2 of the word is not in the grammar's alphabet"));
}

TEST(Curve, RefusesALetterThatTheAxiomNeverProduces) {
    IntervalGrammar grammar = tests::grammar_of(Morphism({{a, a}, {b, b}}));
    grammar.axiom = Axiom{{a, a}, Ends::Circular};
    const Verdict verdict = validate(grammar);
    ASSERT_TRUE(verdict.system.has_value());
    const CheckedCurve checked = make_curve(*verdict.system, closed_data(2, {a, b}));
    EXPECT_THAT(checked.problems, ElementsAre("`B` has no length: the grammar's axiom never produces it"));
}

TEST(Curve, RefusesLengthsThatDoublesCannotCarry) {
    IntervalGrammar grammar = tests::grammar_of(Morphism({{a, a}, {b, b}}));
    grammar.lengths = {{a, *parse_rational("1e-300")}, {b, *parse_rational("1")}};
    const Verdict verdict = validate(grammar);
    ASSERT_TRUE(verdict.system.has_value());
    const CheckedCurve checked = make_curve(*verdict.system, closed_data(2, {a, b}));
    EXPECT_THAT(checked.problems,
                ElementsAre("the length of `A` is 1e-300: a curve needs lengths between 1e-150 and 1e+150"));
    EXPECT_TRUE(make_curve(*verdict.system, closed_data(2, {b, b})).curve.has_value());
}

TEST(Curve, RefusesADomainWithoutLengthAtItsEnds) {
    EXPECT_THAT(problems(open_data(2, {a, a, o, a, a, a})),
                ElementsAre("the domain must begin with an interval that has a length, but letter 3 of the word, its "
                            "first, is `0`"));
    EXPECT_THAT(problems(open_data(2, {a, a, a, o, a, a})),
                ElementsAre("the domain must end with an interval that has a length, but letter 4 of the word, its "
                            "last, is `0`"));
    EXPECT_THAT(problems(open_data(2, {a, a, o, a, a})), testing::SizeIs(1));
}

TEST(Curve, RefusesAWordOfZeros) {
    EXPECT_THAT(problems(closed_data(3, {o, o, o})),
                ElementsAre("the word has no interval with a length: every letter is `0`"));
    EXPECT_THAT(problems(open_data(1, {o, o, o})), testing::SizeIs(1));
}

TEST(Curve, TakesRunsOfDegreeZerosAndRefusesMore) {
    EXPECT_THAT(problems(open_data(2, {a, a, a, o, o, a, a, a})), IsEmpty());
    EXPECT_THAT(problems(open_data(2, {o, o, a, o, a, o, o})), IsEmpty());
    EXPECT_THAT(problems(open_data(2, {a, a, a, o, o, o, a, a, a})),
                ElementsAre("3 zeros in a row from letter 4 of the word: at most 2 fit a curve of degree 2, and 2 "
                            "already break it"));
}

TEST(Curve, CountsRunsAcrossTheSeamOfAClosedWord) {
    EXPECT_THAT(problems(closed_data(2, {o, a, o})), IsEmpty());
    EXPECT_THAT(problems(closed_data(2, {o, a, b, o, o})), ElementsAre(HasSubstr("3 zeros in a row from letter 4")));
    EXPECT_THAT(problems(closed_data(2, {a, o, o, o})), ElementsAre(HasSubstr("3 zeros in a row from letter 2")));
}

TEST(Curve, ListsProblemsOfDifferentKindsTogether) {
    CurveData data = closed_data(1, {a, o, o});
    data.points[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(problems(data), testing::SizeIs(2));
}

} // namespace
} // namespace internode
