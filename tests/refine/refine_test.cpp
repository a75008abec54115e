// SPDX-License-Identifier: MIT
//
// The short way against the long one, and each of its refusals.

#include "internode/refine.h"

#include "internode/curve/refinement.h"
#include "internode/grammar/bundled.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/interval/validity.h"
#include "internode/point/interpreter.h"
#include "internode/point/start_word.h"
#include "internode/point/strands.h"
#include "internode/text/limits.h"

#include <gmock/gmock.h>

#include <array>
#include <stdexcept>

namespace internode {
namespace {

using testing::HasSubstr;
using Points = std::vector<std::array<double, 2>>;

const Points pentagon{{0, 0}, {4, 0}, {4, 3}, {2, 5}, {0, 3}};
constexpr const char* fibonacci = "L -> S L, S -> L";

/// The refined points of a word given letter by letter, step by step through the library.
std::vector<double> the_long_way(const std::string& letters, int degree, Ends ends, int steps) {
    const IntervalSystem system = validate(*parse_grammar(fibonacci, "test").grammar).system.value();
    CurveData data{degree, ends, parse_word(letters, system.alphabet(), "test").axiom.word, 2, {}};
    for (const auto& [x, y] : pentagon) data.points.insert(data.points.end(), {x, y});
    Refinement refinement(make_curve(system, data).curve.value());
    for (int step = 0; step < steps; ++step) refinement.step();
    return refinement.curve().points();
}

void expect_the_long_way(const Points& points, const std::vector<double>& expected) {
    ASSERT_EQ(2 * points.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(points[i / 2][i % 2], expected[i], 1e-13);
}

/// What refine() says of these; empty when it refines.
std::string refusal(const std::string& grammar, const Points& points, const RefineOptions& options, int steps = 1) {
    try {
        (void)refine(grammar, points, options, steps);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Refine, IsTheLongWay) {
    expect_the_long_way(refine(fibonacci, pentagon, {.degree = 3, .ends = Ends::Circular, .word = "LSLLS"}, 3),
                        the_long_way("LSLLS", 3, Ends::Circular, 3));
    expect_the_long_way(refine(fibonacci, pentagon, {.degree = 2, .word = "LSL"}, 2),
                        the_long_way("0^2 LSL 0^2", 2, Ends::Open, 2));
    expect_the_long_way(refine(fibonacci, pentagon, {.degree = 2, .word = "LSLLSLS", .clamped = false}, 2),
                        the_long_way("LSLLSLS", 2, Ends::Open, 2));
}

TEST(Refine, RepeatsTheLettersUntilTheyFitThePoints) {
    expect_the_long_way(refine(fibonacci, pentagon, {.degree = 2, .ends = Ends::Circular, .word = "LS"}, 1),
                        the_long_way("LSLSL", 2, Ends::Circular, 1));
    expect_the_long_way(refine(fibonacci, pentagon, {.degree = 2, .word = "LS"}, 1),
                        the_long_way("0^2 LSL 0^2", 2, Ends::Open, 1));
}

TEST(Refine, NeedsNoWordWhereTheGrammarSaysIt) {
    EXPECT_EQ(refine("A -> A A", pentagon, {.ends = Ends::Circular}, 2).size(), 20U);
    expect_the_long_way(refine("L -> S L, S -> L\naxiom (LSLLS)", pentagon, {.degree = 2, .ends = Ends::Circular}, 1),
                        the_long_way("LSLLS", 2, Ends::Circular, 1));
}

TEST(Refine, TakesBundledGrammarsByName) {
    EXPECT_EQ(refine("@fibonacci", pentagon, {.ends = Ends::Circular, .word = "LSLLS"}, 3),
              refine(fibonacci, pentagon, {.ends = Ends::Circular, .word = "LSLLS"}, 3));
    EXPECT_THAT(refusal("@fibonaci", pentagon, {}), HasSubstr("no bundled grammar `@fibonaci`"));
}

TEST(Refine, OfNoStepsIsThePolygon) {
    EXPECT_EQ(refine(fibonacci, pentagon, {.ends = Ends::Circular, .word = "LSLLS"}, 0), pentagon);
}

TEST(Refine, RefusesAGrammarAsTheCommandDoes) {
    const std::string said = refusal("L -> S L\nS -> (", pentagon, {});
    EXPECT_THAT(said, HasSubstr("<grammar>:2:"));
    EXPECT_THAT(said, HasSubstr("^")) << "the caret";
    EXPECT_THAT(refusal("L -> L @", pentagon, {}), HasSubstr("<grammar>:1:"));
    EXPECT_THAT(refusal("A -> A A, B -> B", pentagon, {.word = "AB"}), HasSubstr("not a valid interval system\n  "));
}

TEST(Refine, RefusesAWordThatDoesNotFit) {
    EXPECT_THAT(refusal(fibonacci, pentagon, {}), HasSubstr("no word"));
    EXPECT_THAT(refusal(fibonacci, pentagon, {.word = "LX"}), HasSubstr("`X`"));
    EXPECT_THAT(refusal(fibonacci, pentagon, {.ends = Ends::Circular, .word = "LSLLSL"}),
                HasSubstr("6 letters, more than the 5 that 5 points need"));
    EXPECT_THAT(refusal(fibonacci, pentagon, {.word = "(LS)"}), HasSubstr("circular"));
    EXPECT_THAT(refusal("L -> S L, S -> L\naxiom (LSLLS)", pentagon, {}), HasSubstr("circular"));
    EXPECT_THAT(refusal(fibonacci, pentagon, {.degree = 5, .word = "L"}), HasSubstr("at least 6 points, not 5"));
    EXPECT_THAT(refusal("L -> S L, S -> L\naxiom L S L", pentagon, {.degree = 2}), HasSubstr("letters"));
}

TEST(Refine, RefusesDegreesStepsAndPointsThatAreNone) {
    EXPECT_THAT(refusal("A -> A A", pentagon, {.degree = 0}), HasSubstr("degree 0"));
    EXPECT_THAT(refusal("A -> A A", pentagon, {.degree = 13}), HasSubstr("degree 13"));
    EXPECT_THAT(refusal("A -> A A", pentagon, {}, -1), HasSubstr("-1 steps"));
    EXPECT_THAT(refusal("A -> A A", {}, {}), HasSubstr("not whole points"));
    const std::vector<double> three{0, 1, 2};
    EXPECT_THROW((void)refine("A -> A A", three, 2, {}, 1), std::invalid_argument);
    EXPECT_THROW((void)refine("A -> A A", three, 0, {}, 1), std::invalid_argument);
}

/// The points of a word derived and interpreted module by module.
std::vector<double> interpreted(const std::string& name, const Points& points, int cycles) {
    const ParsedPointGrammar parsed = parse_point_grammar(find_bundled_grammar(name)->text, name);
    const PointSystem system = make_point_system(parsed.grammar.value(), {.start = PointStart::Input}).system.value();
    std::vector<double> rows;
    for (const auto& [x, y] : points) rows.insert(rows.end(), {x, y});
    const Derivation derived = derive(system, input_word(system, rows), static_cast<std::uint64_t>(cycles));
    const ModuleWord last = interpret(system, derived.word).word;
    return strands(last, system, system.grammar().interpretations.size()).points;
}

TEST(Refine, OfAPointGrammarIsItsInterpretation) {
    for (const char* const name : {"s0/13", "four-point", "corner-cutting", "koch", "midpoint-displacement"})
        for (const int steps : {0, 1, 3}) {
            SCOPED_TRACE(name);
            expect_the_long_way(refine("@" + std::string(name), pentagon, {}, steps),
                                interpreted(name, pentagon, steps));
        }
    EXPECT_EQ(refine("@s0/13", pentagon, {}, 3).size(), 40U);
    EXPECT_EQ(refine("points\nring\nP(u) < P(v) -> P((u + v)/2) P(v)", pentagon, {}, 1).front(),
              (std::array<double, 2>{0, 1.5}));
}

TEST(Refine, OfAPointGrammarIsInterpretedInTheDimensionOfThePoints) {
    const std::string begin = "points\nring\nP(v) -> P(v)\ninterpretation\nP(v) -> P'";
    EXPECT_EQ(refine(begin + "((v.x, 2 v.y))", pentagon, {}, 1)[3], (std::array<double, 2>{2, 10}));
    for (const std::string& letter : {begin, begin.substr(0, begin.size() - 1)})
        EXPECT_THAT(refusal(letter + "((v.x, v.y, 1))", pentagon, {}),
                    HasSubstr("the interpretation makes points of 3 coordinates of points of 2"));
}

TEST(Refine, OfAPointGrammarSaysWhatIsWrongAndWhere) {
    EXPECT_THAT(refusal("points\nring\nP(v) -> P(", pentagon, {}), HasSubstr("<grammar>:3:"));
    EXPECT_THAT(refusal("points\nP(v) -> P(v + 1)", pentagon, {}), HasSubstr("<grammar>:2:"));
    EXPECT_THAT(refusal("points\nP(v) -> P(v)", pentagon, {}, -1), HasSubstr("-1 steps"));
    EXPECT_THROW((void)refine("points\nP(v) -> P(v/v.x)", pentagon, {}, 1), std::range_error);
    EXPECT_THROW((void)refine("@s0/13", pentagon, {.max_points = 39}, 3), LimitExceeded);
    EXPECT_EQ(refine("@s0/13", pentagon, {.max_points = 40}, 3).size(), 40U);
    EXPECT_THROW((void)refine("@s0/13", pentagon, {.max_points = 40}, 1'000'000'000), LimitExceeded);
    EXPECT_THROW((void)curve_from("@s0/13", std::vector<double>{0, 1}, 2, {}), std::invalid_argument);
}

TEST(Refine, RefusesMorePointsThanAllowedBeforeItWorks) {
    EXPECT_THROW((void)refine("A -> A A", pentagon, {.ends = Ends::Circular, .max_points = 1000}, 1'000'000'000),
                 LimitExceeded);
    EXPECT_EQ(refine("A -> A A", pentagon, {.ends = Ends::Circular, .max_points = 20}, 2).size(), 20U);
    EXPECT_THROW((void)refine("A -> A A", pentagon, {.ends = Ends::Circular, .max_points = 19}, 2), LimitExceeded);
}

} // namespace
} // namespace internode
