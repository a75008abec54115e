// SPDX-License-Identifier: MIT
//
// What is too large in a point grammar is refused with its number, and hostile sizes are met in linear time and bounded
// memory. Each of these texts would hang, overflow the stack or exhaust memory if it were not.

#include "internode/grammar/lexing/limits.h"

#include "internode/grammar/points/parse_points.h"
#include "internode/grammar/points/print_points.h"
#include "tests/fixtures/small_stack.h"
#include "tests/fixtures/stride.h"
#include "tests/fixtures/texts.h"

#include <gmock/gmock.h>

#include <fmt/format.h>

namespace internode {

namespace {

using testing::StartsWith;
using tests::repeated;

/// Of the statements after `points`; empty when there is none, and then the normal form is readable too.
std::string first_error(const std::string& statements) {
    const ParsedPointGrammar parsed = parse_point_grammar("points\n" + statements, "t");
    if (!parsed.errors.empty()) return parsed.errors.front().message;
    const ParsedPointGrammar again = parse_point_grammar(print(*parsed.grammar), "p");
    EXPECT_TRUE(again.errors.empty()) << to_string(again.errors);
    EXPECT_EQ(again.grammar, parsed.grammar);
    return {};
}

std::string nested(std::string_view open, std::string_view inner, std::string_view close, std::size_t depth) {
    return repeated(open, depth) + std::string(inner) + repeated(close, depth);
}

std::string rule_with(const std::string& value) {
    return "P(v) -> P(" + value + ")";
}

constexpr std::string_view rule = "P(v) -> P(v)\n";

} // namespace

TEST(PointLimits, OfNesting) {
    const std::string refused = "more than 200 levels of parentheses and signs";
    const std::vector<std::pair<std::string_view, std::string_view>> shapes{
        {"(", ")"}, {"-", ""}, {"abs(", ")"}, {"1 - (", ")"}, {"v (", ")"}, {"min(1, ", ")"}};
    for (const auto& [open, close] : shapes) {
        EXPECT_EQ(first_error(rule_with(nested(open, "v", close, 200))), "") << open;
        EXPECT_EQ(first_error(rule_with(nested(open, "v", close, 201))), refused) << open;
    }
    EXPECT_EQ(first_error("P(v) : " + nested("not ", "v < 1", "", 200) + " -> P(v)"), "");
    EXPECT_EQ(first_error("P(v) : " + nested("not ", "v < 1", "", 201) + " -> P(v)"), refused);
    EXPECT_EQ(first_error("axiom P(" + nested("(1, ", "1", ").x", 200) + ")\n" + std::string(rule)), "");
    EXPECT_EQ(first_error("axiom P(" + nested("(1, ", "1", ").x", 201) + ")\n" + std::string(rule)), refused);
}

TEST(PointLimits, OfNestingLeaveRoomForTheParenthesesOfTheNormalForm) {
    const std::string refused = "more than 200 levels of parentheses and signs";
    EXPECT_EQ(first_error(rule_with(nested("(v + ", "v/0.5", ")", 199))), "");
    EXPECT_EQ(first_error(rule_with(nested("(v + ", "v/0.5", ")", 200))), refused);
    // A sign is a level of its own, between the `/` and the fraction.
    EXPECT_EQ(first_error(rule_with(nested("(v + ", "v/-0.5", ")", 198))), "");
    EXPECT_EQ(first_error(rule_with(nested("(v + ", "v/-0.5", ")", 199))), refused);
    EXPECT_EQ(first_error(rule_with(nested("(v + ", "v/--0.5", ")", 197))), "");
    EXPECT_EQ(first_error(rule_with(nested("(v + ", "v/--0.5", ")", 198))), refused);
    EXPECT_EQ(first_error(rule_with(nested("(v + ", "v/-2", ")", 199))), "");
    EXPECT_EQ(first_error(rule_with(nested("(v + ", "v/2", ")", 200))), "");
    const std::string two = "t = 1\nE : (t) < 2 and ";
    EXPECT_EQ(first_error(two + nested("(", "t < 3", ")", 199) + " -> E"), "");
    EXPECT_EQ(first_error(two + nested("(t + ", "t", ")", 199) + " < 3 -> E"), "");
    EXPECT_EQ(first_error(two + nested("(t + ", "t", ")", 200) + " < 3 -> E"), refused);
    EXPECT_EQ(first_error("t = 1\nE : " + nested("(", "t < 3", ")", 200) + " -> E"), "");
}

TEST(PointLimits, ADeepTextIsRefusedWithoutDepth) {
    tests::run_on_stack(std::size_t{1} << 20, [] {
        const auto many = static_cast<std::size_t>(tests::times(1'000'000, 100'000));
        const std::string refused = "more than 200 levels of parentheses and signs";
        for (const std::string_view open : {"(", "-", "abs(", "v (", "min(v, ", "(v, "}) {
            const std::string close = open.back() == '-' ? "" : repeated(")", many);
            EXPECT_EQ(first_error("P(v) -> P(" + repeated(open, many) + "v" + close + ")"), refused) << open;
            EXPECT_NE(first_error("P(v) -> P(" + repeated(open, many)), "") << open;
        }
        EXPECT_EQ(first_error("P(v) -> P(v" + repeated(")", many)), "`)` was never opened");
        EXPECT_EQ(first_error("P(v) -> P(v) " + repeated("[", many)), "`[` is never closed");
        EXPECT_EQ(first_error("E -> " + repeated("[", 40'000) + repeated("]", 40'000)), "");
        EXPECT_EQ(first_error(rule_with("v" + repeated("+v", 40'000))), "");
        EXPECT_EQ(first_error(rule_with("min(v" + repeated(",v", 40'000) + ")")), "");
    });
}

TEST(PointLimits, OfParameters) {
    const std::string many = "1" + repeated(", 1", 63);
    EXPECT_EQ(first_error("axiom Q(" + many + ")\nE -> E"), "");
    EXPECT_EQ(first_error("axiom Q(" + many + ", 1)\nE -> E"), "a module of 65 parameters, more than 64");
    std::string formals = "a0";
    for (int i = 1; i < 64; ++i) formals += fmt::format(", a{}", i);
    EXPECT_EQ(first_error("f(" + formals + ") = a0\n" + std::string(rule)), "");
    EXPECT_EQ(first_error("f(" + formals + ", b) = a0\n" + std::string(rule)),
              "a function of 65 parameters, more than 64");
}

TEST(PointLimits, OfCoordinates) {
    const std::string many = "(1" + repeated(", 1", 63);
    EXPECT_EQ(first_error(rule_with(many + ")")), "");
    EXPECT_EQ(first_error(rule_with(many + ", 1)")), "a point of 65 coordinates, more than 64");
}

TEST(PointLimits, OfLetters) {
    std::string axiom = "axiom";
    for (std::size_t i = 1; i < max_point_letters; ++i) axiom += fmt::format(" A{}", i);
    EXPECT_EQ(first_error(axiom + "\nE -> E"), "");
    EXPECT_EQ(first_error(axiom + " B\nE -> E"), "more than 1000 letters");
}

TEST(PointLimits, OfDefinitions) {
    std::string text;
    for (std::size_t i = 0; i < max_definitions; ++i) text += fmt::format("a{} = 1\n", i);
    EXPECT_EQ(first_error(text + std::string(rule)), "");
    EXPECT_EQ(first_error(text + "b = 1\n" + std::string(rule)), "more than 10000 constants and functions");
}

TEST(PointLimits, OfTablesAndCycles) {
    std::string text;
    for (std::size_t i = 0; i < max_tables; ++i) text += fmt::format("table a{}\n", i);
    EXPECT_EQ(first_error(std::string(rule) + text + "cycle a1"), "");
    EXPECT_EQ(first_error(std::string(rule) + text + "table b\ncycle a1"), "more than 1000 tables");
    const std::string items = "table p\n" + std::string(rule) + "cycle" + repeated(" p", max_cycle_items);
    EXPECT_EQ(first_error(items), "");
    EXPECT_EQ(first_error(items + " p"), "more than 10000 tables in a cycle");
    EXPECT_EQ(first_error(std::string(rule) + repeated("interpretation\n", max_tables)), "");
    EXPECT_EQ(first_error(std::string(rule) + repeated("interpretation\n", max_tables + 1)),
              "more than 1000 interpretations");
}

TEST(PointLimits, OfTheModulesBeforeAnArrow) {
    EXPECT_EQ(first_error(repeated("E ", 500) + "< E > " + repeated("E ", 499) + "-> E"), "");
    EXPECT_EQ(first_error(repeated("E ", 500) + "< E > " + repeated("E ", 500) + "-> E"),
              "1001 modules before the arrow, more than 1000");
    EXPECT_EQ(first_error(repeated("E ", 100'000) + "< E -> E"), "more than 1000 modules before the arrow");
    EXPECT_EQ(first_error(repeated("E", 100'000) + " -> E"), "more than 1000 modules before the arrow");
}

TEST(PointLimits, OfTheModulesOfAGrammar) {
    EXPECT_EQ(first_error("axiom E^99999\nE -> ."), "");
    EXPECT_EQ(first_error("axiom E^99999\nE -> E"), "more than 100000 modules in one grammar");
    EXPECT_EQ(first_error("axiom E^100001\nE -> ."), "more than 100000 modules in one grammar");
    EXPECT_EQ(first_error("axiom E^" + std::string(100'000, '9') + "\nE -> ."),
              "more than 100000 modules in one grammar");
    EXPECT_EQ(first_error("axiom " + repeated("E ", 100'001) + "\nE -> ."), "more than 100000 modules in one grammar");
    std::string rules;
    for (int i = 0; i < 400; ++i) rules += repeated("E", 250) + " -> .\n";
    EXPECT_EQ(first_error(rules), "");
    EXPECT_EQ(first_error(rules + "E -> ."), "more than 100000 modules in one grammar");
}

TEST(PointLimits, OfOperations) {
    EXPECT_EQ(first_error(rule_with("v" + repeated("+v", 49'999))), "");
    EXPECT_EQ(first_error(rule_with("v" + repeated("+v", 50'000))), "an expression of more than 100000 operations");
    EXPECT_EQ(first_error(rule_with("0" + repeated("+1", 50'000))), "an expression of more than 100000 operations");
    const std::string eleven = "P(v) -> P(v+v+v+v+v+v)";
    EXPECT_EQ(first_error(eleven + "^9091"), "");
    EXPECT_EQ(first_error(eleven + "^9092"), "powers repeat more than 100000 operations in one grammar");
    EXPECT_EQ(first_error(eleven + "^5000\n" + eleven + "^5000"),
              "powers repeat more than 100000 operations in one grammar");
    std::string rules;
    for (int i = 0; i < 11; ++i) rules += rule_with("v" + repeated("+v", 49'000)) + '\n';
    EXPECT_EQ(first_error(rules), "more than 1000000 operations in one grammar");
}

TEST(PointLimits, OfDigits) {
    const std::string digits(max_digits, '7');
    EXPECT_EQ(first_error(rule_with(digits + " v")), "");
    EXPECT_EQ(first_error(rule_with(digits + "7 v")), "a number of more than 1000 digits");
    EXPECT_EQ(first_error(rule_with("0." + std::string(max_digits - 1, '7') + " v")), "");
    EXPECT_EQ(first_error(rule_with("0." + digits + " v")), "a number of more than 1000 digits");
    EXPECT_EQ(first_error(rule_with(digits + " * 9")), "a number of more than 1000 digits");
    EXPECT_EQ(first_error(rule_with("1/" + digits + "/9")), "a number of more than 1000 digits");
}

TEST(PointLimits, OfNames) {
    const std::string longest_name(max_name_bytes, 'a');
    EXPECT_EQ(first_error(fmt::format("P({0}) -> P({0})", longest_name)), "");
    EXPECT_EQ(first_error(fmt::format("P({0}a) -> P({0}a)", longest_name)), "a name of 101 bytes, more than 100");
    EXPECT_EQ(first_error(longest_name + "a = 1\n" + std::string(rule)), "a name of 101 bytes, more than 100");
    EXPECT_EQ(first_error("A1" + std::string(max_name_bytes, '1') + " -> ."),
              "a symbol of 102 characters, more than 100");
}

TEST(PointLimits, OfWhatIsWrittenOut) {
    const std::string number(max_digits, '7');
    EXPECT_EQ(first_error("P(v) -> P(" + number + ")^10000"), "");
    EXPECT_EQ(first_error("P(v) -> P(" + number + ")^13000"), "this power makes a line of more than 12582912 bytes");
    const std::string decimals = "0." + std::string(max_digits - 1, '7');
    EXPECT_THAT(first_error("P(v) -> P(" + decimals + ")^10000"), StartsWith("written out, this makes a line of 20"));
    const std::string half = "P(v) -> P(" + number + ")^9000\n";
    EXPECT_THAT(first_error(half + half), StartsWith("written out, this makes a text of 18"));
}

TEST(PointLimits, HostileTextsTakeLinearTimeAndSpace) {
    for (const std::string_view piece : {"-> ",         "E ",
                                         "E,",          "P(v)",
                                         "P(",          "(",
                                         ")",           "[",
                                         "]",           "v:",
                                         "<",           ">",
                                         "=",           "t=",
                                         "t=1,",        "f(x)=x,",
                                         "E->E,",       "E^9",
                                         "input P(v)|", "|",
                                         "\",",         "\"\\",
                                         "table p,",    "cycle p,",
                                         "axiom E,",    "interpretation,",
                                         "?Q",          "#",
                                         "1/2",         "1/2 v",
                                         "1.",          ".5",
                                         "min(",        "-",
                                         "not ",        "and ",
                                         "E:",          "P(v)->P(w),",
                                         "//\n",        "\xFF ",
                                         "\xCE\xB5"}) {
        const std::string text =
            "points\nP(v) -> P(v),axiom P(" + repeated(piece, (std::size_t{1} << 17) / piece.size());
        const ParsedPointGrammar parsed = parse_point_grammar(text, "t");
        EXPECT_LE(parsed.errors.size(), max_kept_errors + 1);
        const std::string bare = "points\n" + repeated(piece, (std::size_t{1} << 17) / piece.size());
        static_cast<void>(to_string(parse_point_grammar(bare, "t").errors));
    }
}

} // namespace internode
