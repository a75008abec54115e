// SPDX-License-Identifier: MIT

#include "internode/curve/knots.h"

#include "internode/curve/curve.h"
#include "internode/curve/refinement.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/words.h"

#include <gmock/gmock.h>
#include <limits>
#include <stdexcept>

namespace internode {
namespace {

using namespace tests::letters;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tests::fibonacci;

std::vector<std::string> problems(int degree, Ends ends, Word word) {
    const CheckedKnots checked = make_knots(fibonacci(), {degree, ends, std::move(word)});
    EXPECT_EQ(checked.knots.has_value(), checked.problems.empty());
    return checked.problems;
}

Knots knots_of(int degree, Ends ends, Word word) {
    return make_knots(fibonacci(), {degree, ends, std::move(word)}).knots.value();
}

TEST(Knots, HaveAControlPointPerLetterLessTheDegreeWhenOpen) {
    const Knots open = knots_of(2, Ends::Open, {a, b, a, a, b, b});
    EXPECT_EQ(open.size(), 4u);
    EXPECT_THAT(open.domain(), ElementsAre(a, a));
    EXPECT_EQ(open.degree(), 2);
    EXPECT_EQ(open.step(), 0);
    const Knots closed = knots_of(2, Ends::Circular, {a, b, a});
    EXPECT_EQ(closed.size(), 3u);
    EXPECT_THAT(closed.domain(), ElementsAre(a, b, a));
}

TEST(Knots, RefuseWordsWithoutADomain) {
    EXPECT_THAT(problems(2, Ends::Open, {a, a, a, a, a}), IsEmpty());
    EXPECT_THAT(problems(2, Ends::Open, {a, a, a, a}),
                ElementsAre("an open curve of degree 2 needs a word of at least 5 letters, not 4"));
    EXPECT_THAT(problems(3, Ends::Circular, {}),
                ElementsAre("a closed curve of degree 3 needs a word of at least 1 letter, not 0"));
}

TEST(Knots, RefuseDegreesZerosAndLettersAsCurvesDo) {
    for (const int degree : {std::numeric_limits<int>::min(), 0, 13})
        EXPECT_THAT(problems(degree, Ends::Circular, {a}),
                    ElementsAre("the degree must be between 1 and 12, not " + std::to_string(degree)));
    EXPECT_THAT(problems(2, Ends::Circular, {a, to_symbol(2)}), ElementsAre(HasSubstr("letter 2 of the word")));
    EXPECT_THAT(problems(2, Ends::Open, {a, a, o, a, a}), ElementsAre(HasSubstr("the domain must begin")));
    EXPECT_THAT(problems(1, Ends::Circular, {a, o, o}), ElementsAre(HasSubstr("2 zeros in a row from letter 2")));
}

TEST(Knots, AreRefinedAsTheirCurveIs) {
    for (const Word& word : {Word{o, o, a, b, a, o, o}, Word{a, b, a, a, b, b}}) {
        Refinement refinement(
            make_curve(fibonacci(), {2, Ends::Open, word, 1, std::vector<double>(word.size() - 2)}).curve.value());
        const Knots coarse = refinement.curve().knots();
        for (int step = 0; step < 5; ++step) {
            const Knots fine = refined_knots(coarse, step);
            EXPECT_EQ(fine.word(), refinement.curve().word());
            EXPECT_EQ(fine.step(), step);
            EXPECT_EQ(fine.size(), refinement.curve().size());
            EXPECT_EQ(refined_size(coarse, 1, static_cast<std::uint64_t>(step), 1000).points, fine.size());
            EXPECT_EQ(refined_word(fine), refined_knots(coarse, step + 1).word());
            refinement.step();
        }
    }
    EXPECT_THROW((void)refined_knots(knots_of(2, Ends::Circular, {a}), -1), std::invalid_argument);
}

TEST(Knots, MakeCurvesAtAnyStep) {
    const Knots fine = refined_knots(knots_of(2, Ends::Circular, {a, b}), 3);
    const CheckedCurve checked = make_curve(fine, 1, std::vector<double>(fine.size(), 0.5));
    ASSERT_TRUE(checked.curve.has_value());
    EXPECT_EQ(checked.curve->step(), 3);
    EXPECT_EQ(checked.curve->word(), fine.word());
    EXPECT_THAT(make_curve(fine, 1, {0.5}).problems,
                ElementsAre("a closed curve of degree 2 with 1 point needs a word of 1 letter, not 8"));
    EXPECT_THAT(make_curve(fine, 0, {}).problems, ElementsAre("a point needs at least one coordinate"));
    EXPECT_THAT(make_curve(fine, 3, {0, 1}).problems, ElementsAre(HasSubstr("do not make whole points")));
    EXPECT_THAT(make_curve(fine, 1, std::vector<double>(8, std::numeric_limits<double>::infinity())).problems,
                testing::Contains(HasSubstr("must be a finite number")));
}

TEST(Clamped, PutsDegreeZerosAtEachEnd) {
    EXPECT_THAT(clamped(Word{a, b}, 2), ElementsAre(o, o, a, b, o, o));
    EXPECT_THROW((void)clamped(Word{a}, -1), std::invalid_argument);
}

TEST(Repeated, CutsTheWordRepeatedForEver) {
    EXPECT_THAT(repeated(Word{a, b}, 5), ElementsAre(a, b, a, b, a));
    EXPECT_THAT(repeated(Word{a, b}, 1), ElementsAre(a));
    EXPECT_THAT(repeated(Word{a}, 0), IsEmpty());
    EXPECT_THROW((void)repeated(Word{}, 3), std::invalid_argument);
}

} // namespace
} // namespace internode
