// SPDX-License-Identifier: MIT
//
// subdivide with point grammars: the results beside the bundled grammars, every option, every refusal.

#include "tests/cli/command.h"

#include "internode/grammar/bundled.h"
#include "internode/text/number.h"
#include "tests/fixtures/source_folder.h"
#include "tests/fixtures/texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace internode::tests {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace fs = std::filesystem;

std::vector<fs::path> files_of_grammars(const std::string& extension) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(tests::in_source_folder("data/grammars")))
        if (entry.path().extension() == extension) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::vector<std::string> lines_in(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
}

class PointCommands : public testing::Test {
protected:
    Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "subdivide");
        return here.run(arguments);
    }
    std::string out(const std::vector<std::string>& arguments) const {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    }
    void refuses(const std::vector<std::string>& arguments, int code, const std::string& message) const {
        expect_refused(run(arguments), arguments, message, code);
    }
    const std::string pebble = "data/curves/pebble.csv";
    Workspace here;
};

TEST_F(PointCommands, GiveTheResultsBesideTheGrammars) {
    const std::vector<fs::path> files = files_of_grammars(".expected");
    ASSERT_GE(files.size(), 25U);
    for (const fs::path& file : files) {
        const std::string text = content(file);
        const auto end = text.find('\n');
        const std::string prompt = "$ internode ";
        ASSERT_THAT(text, StartsWith(prompt)) << file;
        const Outcome outcome = here.run(split(text.substr(prompt.size(), end - prompt.size())));
        EXPECT_EQ(outcome.out, text.substr(end + 1)) << file << outcome.err;
        EXPECT_EQ(outcome.err, "") << file;
    }
}

TEST_F(PointCommands, EveryNumberedProductionHasItsResult) {
    for (const fs::path& grammar : files_of_grammars(".lsys")) {
        const std::string folder = grammar.parent_path().filename().string();
        if (folder != "s0" && folder != "s1") continue;
        fs::path expected = grammar;
        EXPECT_TRUE(fs::exists(expected.replace_extension(".expected"))) << grammar;
    }
}

TEST_F(PointCommands, EveryBundledPointGrammarRuns) {
    for (const char* name : {"koch", "sierpinski", "kolam", "branching", "branching-smooth", "rational-arc"})
        EXPECT_THAT(out({std::string("@") + name, "-n", "1"}), StartsWith("x,y\n")) << name;
    for (const char* name : {"midpoint-displacement", "asked-cutting", "koch", "lane-riesenfeld", "four-point"})
        EXPECT_EQ(lines_in(out({std::string("@") + name, pebble, "-n", "0"})).size(), 7U) << name;
}

/// All numbers of a text, in their order.
std::vector<double> numbers(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return std::strchr("0123456789.-+e", c) == nullptr; }, ' ');
    std::istringstream stream(text);
    std::vector<double> result;
    for (std::string word; stream >> word;)
        if (const auto number = parse_double(word)) result.push_back(*number);
    return result;
}

TEST_F(PointCommands, CompiledAndInterpretedWordsAgree) {
    std::size_t compiled = 0;
    for (const BundledGrammar& grammar : bundled_grammars(GrammarKind::Points)) {
        const std::string name(grammar.name);
        std::vector<std::string> arguments{"@" + name, "-n", "3", "--format", "text"};
        if (grammar.text.find("\naxiom") == std::string_view::npos) arguments.insert(arguments.begin() + 1, pebble);
        std::vector<std::string> asked = arguments;
        asked.emplace_back("--plan");
        if (name == "s1/18" || name == "s1/20-21" || name == "s0/38") continue; // they ask for a polygon of their own
        compiled += out(asked).find("compiled to") != std::string::npos ? 1U : 0U;
        const std::vector<double> fast = numbers(out(arguments));
        arguments.emplace_back("--interpreter");
        const std::vector<double> slow = numbers(out(arguments));
        ASSERT_EQ(fast.size(), slow.size()) << name;
        for (std::size_t i = 0; i < fast.size(); ++i)
            EXPECT_NEAR(fast[i], slow[i], 1e-14 * std::max(1.0, std::abs(slow[i]))) << name;
    }
    EXPECT_GE(compiled, 20U);
}

TEST_F(PointCommands, TraceTheWordsOfThePapers) {
    EXPECT_THAT(lines_in(out({"@s0/11", "-n", "1", "--trace"})),
                ElementsAre("A(1.5) B(2, 3) A(4.5)", "A(4) A(3.5) A(7.5) A(10)"));
    EXPECT_EQ(lines_in(out({"@s1/2", "-n", "1", "--trace"})).back(), "A(4) A(3.5) A(7.5) B(10) C(1)");
    EXPECT_EQ(out({"@s1/2", "-n", "1"}), "A(4) A(3.5) A(7.5) B(10) C(1)\n") << "a word without points is text";
    EXPECT_EQ(lines_in(out({"@s1/10", "data/curves/square.csv", "-n", "1", "--trace"})).size(), 3U) << "p, then q";
}

TEST_F(PointCommands, WordsOfTwoGrammarsAreEqualLetterByLetter) {
    const auto word = [this](const char* name) { return out({name, pebble, "-n", "3", "--format", "text"}); };
    EXPECT_EQ(word("@s1/8"), word("@s1/10"));
    EXPECT_EQ(word("@s0/13"), word("@s1/7"));
    EXPECT_EQ(word("@s0/28-33"), word("@s0/34-36"));
}

TEST_F(PointCommands, ReverseChaikinUndoesChaikinInPhaseZero) {
    const std::string coarse = out({"@s0/13", pebble, "-n", "0"});
    here.file("fine.csv", out({"@s0/13", pebble, "-n", "2"}));
    EXPECT_EQ(out({"@s0/38", "fine.csv", "-n", "2"}), coarse);
    EXPECT_EQ(out({"@s0/38", "fine.csv", "-n", "2", "--phase", "0"}), coarse);
    EXPECT_NE(out({"@s0/38", "fine.csv", "-n", "1", "--phase", "1"}), out({"@s0/13", pebble, "-n", "1"}));
    here.file("odd.csv", "0,0\n1,0\n1,1\n");
    refuses({"@s0/38", "odd.csv", "-n", "1"}, 3, "@s0/38:");
}

TEST_F(PointCommands, ConstantsAreSetExactly) {
    const std::string chaikin = out({"@s0/13", pebble, "-n", "2"});
    EXPECT_EQ(out({"@corner-cutting", pebble, "-n", "2", "--set", "a=1/4"}), chaikin);
    EXPECT_EQ(out({"@corner-cutting", pebble, "-n", "2", "--set", "a=0.25"}), chaikin);
    EXPECT_NE(out({"@corner-cutting", pebble, "-n", "2"}), chaikin);
    EXPECT_EQ(lines_in(out({"@lane-riesenfeld", pebble, "-n", "1", "--set", "n=0", "--trace"})).size(), 2U);
    EXPECT_EQ(lines_in(out({"@lane-riesenfeld", pebble, "-n", "1", "--set", "n=5", "--trace"})).size(), 7U);
    refuses({"@corner-cutting", pebble, "-n", "1", "--set", "b=1"}, 2, "no constant `b`");
    refuses({"@corner-cutting", pebble, "-n", "1", "--set", "a"}, 2, "NAME=VALUE");
    refuses({"@corner-cutting", pebble, "-n", "1", "--set", "a=1/0"}, 2, "`1/0` is no number");
    refuses({"@corner-cutting", pebble, "-n", "1", "--set", "a=1", "--set", "a=2"}, 2, "twice");
    refuses({"@lane-riesenfeld", pebble, "-n", "1", "--set", "n=1/2"}, 3, "@lane-riesenfeld:");
    refuses({"@lane-riesenfeld", pebble, "-n", "1", "--set", "n=-1"}, 3, "@lane-riesenfeld:");
}

TEST_F(PointCommands, QueriesAreAnswered) {
    EXPECT_EQ(out({"@asked-cutting", pebble, "-n", "2", "--query", "C=1/4"}), out({"@s0/13", pebble, "-n", "2"}));
    EXPECT_EQ(out({"@asked-cutting", pebble, "-n", "2"}),
              out({"@asked-cutting", pebble, "-n", "2", "--query", "C=1/3"}));
    refuses({"@asked-cutting", pebble, "-n", "1", "--query", "D=1"}, 2, "no query module `D`");
    refuses({"@asked-cutting", pebble, "-n", "1", "--query", "C=1,2"}, 2, "no ?C has 2 numbers");
    refuses({"@asked-cutting", pebble, "-n", "1", "--query", "C=1,"}, 2, "is no number");
    refuses({"@s0/13", pebble, "-n", "1", "--query", "C=1"}, 2, "it has none");
}

TEST_F(PointCommands, ASeedDecidesEverything) {
    const auto coast = [this](const std::string& seed) {
        return out({"@midpoint-displacement", pebble, "-n", "4", "--seed", seed});
    };
    EXPECT_EQ(coast("1"), coast("1"));
    EXPECT_EQ(coast("0"), out({"@midpoint-displacement", pebble, "-n", "4"}));
    EXPECT_NE(coast("1"), coast("2"));
    EXPECT_EQ(lines_in(coast("7")).size(), 6U * 16 + 1);
}

TEST_F(PointCommands, WordsThatExplodeAreRefused) {
    refuses({"@s0/13", pebble, "-n", "99999"}, 3, "10000000");
    refuses({"@s0/13", pebble, "-n", "3", "--max-modules", "47"}, 3, "48");
    EXPECT_EQ(lines_in(out({"@s0/13", pebble, "-n", "3", "--max-modules", "48"})).size(), 49U);
    refuses({"@s0/13", pebble, "-n", "99", "--svg"}, 3, "--max-modules");
    refuses({"@s0/13", pebble, "-n", "99", "--trace"}, 3, "--max-modules");
    refuses({"@s0/13", pebble, "-n", "18446744073709551615"}, 3, "cycles");
    refuses({"-e", "points g; axiom A(0); A(x) -> A(x)^1000", "-n", "9"}, 3, "10000000");
    refuses({"@s0/13", pebble, "-n", "9", "--tree"}, 3, "a tree shows");
}

TEST_F(PointCommands, WhatADerivationMeetsHasItsPlace) {
    here.file("zero.lsys", "points zero\nring\n\nP(v) -> P(1/(v.x - v.x) v)\n");
    const Outcome outcome = run({"zero.lsys", pebble, "-n", "1"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, AllOf(StartsWith("zero.lsys:4:"), HasSubstr("error: "), HasSubstr("^")));
    here.file("grows.lsys", "points grows\nring\nP(v) -> P(1000000 v)\n");
    refuses({"grows.lsys", pebble, "-n", "60"}, 3, "grows.lsys:3:");
    here.file("mixed.lsys", "points mixed\nP(v) -> P(v + 1)\n");
    refuses({"mixed.lsys", pebble, "-n", "1"}, 3, "mixed.lsys:2:");
    here.file("broken.lsys", "points broken\nP(v) -> P(\n");
    refuses({"broken.lsys", pebble, "-n", "1"}, 3, "broken.lsys:");
}

TEST_F(PointCommands, OptionsOfTheOtherKindAreRefused) {
    for (const std::vector<std::string>& option : {std::vector<std::string>{"-d", "2"},
                                                   {"--word", "LS"},
                                                   {"--repeat"},
                                                   {"--closed"},
                                                   {"--open"},
                                                   {"--clamped"},
                                                   {"--limit"},
                                                   {"--derivatives"}}) {
        std::vector<std::string> arguments{"@s0/13", pebble, "-n", "1"};
        arguments.insert(arguments.end(), option.begin(), option.end());
        refuses(arguments, 2, option.front() + " belongs to interval grammars");
    }
    for (const std::vector<std::string>& option : {std::vector<std::string>{"--set", "t=1"},
                                                   {"--query", "C=1"},
                                                   {"--phase", "1"},
                                                   {"--seed", "1"},
                                                   {"--max-modules", "9"},
                                                   {"--trace"},
                                                   {"--tree"},
                                                   {"--interpreter"}}) {
        std::vector<std::string> arguments{"@fibonacci", pebble,     "-n",     "1", "-d",
                                           "2",          "--closed", "--word", "L", "--repeat"};
        arguments.insert(arguments.end(), option.begin(), option.end());
        refuses(arguments, 2, option.front() + " belongs to point grammars");
    }
    refuses({"--u", "@fibonacci", "--v", "@fibonacci", "data/grids/wave.json", "-n", "1", "--trace"}, 2,
            "--trace belongs");
    refuses({"@s0/13", pebble, "-n", "1", "--trace", "--tree"}, 2, "exclude");
    refuses({"@s0/13", pebble, "-n", "1", "--trace", "-o", "x.csv"}, 2, "csv");
    refuses({"@s0/13", pebble, "-n", "1", "--tree", "--json"}, 2, "svg");
    refuses({"@s0/13", pebble, "-n", "1", "-o", "x.ply"}, 2, "ply");
}

TEST_F(PointCommands, PolygonsAndWordsMustAgree) {
    refuses({"@s0/13", "-n", "1"}, 2, "no control polygon");
    refuses({"@s0/13", "nowhere.csv", "-n", "1"}, 4, "nowhere.csv");
    here.file("closed.csv", "0,0\n1,0\n1,1\n0,0\n");
    refuses({"@s0/13", "closed.csv", "-n", "1"}, 3, "repeats the first");
    here.file("pair.csv", "0,0\n0,0\n");
    refuses({"@s0/13", "pair.csv", "-n", "1"}, 3, "the last of the 2 points of pair.csv repeats the first");
    EXPECT_EQ(run({"@s0/34-36", "closed.csv", "-n", "1"}).code, 0);
    here.file("ring.json", R"({"points": [[0,0],[1,0],[1,1],[0,1]], "closed": true})");
    EXPECT_EQ(run({"@s0/13", "ring.json", "-n", "1"}).code, 0);
    refuses({"@s0/34-36", "ring.json", "-n", "1"}, 3, "\"closed\"");
    refuses({"@s0/11", "-n", "1", "--json"}, 3, "--format text");
    refuses({"@s0/11", pebble, "-n", "1"}, 3, "@s0/11: error: nothing says what the points of a polygon become");
    refuses({"@s0/13", pebble, "-n", "1", "--axes", "1,3", "--svg"}, 2, "--axes");
}

TEST_F(PointCommands, WeightsAreDividedOutLast) {
    const std::string arc = "data/curves/arc.csv";
    EXPECT_EQ(lines_in(out({"@s0/34-36", arc, "-n", "0", "--rational"})),
              (std::vector<std::string>{"x,y,w", "0,0,1", "1,2,0.5", "2,0,1"}));
    EXPECT_THAT(out({"@s0/34-36", arc, "-n", "1", "--rational", "--json"}), HasSubstr("\"weights\": [1, "));
    EXPECT_EQ(lines_in(out({"@s1/20-21", arc, "-n", "2", "--rational"})).front(), "x,y") << "the grammar has projected";
    here.file("far.csv", "0,0,1\n1,2,9\n2,0,1\n3,1,1\n");
    refuses({"@four-point", "far.csv", "-n", "2", "--rational", "--set", "w=2"}, 3, "weight of point");
    here.file("turned.csv", "0,0,1\n4,0,3\n4,3,1\n");
    refuses({"-e", "points; ring; P(u) < P(v) -> P(2 v - u)", "turned.csv", "-n", "1", "--rational"}, 3,
            "the weight of point 3 has become -1");
}

/// Weights of 9 and 1 leave almost nothing between them under the four-point rule.
TEST_F(PointCommands, QuotientsBeyondDoublesAreRefused) {
    here.file("thin.csv", "1e305,8.999999999999998\n1e306,1\n1e306,1\n2e305,8.999999999999998\n");
    for (const char* format : {"csv", "json", "obj", "npy", "svg"})
        refuses({"@four-point", "thin.csv", "-n", "1", "--rational", "--format", format}, 3,
                "divided by its weight, is larger than every double");
}

TEST_F(PointCommands, RationalArcsLieOnConics) {
    for (const auto& [weight, w] : std::vector<std::pair<std::string, double>>{{"1/2", 0.5}, {"1", 1}, {"5/2", 2.5}}) {
        std::istringstream rows(out({"@rational-arc", "-n", "5", "--set", "w=" + weight}));
        std::string row;
        std::getline(rows, row);
        std::size_t count = 0;
        for (; std::getline(rows, row); ++count) {
            const std::size_t comma = row.find(',');
            ASSERT_NE(comma, std::string::npos) << row;
            const double x = parse_double(row.substr(0, comma)).value();
            const double y = parse_double(row.substr(comma + 1)).value();
            // The control points (0,0), (1/2,1), (1,0): barycentric weights a, b, c with b² = 4 w² a c.
            const double b = y;
            const double c = x - b / 2;
            const double a = 1 - b - c;
            if (count % 2 == 0) {
                EXPECT_NEAR(b * b, 4 * w * w * a * c, 1e-12) << weight << ' ' << row;
            }
        }
        EXPECT_EQ(count, 65U);
    }
}

TEST_F(PointCommands, WriteEveryFormat) {
    EXPECT_THAT(out({"@s0/13", pebble, "-n", "1", "--json"}),
                AllOf(HasSubstr("\"format\": \"internode-points\""), HasSubstr("\"closed\": true"),
                      HasSubstr("\"cycles\": 1")));
    EXPECT_THAT(out({"@s0/13", "data/curves/square.csv", "-n", "0", "--format", "obj"}), HasSubstr("\nl 1 2 3 4 1\n"));
    const std::string tree = out({"@branching", "-n", "1", "--format", "obj"});
    EXPECT_GE(std::ranges::count(lines_in(tree), 'l', [](const std::string& line) { return line.front(); }), 2) << tree;
    EXPECT_THAT(out({"@s1/9", "data/curves/square.csv", "-n", "0", "--format", "obj"}), HasSubstr("\nl 5 6\n"));
    EXPECT_THAT(out({"@s0/13", pebble, "-n", "1", "--format", "npy"}), StartsWith("\x93NUMPY"));
    EXPECT_THAT(out({"@s0/13", pebble, "-n", "2", "--svg"}),
                AllOf(HasSubstr("level 2: 24 points"), HasSubstr("pebble.csv")));
    EXPECT_THAT(out({"@s1/13", "data/curves/bezier-4.csv", "-n", "4", "--tree"}), HasSubstr("step 4"));
    EXPECT_EQ(run({"@s0/13", pebble, "-n", "2", "-o", "levels.svg"}).code, 0);
    EXPECT_THAT(here.read("levels.svg"), AllOf(HasSubstr("<svg"), Not(HasSubstr("levels.svg"))));
    EXPECT_THAT(out({"@s0/13", pebble, "-n", "5", "--plan"}), HasSubstr("modules 192\n"));
}

TEST_F(PointCommands, NamesOfAUserAreInert) {
    here.file("<b>&.csv", "0,0\n1,0\n1,1\n");
    for (const char* option : {"--svg", "--tree", "--json"}) {
        const std::string text = out({"-e", "points \"<i>&\"; ring; P(v) -> P(v)", "<b>&.csv", "-n", "1", option});
        EXPECT_THAT(text, Not(HasSubstr("<b>"))) << option;
        EXPECT_THAT(text, Not(HasSubstr("<i>"))) << option;
    }
}

TEST_F(PointCommands, WarnsInOneLineOfSumsThatAreNotOne) {
    const std::string grammar =
        here.file("shrinking.lsys", "points\nring\nP(u) < P(v) -> P(0.99 v) P(1/2 u + 1/2 v)\n");
    const std::string polygon = here.file("square.csv", "0,0\n1,0\n1,1\n0,1\n");
    const Outcome warned = run({grammar, polygon, "-n", "1"});
    EXPECT_EQ(warned.code, 0);
    EXPECT_EQ(warned.err, "warning: shrinking.lsys:3:18: the coefficients of a point sum to 99/100, not to 1; see "
                          "`internode validate`\n");
    const Outcome quiet = run({grammar, polygon, "-n", "1", "-q"});
    EXPECT_EQ(quiet.err, "");
    EXPECT_EQ(quiet.out, warned.out);
    EXPECT_EQ(run({"@s0/13", polygon, "-n", "1"}).err, "");
    const std::string worse = here.file("worse.lsys", "points\nring\nP(u) < P(v) -> P(0.99 v) P(1/2 u + v) P(2 v)\n");
    EXPECT_THAT(run({worse, polygon, "-n", "1"}).err, HasSubstr("99/100, not to 1, and 2 more like it; see"));
}

TEST_F(PointCommands, RefuseContextsWithEndMarkersThatNothingMakes) {
    const std::string rules = "P(u) < P(v) -> P(1/2 u + 1/2 v) P(v)\n# < P(v) -> P(v)\n";
    const std::string without = here.file("without.lsys", "points\n" + rules);
    const std::string with = here.file("with.lsys", "points\ninput # P(v) #\n" + rules);
    const std::string polygon = here.file("corner.csv", "0,0\n1,0\n1,1\n");
    const Outcome refused = run({without, polygon, "-n", "1"});
    EXPECT_EQ(refused.code, 3);
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("without.lsys:3:1: error: a context with `#`, which nothing puts into a word"),
                      HasSubstr("hint: `input # P(v) #` puts one at each end of a polygon")));
    EXPECT_EQ(run({with, polygon, "-n", "1"}).code, 0);
    EXPECT_EQ(here.run({"validate", without}).code, 1);
    EXPECT_EQ(here.run({"validate", with}).code, 0);
}

} // namespace
} // namespace internode::tests
