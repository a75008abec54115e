// SPDX-License-Identifier: MIT

#include "internode/grammar/bundled.h"
#include "internode/point/compile/compile.h"
#include "internode/point/interpreter.h"
#include "tests/fixtures/stride.h"

#include "internode/point/start_word.h"
#include "tests/fixtures/point_systems.h"
#include "tests/fixtures/random_point_grammar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace internode {
namespace {

using tests::point_system;

/// Points without symmetries, all of about the size of 1.
std::vector<double> polygon(std::size_t count, std::size_t dimension) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<double> points(count * dimension);
    for (double& value : points) value = coordinate(random);
    return points;
}

void expect_same(const ModuleWord& fast, const ModuleWord& slow, const PointGrammar& grammar) {
    ASSERT_EQ(fast.size(), slow.size());
    for (std::size_t i = 0; i < slow.size(); ++i) {
        ASSERT_EQ(grammar.letters.name(fast.letter(i)), grammar.letters.name(slow.letter(i))) << i;
        ASSERT_EQ(fast.values(i).size(), slow.values(i).size());
        for (std::size_t k = 0; k < slow.values(i).size(); ++k)
            ASSERT_NEAR(fast.values(i)[k], slow.values(i)[k], 1e-14) << i << ' ' << k;
    }
}

/// Whether it compiled: then the words after 0 … `cycles` cycles are the interpreter's, letter by letter.
bool derives_the_same(const PointSystem& system, const ModuleWord& word, StartWord start, int cycles) {
    const Compilation compilation = compile(system, start);
    if (!compilation.compiled) return false;
    const std::vector<double> points = cell_points(word, system);
    const std::size_t dimension = points.size() / compilation.compiled->cells().size();
    for (int count = 0; count <= cycles; ++count) {
        SCOPED_TRACE(count);
        const Derivation slow = derive(system, word, static_cast<std::uint64_t>(count));
        EXPECT_FALSE(slow.problem);
        const std::optional<ModuleWord> fast = compilation.compiled->derive(points, dimension, count);
        const CompiledGrammar::WordSize size = compilation.compiled->size(static_cast<std::uint64_t>(count));
        EXPECT_EQ(size.points * dimension, cell_points(slow.word, system).size());
        EXPECT_EQ(fast.has_value(), size.points > 0);
        if (!fast) continue;
        EXPECT_EQ(size.modules, slow.word.size());
        expect_same(*fast, slow.word, system.grammar());
    }
    return true;
}

TEST(CompiledGrammar, DerivesTheInterpretersWordsForAllBundledGrammars) {
    std::set<std::string> compiled;
    for (const BundledGrammar& bundled : bundled_grammars()) {
        const ParsedPointGrammar parsed = parse_point_grammar(bundled.text, bundled.name);
        if (!parsed.grammar) continue; // of another kind
        for (const std::size_t dimension : {2, 3}) {
            SCOPED_TRACE(std::string(bundled.name));
            const CheckedPointSystem checked = make_point_system(*parsed.grammar, {.dimension = dimension});
            if (!checked.system) continue; // its axiom has points of another dimension
            const PointSystem& system = *checked.system;
            if (parsed.grammar->axiom) {
                if (derives_the_same(system, axiom_word(system), {}, 3)) compiled.emplace(bundled.name);
                continue;
            }
            for (std::size_t n = 2; n <= 9; n += tests::in_full() ? 1 : 3)
                if (derives_the_same(system, input_word(system, polygon(n, dimension)), {n}, 3))
                    compiled.emplace(bundled.name);
        }
    }
    for (const char* name : {"s0/13", "s0/22", "s0/25", "s0/28-33", "s0/34-36", "s1/8", "s1/10", "s1/17", "s1/19",
                             "four-point", "six-point", "lane-riesenfeld", "sierpinski", "kolam"})
        EXPECT_TRUE(compiled.contains(name)) << name;
}

TEST(CompiledGrammar, DerivesTheInterpretersWordsForRandomAffineGrammars) {
    std::mt19937 random(2010);
    for (int round = 0; round < tests::times(100, 20); ++round) {
        const std::string text = tests::random_affine_grammar(round % 2 == 0, random);
        SCOPED_TRACE(text);
        const PointSystem system = point_system(text);
        for (const std::size_t n : {1, 2, 3, 4, 6})
            EXPECT_TRUE(derives_the_same(system, input_word(system, polygon(n, 2)), {n}, 3));
    }
}

TEST(CompiledGrammar, DerivesTheInterpretersWordsForRandomRules) {
    // Rules that erase, that read numbers, edges and ends, in tables: most do not compile, as most travel too far.
    const auto grammars = static_cast<unsigned>(tests::times(1000, 50));
    unsigned compiled = 0;
    for (unsigned seed = 0; seed < grammars; ++seed) {
        const std::string text = tests::RandomPointGrammar(seed, tests::Drawn::Local).text();
        SCOPED_TRACE(text);
        const PointSystem system = point_system(text);
        if (derives_the_same(system, axiom_word(system), {}, 3)) ++compiled;
    }
    EXPECT_GT(compiled, grammars / 15);
}

TEST(CompiledGrammar, KeepsModulesWithoutPointsAndNumbers) {
    const PointSystem system =
        point_system("points\nring\ninput E P(v, 1) F(2)\n"
                     "P(v, s) > F(t) E P(w, u) : s < 3 -> G P(1/2 v + 1/2 w, s + 1) F(t) E P(w, 0)\n"
                     "P(v, s) -> P(v, 0)\nG -> .\n",
                     {});
    EXPECT_TRUE(derives_the_same(system, input_word(system, polygon(4, 2)), {std::size_t{4}}, 4));
}

TEST(CompiledGrammar, LeavesWordsWithoutPointsToTheInterpreter) {
    for (const char* rules : {"input P(v) E\nP(v) -> E\n", "input # P(v) #\n# < P(v) -> .\nP(v) > # -> .\n",
                              "input P(v)\nP(v) -> .\n", "ring\ninput E P(v)\nE < P(v) > E -> E\n"}) {
        SCOPED_TRACE(rules);
        const PointSystem system = point_system(std::string("points\n") + rules);
        for (const std::size_t n : {1, 2, 3, 5})
            (void)derives_the_same(system, input_word(system, polygon(n, 2)), {n}, 3);
    }
}

TEST(CompiledGrammar, DoesNotDecideWhereDoublesRound) {
    // Ten times 1/10 is 1 for exact numbers, and not for doubles, which the interpreter has.
    for (const char* rules :
         {"input P(v, 0)\nP(v, s) : s < 1 -> P(v, s + 1/10)\nP(v, s) : s == 1 -> P(v, 0) P(v, 0)\n",
          "input P(v, 1/10)\nP(v, s) : 3 s == 3/10 -> P(v, s) P(v, s)\n",
          "input P(v, 1)\nP(v, s) : 10000000000000000 s + 1 > 10000000000000000 s -> P(v, s) P(v, s)\n"}) {
        const Compilation compilation = compile(point_system(std::string("points\nring\n") + rules), {many_points});
        ASSERT_FALSE(compilation.compiled) << rules;
        EXPECT_NE(compilation.reasons.front().reason.find("computes with numbers that doubles round"),
                  std::string::npos)
            << compilation.reasons.front().reason;
    }
}

TEST(CompiledGrammar, CountsItsModulesBeforeItMakesThem) {
    const PointSystem system = point_system("points\nring\ninput P(v) E\nP(v) > E -> P(v) E^40 P(v) E^40\nE -> .\n");
    const CompiledGrammar grammar = compile(system, {4}).compiled.value();
    EXPECT_EQ(grammar.size(3).points, 32U);
    EXPECT_EQ(grammar.size(3).modules, 32U * 41U);
    EXPECT_EQ(grammar.size(1'000).modules, std::uint64_t{1} << 62);
}

TEST(CompiledGrammar, RefusesAnotherNumberOfPoints) {
    const Compilation compilation = compile(tests::bundled_system("s0/13"), {4});
    EXPECT_THROW((void)compilation.compiled->derive(polygon(5, 2), 2, 1), std::invalid_argument);
}

} // namespace
} // namespace internode
