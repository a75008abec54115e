// SPDX-License-Identifier: MIT
//
// What is refused in a point grammar, where, and with which remedy.

#include "internode/grammar/points/parse_points.h"
#include "tests/grammar/error_cases.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace internode {

namespace {

using tests::ErrorCase;

void expect_point_errors(const std::vector<ErrorCase>& cases) {
    tests::expect_errors(cases, [](std::string_view text) { return parse_point_grammar(text, "t").errors; });
}

/// Of statements that follow the line `points`.
void expect_errors_after_kind(const std::vector<ErrorCase>& cases) {
    tests::expect_errors(cases, [](const std::string_view text) {
        return parse_point_grammar("points\n" + std::string(text), "t").errors;
    });
}

} // namespace

TEST(ParsePointsError, CoverWhatStandsInParentheses) {
    const std::vector<Diagnostic> errors = parse_point_grammar("points\nP(u) < P(v) -> P(-(1 < 2) + u)\n", "t").errors;
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].column, 19U);
    EXPECT_EQ(errors[0].width, std::string_view("(1 < 2)").size());
}

TEST(ParsePointsError, OfTheFirstStatement) {
    expect_point_errors({
        {"", "1:1 the text has no statement | begin with `points NAME`, then one rule a line: `P(v) -> P(v) P(v)`\n"},
        {"points", "1:1 a grammar without rules | write one rule a line: `P(v) -> P(v) P(v)`\n"},
        {"intervals\nP(v) -> P(v)", "1:1 a grammar of kind `intervals` where a point grammar is wanted | begin with "
                                    "`points NAME`, then one rule a line: `P(v) -> P(v) P(v)`\n"},
        {"P(v) -> P(v)", "1:1 the first statement must be `points` | begin with `points NAME`, then one rule a line: "
                         "`P(v) -> P(v) P(v)`\n"},
        {"points a-b\nP(v) -> P(v)", "1:8 a name is a letter, then letters, digits, `_` or `'` | any other name stands "
                                     "in quotes: `points \"my-grammar\"`\n"},
        {"points a P(v) -> P(v)", "1:1 the kind of the grammar stands on a line of its own | begin with `points NAME`, "
                                  "then one rule a line: `P(v) -> P(v) P(v)`\n"},
        {"points\nE -> E\npoints x", "3:1 the kind of a grammar is named once, in its first statement\n"},
    });
}

TEST(ParsePointsError, OfParameters) {
    expect_errors_after_kind({
        {"P(v, v) -> P(v, v)", "2:6 a second parameter `v` | all names of a rule differ; to compare, write a "
                               "condition: `A(x) < B(y) : x == y -> ...`\n"},
        {"A(x) < B(x) -> A(x)", "2:10 a second parameter `x` | all names of a rule differ; to compare, write a "
                                "condition: `A(x) < B(y) : x == y -> ...`\n"},
        {"P(1) -> P(1)", "2:3 `1` is no name of a parameter | before the arrow a parameter is a name; to compare, "
                         "write a condition: `P(x) : x == 1 -> ...`\n"},
        {"P(2x) -> P(x)", "2:3 `2x` is no name of a parameter | before the arrow a parameter is a name; to compare, "
                          "write a condition: `P(x) : x == 1 -> ...`\n"},
        {"P(x + y) -> P(x)", "2:3 `x + y` is no name of a parameter | before the arrow a parameter is a name; to "
                             "compare, write a condition: `P(x) : x == 1 -> ...`\n"},
        {"P() -> P(1)", "2:2 no parameter here | a module without parameters has no parentheses: `E`\n"},
        {"P(max) -> P(1)", "2:3 `max` is a word of the language | choose another name\n"},
        {"# (v) -> #", "2:3 `#` has no parameters\n"},
        {"# -> # #(v)", "2:9 `#` has no parameters\n"},
        {"input P(v)\nP(u, s) < P(v) -> P(v)", "3:1 `P` has 2 parameters here, but 1 parameter where it is made, as in "
                                               "line 2 | a module matches one with the "
                                               "same letter and as many parameters\n"},
    });
}

TEST(ParsePointsError, OfNames) {
    expect_errors_after_kind({
        {"P(v) -> P(w)", "2:11 `w` is no parameter and no constant | a parameter stands before the arrow, as in "
                         "`P(w)`; a constant is defined: `w = 1/2`\n"},
        {"tension = 1/2\nP(v) -> P(tensoin v)",
         "3:11 `tensoin` is no parameter and no constant | did you mean `tension`?\n"},
        {"P(v) -> P(f(v))", "2:11 `f` is no function | a function is defined: `f(x) = x/2`\n"},
        {"P(v) -> P(1e-3 v)", "2:12 `e` is no name here | numbers have no exponents: write `0.001`\n"},
        {"P(v) -> P(sqrt v)", "2:11 `sqrt` is a function | write `sqrt(x)`\n"},
    });
}

TEST(ParsePointsError, OfDefinitions) {
    expect_errors_after_kind({
        {"f(x) = 2 g(x)\ng(x) = x\nP(v) -> P(g(v, 1))",
         "2:10 `g` is defined later, in line 3 | definitions use earlier ones only: move it up\n"
         "4:11 `g` takes 1 argument, not 2\n"},
        {"f(x) = 2 f(x)\nP(v) -> P(f v)", "2:10 the definition of `f` uses itself | definitions use earlier ones only: "
                                          "what repeats is the work of rules\n"
                                          "3:11 `f` is a function | write `f(x)`\n"},
        {"t = 1/2\nt = 1/3\nP(v) -> P(v)", "3:1 a second definition of `t` | the first is in line 2\n"},
        {"min = 3\nE -> E", "2:1 `min` is a word of the language | choose another name\n"},
        {"table(x) = x\nE -> E", "2:1 `table` is a word of the language | choose another name\n"},
        {"f(x, x) = x\nE -> E", "2:6 a second parameter `x` | all names differ\n"},
        {"f(1) = 2\nE -> E", "2:3 `1` is no name | a name is a letter, then letters, digits, `_` or `'`\n"},
        {"f() = 2\nE -> E", "2:2 the parameters of a function are names | write `f(s, t) = ...`\n"},
        {"t =\nE -> E", "2:3 no value after `=` | write `t = 1/2`\n"},
        {"t = 1 < 2\nE -> E", "2:5 a condition where a value is wanted\n"},
        {"u = (1, 2)\nE -> E", "2:5 a point where a number is wanted | `.x`, `.y`, `.z`, `.w` are its coordinates\n"},
        {"h(x) + 1 = 2\nE -> E",
         "2:1 `h` begins no statement | a statement is a rule `P(u) < P(v) -> P(u) P(v)`, a definition `t = 1/2`, or "
         "begins with `ring`, `input`, `axiom`, `table`, `cycle` or `interpretation`\n"},
    });
}

TEST(ParsePointsError, OfProducts) {
    expect_errors_after_kind({
        {"P(a, b) -> P(a/b a, a/2b)",
         "2:14 a quotient, then a factor: is it below the line? | write `a/b * c` or `a/(b c)`; `1/2 v` is half of v\n"
         "2:21 a quotient, then a factor: is it below the line? | write `a/b * c` or `a/(b c)`; `1/2 v` is half of "
         "v\n"},
        {"P(v) -> P(2 3)", "2:13 `3` follows a value | write `*` before a number: `v * 2`, or `2 v`\n"},
        {"P(v) -> P(v 2)", "2:13 `2` follows a value | write `*` before a number: `v * 2`, or `2 v`\n"},
        {"P(v) -> P(v^2)", "2:12 `^` has no meaning in an expression | write `x x`, or `x * x`\n"},
    });
}

TEST(ParsePointsError, OfDivisionsByZero) {
    expect_errors_after_kind({
        {"P(v) -> P(1/0) P(v/0) P(v/(1 - 1)) P(0.0/0)", "2:11 a division by zero\n"
                                                        "2:18 a division by zero\n"
                                                        "2:25 a division by zero\n"
                                                        "2:38 a division by zero\n"},
    });
}

TEST(ParsePointsError, OfTruthsAndNumbers) {
    expect_errors_after_kind({
        {"P(v) : v + 1 -> P(v)",
         "2:8 a number where a condition is wanted | a condition compares: `x < 2`, `x == 0 and y != 1`\n"},
        {"P(v) -> P((v < 1) + 2)", "2:11 a truth where a number is wanted\n"},
        {"P(v) -> P(v < 1)", "2:11 a condition where a value is wanted\n"},
        {"P(v) -> P(v and 1)",
         "2:17 a number where a truth is wanted | a condition compares numbers: `x < 2`, `x == 0 and y != 1`\n"},
        {"P(v) : 0 < v < 1 -> P(v)",
         "2:8 a truth where a number is wanted | comparisons are joined by `and`: `0 < x and x < 1`\n"},
        {"P(v) : not v -> P(v)",
         "2:12 a number where a truth is wanted | a condition compares numbers: `x < 2`, `x == 0 and y != 1`\n"},
        {"P(v) -> P(v and)", "2:16 an operation without its right side\n"},
        {"P(v) -> P(and v)", "2:11 `and` has nothing on its left\n"},
    });
}

TEST(ParsePointsError, OfPointsAndNumbers) {
    expect_errors_after_kind({
        {"P(v) -> P((v, 1) + 2)",
         "2:18 a sum of a number and a point | `.x`, `.y`, `.z`, `.w` are the coordinates of a point\n"},
        {"P(v) -> P((1, 2) (3, 4))",
         "2:11 a product of two points | `.x`, `.y`, `.z`, `.w` are the coordinates of a point\n"},
        {"P(v) -> P(1/(v, 2))", "2:13 a division by a point | `.x`, `.y`, `.z`, `.w` are the coordinates of a point\n"},
        {"P(v) -> P(2.x)",
         "2:12 a coordinate of what is no point | `.x`, `.y`, `.z`, `.w` are the coordinates of a point\n"},
        {"P(v) -> P((1, 2).z)", "2:17 coordinate 3 of a point of 2\n"},
        {"P(v) -> P(min((1, 2), 3))",
         "2:15 a point where a number is wanted | `.x`, `.y`, `.z`, `.w` are the coordinates of a point\n"},
        {"P(v) -> P(((1, 2), 3))",
         "2:12 a point where a number is wanted | `.x`, `.y`, `.z`, `.w` are the coordinates of a point\n"},
        {"P(v) -> P((1, v < 2))", "2:15 a truth where a number is wanted\n"},
        {"P(v) -> P(v.q)", "2:12 `.q` is no coordinate | `.x`, `.y`, `.z`, `.w` are the coordinates of a point\n"},
        {"P(v) -> P(v.xy)", "2:12 `.xy` is no coordinate | `.x`, `.y`, `.z`, `.w` are the coordinates of a point\n"},
        {"P(v) -> P(v..x)", "2:12 `.` is no coordinate | `.x`, `.y`, `.z`, `.w` are the coordinates of a point\n"},
    });
}

TEST(ParsePointsError, OfCalls) {
    expect_errors_after_kind({
        {"P(v) -> P(sqrt(1, 2))", "2:11 `sqrt` takes 1 argument, not 2\n"},
        {"P(v) -> P(min(1))", "2:11 `min` takes at least 2 arguments, not 1\n"},
        {"P(v) -> P(min())", "2:15 nothing where a value is wanted\n"},
        {"f(x, y) = x\nP(v) -> P(f(v))", "3:11 `f` takes 2 arguments, not 1\n"},
    });
}

TEST(ParsePointsError, OfSigns) {
    expect_errors_after_kind({
        {"P(v) -> P(v % 2)", "2:13 `%` has no meaning in an expression | write `x - 2 floor(x/2)`\n"},
        {"P(v) -> P(!v)", "2:11 `!` where a value is wanted | write `not`, or `!=`\n"},
        {"P(v) -> P(v & v)", "2:13 `&` has no meaning in an expression | write `and`\n"},
        {"P(v) -> P(+v)", "2:11 a sign `+` before a value | leave it out\n"},
        {"P(v) -> P(v +)", "2:14 an operation without its right side\n"},
        {"P(v) -> P(v, , v)", "2:12 no parameter here\n"},
        {"P(v) -> P(\"v\")", "2:11 `\"v\"` where a value is wanted\n"},
        {"P(v) -> P(@)", "2:11 `@` where a value is wanted\n"},
        {"P(v) -> P(v not v)", "2:13 `not` follows a value | write `x < 1 and not y < 1`\n"},
    });
}

TEST(ParsePointsError, OfBrackets) {
    expect_errors_after_kind({
        {"P(v) -> P((v + 1) P(v", "2:10 `(` is never closed\n"},
        {"P(v] -> P(v)", "2:2 `(` is never closed\n"},
        {"A -> B : (1, 2\n) -> C", "2:10 `(` is never closed\n3:1 `)` is no module\n"},
        {"[ P(v) -> P(v)", "2:1 `[` is never closed\n"},
        {"P(v) -> ] P(v)", "2:9 `]` was never opened\n"},
        {"P(v) -> [ P(v)", "2:9 `[` is never closed\n"},
        {"P(v) [ P(v) ] -> P(v)",
         "2:6 a bracket before the arrow | contexts step over branches by themselves; brackets are never rewritten\n"},
        {"P(v) -> P([v])", "2:11 `[` where a value is wanted | a point is written `(x, y)`\n"},
        {"P(v) -> (P(v))", "2:9 parentheses without a letter | parameters follow a letter: `P(v)`\n"},
        {"E -> [ E ]^2", "2:11 a power of a bracket | a power repeats one module: `X^3`\n"},
    });
}

TEST(ParsePointsError, OfModules) {
    expect_errors_after_kind({
        {"P(v) -> P(v) . E", "2:14 `.` among modules | it is the empty successor and stands alone\n"},
        {"E -> E^0", "2:8 a power must be at least 1\n"},
        {"E -> E^", "2:7 `^` without a count | write `X^3`\n"},
        {"E -> E^2^3", "2:9 a power of a power | write one power\n"},
        {"E^2 -> E", "2:2 a power before the arrow | write the modules side by side\n"},
        {"E -> ^2", "2:6 `^` is no module | a power follows a module: `X^3`\n"},
        {"E -> 3", "2:6 `3` is no module | a letter, then digits, `_` or `'`, then parameters: `P(v)`\n"},
        {"P(v) -> ? Q(1)", "2:9 `?` without a letter | a query module is written `?Q(x)`\n"},
        {"E ->\naxiom E", "3:1 `axiom` begins a statement | a successor that the line before lacks is written `.`; "
                          "letters may stand apart\n"},
        {"E ->\naxoim E", "3:1 `axiom` begins a statement | a successor that the line before lacks is written `.`; "
                          "letters may stand apart\n"},
    });
}

TEST(ParsePointsError, OfTheShapeOfARule) {
    expect_errors_after_kind({
        {"P(v) -> P(v) -> P(v)",
         "2:14 a second `->` in one statement | begin each rule on a line of its own, or after `,`\n"},
        {"-> P(v)",
         "2:1 no module to rewrite | a rule is `label : left < module > right : condition -> successor : weight`\n"},
        {"< P(v) -> P(v)",
         "2:1 no left context | a rule is `label : left < module > right : condition -> successor : weight`\n"},
        {"P(v) < -> P(v)",
         "2:8 no module to rewrite | a rule is `label : left < module > right : condition -> successor : weight`\n"},
        {"P(v) > -> P(v)",
         "2:6 no right context | a rule is `label : left < module > right : condition -> successor : weight`\n"},
        {"A < B < C -> A", "2:7 a second `<` before the arrow | a rule is `label : left < module > right : condition "
                           "-> successor : weight`\n"},
        {"A > B < C -> A",
         "2:3 `>` before `<` | a rule is `label : left < module > right : condition -> successor : weight`\n"},
        {"a : b : c : d -> A", "2:11 a third `:` before the arrow | a rule is `label : left < module > right : "
                               "condition -> successor : weight`\n"},
        {"a b : P(v) : v < 1 -> A",
         "2:1 a label is one name | a rule is `label : left < module > right : condition -> successor : weight`\n"},
        {"min : P(v) -> P(v)", "2:1 `min` is a word of the language | choose another name\n"},
        {"P(v) : -> P(v)",
         "2:6 no condition after `:` | a rule is `label : left < module > right : condition -> successor : weight`\n"},
        {"a : P(v) : -> P(v)",
         "2:10 no condition after `:` | a rule is `label : left < module > right : condition -> successor : weight`\n"},
        {"P(v) -> P(v) :", "2:14 no weight after `:` | a condition stands before the arrow, a weight at the end\n"},
        {"P(v) -> P(v) : 0", "2:16 a weight must be positive | leave the rule out if it never applies\n"},
        {"P(v) -> P(v) : -1/2", "2:16 a weight must be positive | leave the rule out if it never applies\n"},
        {"P(v) ->", "2:6 an empty successor | a module that vanishes becomes `.`\n"},
        {"n = 3\nE : n > t -> F", "3:5 `n` is a constant, here a module | after a single name `:` begins the rule; a "
                                  "condition stands in parentheses: `E : (n > 2) -> F`\n"},
    });
}

TEST(ParsePointsError, OfInputs) {
    expect_errors_after_kind({
        {"input P(1)\nE -> E",
         "2:7 the input does not use its point | the point is a name that is no constant: `input P(v)`\n"},
        {"input\nE -> E", "2:1 an empty input | write `input P(v) E`, or `input P(v, 2) E | P(v, 0) E | P(v, 2)` for "
                          "the first, each inner and the last point\n"},
        {"input P(v) | P(v)\nE -> E", "2:7 an input of 2 parts | write `input P(v) E`, or `input P(v, 2) E | P(v, 0) E "
                                      "| P(v, 2)` for the first, each inner and the last point\n"},
        {"input P(v) | P(w) | P(v)\nE -> E", "2:16 `w` is no parameter and no constant | a parameter stands before the "
                                             "arrow, as in `P(w)`; a constant is defined: `w = 1/2`\n"},
        {"input P(v) | E | P(v)\nE -> E",
         "2:14 the input does not use its point | the point is a name that is no constant: `input P(v)`\n"},
        {"input # P(v)\nE -> E",
         "2:7 an end marker beside each point | write `input # P(v) #`: one marker at each end of the word\n"},
        {"input P(v) | | P(v)\ninput P(v)\nE -> E",
         "2:7 an empty part of the input | write `input P(v) E`, or `input P(v, 2) E | P(v, 0) E | P(v, 2)` for the "
         "first, each inner and the last point\n"
         "3:1 a second `input` | the first is in line 2\n"},
        {"v = 1\ninput P(v)\nE -> E",
         "3:7 the input does not use its point | the point is a name that is no constant: `input P(v)`\n"},
    });
}

TEST(ParsePointsError, OfAxioms) {
    expect_errors_after_kind({
        {"axiom P(v)\naxiom P((0,0))\nE -> E", "2:9 `v` is no parameter and no constant | a parameter stands before "
                                               "the arrow, as in `P(v)`; a constant is defined: `v = 1/2`\n"
                                               "3:1 a second `axiom` | the first is in line 2\n"},
        {"axiom\nE -> E", "2:1 `axiom` without modules | write `axiom P((0, 0)) P((1, 0))`\n"},
    });
}

TEST(ParsePointsError, OfRings) {
    expect_errors_after_kind({
        {"ring\nring\nring now\nE -> E", "3:1 a second `ring` | the first is in line 2\n"
                                         "4:6 `ring` stands alone | write it on a line of its own\n"},
    });
}

TEST(ParsePointsError, OfTables) {
    expect_errors_after_kind({
        {"table p\nE -> E", "2:1 tables without a `cycle` | say in which order they apply: `cycle p q^2`\n"},
        {"cycle p\nE -> E", "2:1 a `cycle` without tables | begin a table with `table p`, or leave `cycle` out\n"},
        {"table smooth\nE -> E\ncycle smoth q", "4:7 no table `smoth` | did you mean `smooth`?\n"
                                                "4:13 no table `q` | the first table is `smooth`\n"},
        {"table p\ntable p\ntable 3\ntable\nE -> E\ncycle p",
         "3:7 a second table `p` | all rules of a table stand together\n"
         "4:7 `3` is no name | a name is a letter, then letters, digits, `_` or `'`\n"
         "5:1 `table` needs one name | write `table p`, and its rules after it\n"},
        {"E -> E\ninterpretation\ntable p\ncycle p", "4:1 a table after `interpretation` | tables come first\n"},
        {"E -> E\ninterpretation now", "3:16 `interpretation` stands alone | its rules stand on the lines after it\n"},
    });
}

TEST(ParsePointsError, OfCycles) {
    expect_errors_after_kind({
        {"table p\nE -> E\ncycle", "4:1 an empty cycle | write `cycle p q^2`, `cycle p q^n` or `cycle p q^(n - 1)`\n"},
        {"table p\nE -> E\ncycle p^",
         "4:8 `^` without a count | write `cycle p q^2`, `cycle p q^n` or `cycle p q^(n - 1)`\n"},
        {"table p\nE -> E\ncycle p^(1/2)", "4:9 1/2 is no count | a count is 0, 1, 2, ...\n"},
        {"table p\nE -> E\ncycle p^-1",
         "4:8 `^` without a count | write `cycle p q^2`, `cycle p q^n` or `cycle p q^(n - 1)`\n"},
        {"n = 1\ntable p\nE -> E\ncycle p^x\ncycle p",
         "5:9 `x` is no parameter and no constant | a parameter stands before the arrow, as in `P(x)`; a constant is "
         "defined: `x = 1/2`\n"
         "6:1 a second `cycle` | the first is in line 5\n"},
        {"table p\nE -> E\ncycle p^1/2",
         "4:10 `/` is no table | write `cycle p q^2`, `cycle p q^n` or `cycle p q^(n - 1)`\n"},
        {"table p\nE -> E\ncycle p^(1, 2)",
         "4:9 a point where a number is wanted | `.x`, `.y`, `.z`, `.w` are its coordinates\n"},
    });
}

TEST(ParsePointsError, OfStatements) {
    expect_errors_after_kind({
        {"P(v)", "2:1 `P` begins no statement | a statement is a rule `P(u) < P(v) -> P(u) P(v)`, a definition `t = "
                 "1/2`, or begins with `ring`, `input`, `axiom`, `table`, `cycle` or `interpretation`\n"},
        {"E -> E\nE E", "3:1 `E` begins no statement | a rule ends with its line: go on after the arrow or inside "
                        "parentheses, or begin a statement with a word or an `=`\n"},
        {"tabel p\nE -> E", "2:1 `tabel` begins no statement | did you mean `table`?\n"},
        {"length P = 3\nE -> E",
         "2:1 a point grammar has no `length` | a statement is a rule `P(u) < P(v) -> P(u) P(v)`, a definition `t = "
         "1/2`, or begins with `ring`, `input`, `axiom`, `table`, `cycle` or `interpretation`\n"},
        {"(\nE -> E", "2:1 `(` is never closed\n"},
    });
}

} // namespace internode
