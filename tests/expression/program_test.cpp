// SPDX-License-Identifier: MIT

#include "internode/expression/program_run.h"

#include "internode/point/start_word.h"
#include "tests/point/systems.h"

#include <gtest/gtest.h>

#include <cmath>

namespace internode {
namespace {

/// The only value of the only module after one step from A(x, v), v a point.
std::vector<double> value(const std::string& expression, const std::string& axiom = "A(3, (1/2, 5))") {
    const PointSystem system =
        point_system("points\nt = 1/10\nf(a, b) = a*10 + b\naxiom " + axiom + "\nA(x, v) -> B(" + expression + ")\n");
    const ModuleWord word = derived(system, axiom_word(system), 1);
    return {word.values(0).begin(), word.values(0).end()};
}

using Doubles = std::vector<double>;

TEST(Program, ComputesNumbersAndPoints) {
    EXPECT_EQ(value("x"), Doubles{3});
    EXPECT_EQ(value("v"), (Doubles{0.5, 5}));
    EXPECT_EQ(value("x v - v"), (Doubles{1, 10}));
    EXPECT_EQ(value("v*x"), (Doubles{1.5, 15}));
    EXPECT_EQ(value("v/x"), (Doubles{0.5 / 3, 5.0 / 3}));
    EXPECT_EQ(value("-v"), (Doubles{-0.5, -5}));
    EXPECT_EQ(value("(v.y, v.x, x)"), (Doubles{5, 0.5, 3}));
    EXPECT_EQ(value("(v.y, x).y"), Doubles{3});
    EXPECT_EQ(value("min(x, 2) + max(x, 5) + floor(x/2) + abs(-x) + sqrt(x + 1)"), Doubles{2 + 5 + 1 + 3 + 2});
    EXPECT_EQ(value("f(x, v.y)"), Doubles{35});
    EXPECT_EQ(value("f(f(x, 1), f(1, x)) v"), (Doubles{323 * 0.5, 323 * 5.0}));
}

TEST(Program, FoldsLiteralsAndConstantsExactlyAndRoundsOnce) {
    EXPECT_EQ(value("(0.1 + 0.2) x"), Doubles{0.3 * 3});
    EXPECT_EQ(value("(1 - t) x"), Doubles{0.9 * 3});
    EXPECT_EQ(value("(t + t + t) x"), Doubles{0.3 * 3});
    EXPECT_EQ(value("f(t, 1/10) x"), Doubles{1.1 * 3});
    EXPECT_EQ(value("1/3 (3, 6) + 0 v"), (Doubles{1, 2}));
    EXPECT_EQ(value("sqrt(1/9) x"), Doubles{1.0 / 3 * 3});
    EXPECT_EQ(value("sqrt(2) x"), Doubles{std::sqrt(2.0) * 3});
    EXPECT_EQ(value("(1/3 (3, 6)).y + x"), Doubles{5});
}

TEST(Program, ComparesLiteralsExactly) {
    EXPECT_EQ(after("points\naxiom A(1)\na: A(x) : 0.1 + 0.2 == 0.3 -> B\n", 1), "B");
    EXPECT_EQ(after("points\naxiom A(1)\na: A(x) : 1/3 < 0.33333333333333333333 -> B\n", 1), "A(1)");
}

TEST(Program, AddsFromLeftToRightAsWritten) {
    const double u = 0.1;
    const double v = 0.7;
    const double w = 1e16;
    const PointSystem system = point_system("points\naxiom A(0.1, 0.7, 10000000000000000)\n"
                                            "A(u, v, w) -> A(1/3 u + 1/7 v + w, w + 1/7 v + 1/3 u, u + (v + w))\n");
    const ModuleWord word = derived(system, axiom_word(system), 1);
    EXPECT_EQ(word.values(0)[0], (1.0 / 3 * u + 1.0 / 7 * v) + w);
    EXPECT_EQ(word.values(0)[1], (w + 1.0 / 7 * v) + 1.0 / 3 * u);
    EXPECT_EQ(word.values(0)[2], u + (v + w));
}

TEST(Program, BothSidesOfATruthAreEvaluated) {
    EXPECT_EQ(after("points\naxiom A(0)\na: A(x) : x == 0 or 1/x > 0 -> B\n", 1), "B");
    EXPECT_EQ(after("points\naxiom A(0)\na: A(x) : not x == 0 and 1/x > 0 -> B\n", 1), "A(0)");
}

TEST(Program, CallsNestAsDeepAsTheTextHasDefinitions) {
    std::string text = "points\nf0(s) = s + 1\n";
    for (int i = 1; i < 5000; ++i) text += "f" + std::to_string(i) + "(s) = 1 + f" + std::to_string(i - 1) + "(s)\n";
    EXPECT_EQ(after(text + "a = f4999(0)\naxiom A(1)\nA(x) -> A(f4999(x) + a)\n", 1), "A(10001)");
}

} // namespace
} // namespace internode
