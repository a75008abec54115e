// SPDX-License-Identifier: MIT

#include "internode/point/point_system.h"

#include "tests/point/systems.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The parameters of a letter after so many passes; none for a letter of no word.
std::optional<std::vector<Extent>> parameters(const PointSystem& system, std::string_view letter,
                                              std::size_t passes = 0) {
    return system.layout(passes)[to_index(*system.grammar().letters.find(letter))];
}

TEST(PointSystem, PointsOfTheInputMakeAllElsePoints) {
    const PointSystem system =
        point_system("points\n P(v) > P(w) -> Q(v, 2) E\n Q(v, s) -> R(s v, s)\n", {.dimension = 3});
    EXPECT_EQ(parameters(system, "P"), (std::vector<Extent>{3}));
    EXPECT_EQ(parameters(system, "Q"), (std::vector<Extent>{3, 0}));
    EXPECT_EQ(parameters(system, "R"), (std::vector<Extent>{3, 0}));
    EXPECT_EQ(parameters(system, "E"), std::vector<Extent>());
}

TEST(PointSystem, LettersOfNoWordHaveNoKinds) {
    const PointSystem system = point_system("points\n axiom A(1)\n A(x) -> A(x)\n B(y) -> C(y + (1, 2))\n");
    EXPECT_EQ(parameters(system, "A"), (std::vector<Extent>{0}));
    EXPECT_EQ(parameters(system, "B"), std::nullopt);
    EXPECT_EQ(parameters(system, "C"), std::nullopt);
}

TEST(PointSystem, InterpretationPassesHaveTheirOwnKinds) {
    const PointSystem system = point_system("points\n input P(v) E\n interpretation\n P(v) -> P((v.x/v.z, v.y/v.z))\n"
                                            "interpretation\n P(u) < E > P(v) -> L(u, v)\n",
                                            {.dimension = 3});
    EXPECT_EQ(parameters(system, "P", 0), (std::vector<Extent>{3}));
    EXPECT_EQ(parameters(system, "P", 1), (std::vector<Extent>{2}));
    EXPECT_EQ(parameters(system, "L", 1), std::nullopt);
    EXPECT_EQ(parameters(system, "L", 2), (std::vector<Extent>{2, 2}));
    EXPECT_EQ(parameters(system, "E", 2), std::vector<Extent>());
}

TEST(PointSystem, AModuleThatMayStayKeepsItsKindInAPass) {
    EXPECT_THAT(
        problems_of("points\n interpretation\n P(v) : v.x > 0 -> P(v.x)\n"),
        ElementsAre("parameter 1 of `P` is a number here, but a point of 2 coordinates where no rule rewrites it "
                    "| a parameter is a number everywhere or a point of so many coordinates everywhere"));
}

TEST(PointSystem, RefusesOperandsThatDoNotFit) {
    const auto message = [](const std::string& expression) {
        const std::vector<std::string> all =
            problems_of("points\n input P(v, 1)\n P(v, s) -> P(" + expression + ", s)\n");
        return all.size() == 1 ? all.front().substr(0, all.front().find(" |")) : "none or several";
    };
    EXPECT_EQ(message("v + s"), "a point of 2 coordinates (`v`) and a number (`s`) cannot be added");
    EXPECT_EQ(message("v - 1"), "a number cannot be subtracted from a point of 2 coordinates (`v`)");
    EXPECT_EQ(message("v v"), "a point of 2 coordinates (`v`) times a point of 2 coordinates (`v`) has no meaning");
    EXPECT_EQ(message("v/v"), "a point of 2 coordinates (`v`) cannot be divided by a point of 2 coordinates (`v`)");
    EXPECT_EQ(message("v + (1, 2, 3)"), "a point of 2 coordinates (`v`) and a point of 3 coordinates cannot be added");
    EXPECT_EQ(message("(v, 1)"), "a point of 2 coordinates (`v`) as a coordinate of a point");
    EXPECT_EQ(message("s.x v"), "`.x` of a number (`s`)");
    EXPECT_EQ(message("v.z v"), "`.z` of a point of 2 coordinates (`v`)");
    EXPECT_EQ(message("min(v, v)"), "`min` of a point of 2 coordinates (`v`)");
    EXPECT_EQ(message("sqrt(v) v"), "`sqrt` of a point of 2 coordinates (`v`)");
}

TEST(PointSystem, ConditionsAreTruthsAboutNumbers) {
    EXPECT_THAT(problems_of("points\n P(v) > P(w) : v == w -> P(v)\n"),
                ElementsAre(HasSubstr("a point of 2 coordinates (`v`) and a point of 2 coordinates (`w`) cannot be "
                                      "compared | compare coordinates")));
    EXPECT_THAT(problems_of("points\n a: P(v) : v.x > 0 -> P(v) : v\n"),
                ElementsAre("the weight is a point of 2 coordinates, not a number"));
}

TEST(PointSystem, AParameterIsOneKindEverywhere) {
    EXPECT_THAT(
        problems_of("points\n input P(v)\n a: P(v) -> P(v.x)\n"),
        ElementsAre(HasSubstr("parameter 1 of `P` is a number here, but a point of 2 coordinates in the input")));
    EXPECT_THAT(problems_of("points\n axiom A(1) B((0, 0))\n a: A(x) -> C(x)\n b: B(v) -> C(v)\n"),
                ElementsAre(HasSubstr("but")));
    EXPECT_EQ(place_of_first_problem("points\n axiom A(1)\n A(x) -> A((x, x))\n"), "(x, x)");
}

TEST(PointSystem, PointsInOneWordMayDifferInDimensionButNotOneParameter) {
    EXPECT_THAT(problems_of("points\n axiom A((0, 0)) B((0, 0, 0))\n A(u) < B(v) -> A(u)\n"), IsEmpty());
    EXPECT_THAT(problems_of("points\n axiom A((0, 0)) A((0, 0, 0))\n A(u) -> A(u)\n"),
                ElementsAre(HasSubstr("is a point of 3 coordinates here, but a point of 2 coordinates in the axiom")));
}

TEST(PointSystem, ConstantsAreExactWhereTheyCanBe) {
    const PointSystem system = point_system("points\n t = 1/3\n f(s, u) = min(s, 1) + min(u, 1)\n a = f(t, 5)\n"
                                            "r = sqrt(9/4)\n d = sqrt(2)\n P(v) -> P(v)\n");
    EXPECT_EQ(system.constant(0).exact, Rational(1, 3));
    EXPECT_EQ(system.constant(2).exact, Rational(4, 3));
    EXPECT_EQ(nearest(system.constant(2)), 4.0 / 3);
    EXPECT_EQ(system.constant(3).exact, Rational(3, 2));
    EXPECT_FALSE(system.constant(4).exact);
}

TEST(PointSystem, ConstantsAreSetFromOutsideAndLaterOnesFollow) {
    const PointSettings settings{.constants = {{"t", Rational(1, 4)}}};
    const PointSystem system = point_system("points\n t = 1/3\n u = 2t\n P(v) -> P(u v)\n", settings);
    EXPECT_EQ(system.constant(1).exact, Rational(1, 2));
}

TEST(PointSystem, RefusesSettingsOfWhatIsNoConstant) {
    const std::string text = "points\n weight = 1\n f(s) = s\n P(v) -> P(weight v)\n";
    EXPECT_THAT(problems_of(text, {.constants = {{"wieght", 1}}}),
                ElementsAre("the grammar has no constant `wieght` | did you mean `weight`?"));
    EXPECT_THAT(problems_of(text, {.constants = {{"q", 1}}}),
                ElementsAre("the grammar has no constant `q` | its constants: weight"));
    EXPECT_THAT(problems_of(text, {.constants = {{"f", 1}}}),
                ElementsAre("`f` is a function: only constants can be set"));
    EXPECT_THAT(problems_of("points\n P(v) -> P(v)\n", {.constants = {{"q", 1}}}),
                ElementsAre("the grammar has no constant `q` | it has none"));
}

TEST(PointSystem, RefusesConstantsThatAreNotFinite) {
    EXPECT_THAT(problems_of("points\n t = 1\n a = 1/(t - 1)\n P(v) -> P(a v)\n"),
                ElementsAre("`a` is not a finite number"));
    EXPECT_THAT(problems_of("points\n a = sqrt(-1)\n P(v) -> P(a v)\n"), ElementsAre("`a` is not a finite number"));
}

/// Each function calls the one before it twice.
std::string doubling_functions(int count) {
    std::string text = "points\n f0(s) = s + 1\n";
    for (int i = 1; i <= count; ++i)
        text +=
            "f" + std::to_string(i) + "(s) = f" + std::to_string(i - 1) + "(s) + f" + std::to_string(i - 1) + "(s)\n";
    return text;
}

TEST(PointSystem, RefusesFunctionsThatExplode) {
    EXPECT_THAT(problems_of(doubling_functions(100) + "P(v) -> P(f100(1) v)\n"),
                testing::Contains(HasSubstr("takes more than 1000000 operations when the functions that are called are "
                                            "written out | a function that calls another twice doubles its work")));
    EXPECT_THAT(problems_of(doubling_functions(16) + "a = f16(1)\n P(v) -> P(a v)\n"),
                ElementsAre(HasSubstr("`a` takes more than 100000 operations")));
    EXPECT_THAT(problems_of(doubling_functions(13) + "a = f13(1)\n b = f13(2)\n P(v) -> P(a b v)\n"),
                ElementsAre(HasSubstr("`b` takes more than 100000 operations")))
        << "the work of all constants counts";
    EXPECT_THAT(problems_of(doubling_functions(12) + "a = f12(1)\n P(v) -> P(f12(a) v)\n"), IsEmpty());
}

TEST(PointSystem, ExpandsTheCycleOfTables) {
    const std::string text = "points\n n = 2\n common: A -> A\n table p\n A -> B\n table q\n B -> A\n axiom A\n"
                             "cycle p q^n p q^(n - 2)\n";
    const PointSystem system = point_system(text);
    using Table = std::optional<std::uint32_t>;
    EXPECT_THAT(system.cycle(), ElementsAre(Table(0), Table(1), Table(1), Table(0)));
    EXPECT_THAT(system.rules_of(0), ElementsAre(0, 1));
    EXPECT_THAT(system.rules_of(1), ElementsAre(0, 2));
    EXPECT_THAT(point_system("points\n A -> A\n axiom A\n").cycle(), ElementsAre(Table()));
}

TEST(PointSystem, RefusesCountsThatAreNoCounts) {
    const std::string text = "points\n n = 1\n axiom A\n table p\n A -> A A\n cycle p p^n\n";
    EXPECT_THAT(problems_of(text, {.constants = {{"n", -1}}}),
                ElementsAre("a table is applied -1 times | the count is a whole number, 0 or more"));
    EXPECT_THAT(problems_of(text, {.constants = {{"n", Rational(1, 2)}}}),
                ElementsAre(HasSubstr("a table is applied 1/2 times")));
    EXPECT_THAT(problems_of(text, {.constants = {{"n", 100'000}}}), ElementsAre("a cycle of more than 100000 steps"));
    EXPECT_THAT(problems_of(text, {.constants = {{"n", 99'999}}}), IsEmpty());
    EXPECT_THAT(problems_of("points\n n = sqrt(2)\n axiom A\n table p\n A -> A A\n cycle p^n\n"),
                ElementsAre(HasSubstr("an irrational number of times")));
}

TEST(PointSystem, SaysWhenNoWordBegins) {
    EXPECT_THAT(problems_of("points\n A(x) -> A(x)\n"), ElementsAre(HasSubstr("what the points of a polygon become")));
    EXPECT_THAT(problems_of("points\n P(v) -> P(v)\n", {.start = PointStart::Axiom}),
                ElementsAre(HasSubstr("the grammar has no axiom")));
    EXPECT_THAT(problems_of("points\n axiom A\n A -> A\n", {.start = PointStart::Input}),
                ElementsAre(HasSubstr("what the points of a polygon become")));
}

TEST(PointSystem, RefusesDimensionsOutOfRange) {
    EXPECT_THAT(problems_of("points\n P(v) -> P(v)\n", {.dimension = 0}), ElementsAre(HasSubstr("1 to 64")));
    EXPECT_THAT(problems_of("points\n P(v) -> P(v)\n", {.dimension = 65}), ElementsAre(HasSubstr("1 to 64")));
    EXPECT_THAT(problems_of("points\n P(v) -> P(v)\n", {.dimension = 64}), IsEmpty());
}

TEST(PointSystem, RefusesAnAxiomThatIsNotFinite) {
    EXPECT_THAT(problems_of("points\n t = 1\n axiom A(1) A(1/(1 - t))\n A(x) -> A(x)\n"),
                ElementsAre("a parameter of the axiom is not finite"));
}

TEST(PointSystem, RefusesContextsWithEndMarkersThatNothingMakes) {
    const std::string rules = "e: # < P(v) -> P(v)\n P(u) < P(v) > P(w) # -> P(v) P(w)\n P(u) < P(v) -> P(u) P(v)\n";
    const auto problem = "a context with `#`, which nothing puts into a word | "
                         "`input # P(v) #` puts one at each end of a polygon";
    EXPECT_THAT(problems_of("points\n " + rules), ElementsAre(problem, problem));
    EXPECT_EQ(place_of_first_problem("points\n " + rules), "e: # < P(v) -> P(v)");
    EXPECT_THAT(problems_of("points\n input # P(v) #\n " + rules), IsEmpty());
    EXPECT_THAT(problems_of("points\n axiom # P((0, 0)) P((1, 0)) #\n " + rules), IsEmpty());
    EXPECT_THAT(problems_of("points\n axiom A\n A -> # P((0, 0)) P((1, 0)) #\n " + rules), IsEmpty())
        << "a rule may make them";
}

TEST(PointSystem, AnAxiomMakesNoEndMarkersForAPolygon) {
    const std::string text = "points\n axiom # P((0, 0)) P((1, 0)) #\n # < P(v) -> P(v)\n P(v) -> P(v) P(v)\n";
    EXPECT_THAT(problems_of(text), IsEmpty());
    EXPECT_THAT(problems_of(text, {.start = PointStart::Input}), ElementsAre(HasSubstr("input # P(v) #")));
}

TEST(PointSystem, EndMarkersMayComeFromTheWordBeforeAnInterpretation) {
    const std::string rules = "P(v) -> P(v) P(v)\n interpretation\n # < P(v) -> Q(v)\n";
    EXPECT_THAT(problems_of("points\n input # P(v) #\n " + rules), IsEmpty());
    EXPECT_THAT(problems_of("points\n " + rules), ElementsAre(HasSubstr("a context with `#`")));
}

TEST(PointSystem, TellsStepsWithStrictPredecessorsOfSeveralModules) {
    const PointSystem system =
        point_system("points\n axiom A A\n table p\n A A -> A\n table q\n A -> A A\n cycle p q\n");
    EXPECT_TRUE(system.is_pseudo(0));
    EXPECT_FALSE(system.is_pseudo(1));
}

} // namespace
} // namespace internode
