// SPDX-License-Identifier: MIT

#include "internode/grammar/bundled.h"

#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/points/parse_points.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace internode {

namespace {

IntervalGrammar bundled(std::string_view name) {
    const BundledGrammar* found = find_bundled_grammar(name);
    EXPECT_NE(found, nullptr) << name;
    const ParsedGrammar parsed = parse_grammar(found->text, name);
    EXPECT_TRUE(parsed.grammar) << to_string(parsed.errors);
    return *parsed.grammar;
}

std::vector<std::string> rules(std::string_view name) {
    const IntervalGrammar grammar = bundled(name);
    std::vector<std::string> result;
    for (std::size_t i = 0; i < grammar.alphabet.size(); ++i)
        result.push_back(grammar.alphabet.names()[i] + "->" + to_string(grammar.rules.images()[i], grammar.alphabet));
    return result;
}

/// The coefficients of det(x - M), low degree first, by Faddeev and LeVerrier.
std::vector<long> characteristic_polynomial(const IntervalGrammar& grammar) {
    const std::size_t n = grammar.alphabet.size();
    std::vector<std::vector<long>> m(n, std::vector<long>(n));
    for (std::size_t i = 0; i < n; ++i)
        for (const Symbol symbol : grammar.rules.images()[i]) ++m[i][to_index(symbol)];
    std::vector<std::vector<long>> b(n, std::vector<long>(n));
    std::vector<long> coefficients(n + 1);
    coefficients[n] = 1;
    for (std::size_t k = 1; k <= n; ++k) {
        for (std::size_t i = 0; i < n; ++i) b[i][i] += coefficients[n - k + 1];
        std::vector<std::vector<long>> product(n, std::vector<long>(n));
        long trace = 0;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j)
                for (std::size_t l = 0; l < n; ++l) product[i][j] += m[i][l] * b[l][j];
            trace += product[i][i];
        }
        coefficients[n - k] = -trace / static_cast<long>(k);
        b = product;
    }
    return coefficients;
}

} // namespace

TEST(Bundled, EveryTextNamesItsSourceAndItself) {
    ASSERT_GE(bundled_grammars(GrammarKind::Intervals).size(), 19u);
    for (const BundledGrammar& grammar : bundled_grammars(GrammarKind::Intervals)) {
        EXPECT_TRUE(grammar.text.starts_with("// source: ")) << grammar.name;
        EXPECT_EQ(bundled(grammar.name).name, grammar.name);
        EXPECT_EQ(bundled(grammar.name).axiom, std::nullopt) << "the papers print none";
    }
}

TEST(Bundled, EveryPointGrammarNamesItsSourceAndItself) {
    ASSERT_GE(bundled_grammars(GrammarKind::Points).size(), 20u);
    for (const BundledGrammar& grammar : bundled_grammars(GrammarKind::Points)) {
        EXPECT_TRUE(grammar.text.starts_with("// source: ")) << grammar.name;
        EXPECT_EQ(kind_of(grammar.text), GrammarKind::Points) << grammar.name;
        const ParsedPointGrammar parsed = parse_point_grammar(grammar.text, grammar.name);
        ASSERT_TRUE(parsed.grammar) << to_string(parsed.errors);
        EXPECT_EQ(parsed.grammar->name, grammar.name);
    }
}

TEST(Bundled, NamesAreSortedAndFound) {
    EXPECT_TRUE(std::ranges::is_sorted(bundled_grammars(), {}, &BundledGrammar::name));
    EXPECT_EQ(find_bundled_grammar("fibonaci"), nullptr);
    EXPECT_EQ(find_bundled_grammar(""), nullptr);
    EXPECT_NE(find_bundled_grammar("s0/13"), nullptr);
}

TEST(Bundled, TheSystemsOfThePaperAreAsPrinted) {
    using testing::ElementsAre;
    EXPECT_THAT(rules("fibonacci"), ElementsAre("L->SL", "S->L"));
    EXPECT_THAT(rules("bisection"), ElementsAre("A->AA"));
    EXPECT_THAT(rules("sederberg"), ElementsAre("A1->A1 A1", "A2->A2 A2"));
    EXPECT_THAT(rules("s4-not-connected"), ElementsAre("A1->A1 A2", "A2->A2 A2 A2"));
    EXPECT_THAT(rules("s4-invalid-length-zero"), ElementsAre("A1->A1 A1 A2", "A2->A2"));
    EXPECT_THAT(rules("s4-invalid-no-growth"), ElementsAre("A1->A2", "A2->A1"));
    for (const std::size_t n : {2u, 3u, 4u, 8u, 12u}) {
        std::vector<std::string> expected{fmt::format("A1->A{0} A{0}", n)};
        for (std::size_t i = 2; i <= n; ++i) expected.push_back(fmt::format("A{}->A{}", i, i - 1));
        EXPECT_EQ(rules(fmt::format("slow-growth-{}", n)), expected);
    }
}

TEST(Bundled, TheClassicalSystemsHaveTheirPolynomials) {
    using testing::ElementsAre;
    EXPECT_THAT(characteristic_polynomial(bundled("plastic")), ElementsAre(-1, -1, 0, 1));
    EXPECT_THAT(characteristic_polynomial(bundled("tribonacci")), ElementsAre(-1, -1, -1, 1));
    EXPECT_THAT(characteristic_polynomial(bundled("silver-mean")), ElementsAre(-1, -2, 1));
    EXPECT_THAT(characteristic_polynomial(bundled("bronze-mean")), ElementsAre(-1, -3, 1));
    EXPECT_THAT(characteristic_polynomial(bundled("thue-morse")), ElementsAre(0, -2, 1));
    EXPECT_THAT(characteristic_polynomial(bundled("period-doubling")), ElementsAre(-2, -1, 1));
    EXPECT_THAT(characteristic_polynomial(bundled("trisection")), ElementsAre(-3, 1));
}

} // namespace internode
