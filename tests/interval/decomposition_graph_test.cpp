// SPDX-License-Identifier: MIT

#include "internode/interval/decomposition_graph.h"

#include "internode/interval/validity.h"
#include "tests/fixtures/interval_grammars.h"
#include "tests/fixtures/interval_systems.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace internode {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using tests::fibonacci_grammar;
using tests::make_grammar;
using tests::system_of;
using tests::with_axiom;

constexpr std::size_t plenty = 100'000;

TEST(DecompositionGraph, FibonacciHasDPlusTwoPersistentWordsAndTwoDWindows) {
    const IntervalSystem system = system_of(fibonacci_grammar());
    for (std::size_t d = 1; d <= 8; ++d) {
        EXPECT_THAT(word_graph(system, d + 1, WordChoice::Default, plenty).words, SizeIs(d + 2));
        EXPECT_THAT(word_graph(system, 2 * d - 1, WordChoice::Persistent, plenty).words, SizeIs(2 * d));
    }
}

TEST(DecompositionGraph, ArcsLeadToTheFactorsOfTheImage) {
    const IntervalSystem system = system_of(with_axiom(fibonacci_grammar(), "L L S S L", Ends::Circular));
    const FactorGraph graph = word_graph(system, 3, WordChoice::Default, plenty);
    for (std::size_t v = 0; v < graph.words.size(); ++v) {
        const std::vector<Word> images = windows(system.rules()(graph.words[v]), 3, Ends::Open);
        ASSERT_EQ(images.size(), graph.arcs[v].size());
        for (std::size_t i = 0; i < images.size(); ++i) EXPECT_EQ(graph.words[graph.arcs[v][i]], images[i]);
    }
    for (const Word& window : windows(system.grammar().axiom->word, 3, Ends::Circular))
        EXPECT_EQ(std::ranges::count(graph.words, window), 1) << "transient words of the axiom are kept";
}

TEST(DecompositionGraph, AnAxiomBringsTransientWords) {
    // Closed SSSSS, d = 3: the six persistent windows and three transient ones.
    const IntervalSystem system = system_of(with_axiom(fibonacci_grammar(), "S S S S S", Ends::Circular));
    const FactorGraph graph = word_graph(system, 5, WordChoice::Default, plenty);
    EXPECT_THAT(graph.words, SizeIs(9));
    EXPECT_EQ(std::ranges::count(graph.persistent, true), 6);
}

TEST(DecompositionGraph, WindowsOfZerosOnlyAreLeftOut) {
    const IntervalSystem system = system_of(with_axiom(fibonacci_grammar(), "0 0 0 L S 0 0 0"));
    const FactorGraph graph = word_graph(system, 3, WordChoice::Default, plenty);
    EXPECT_EQ(std::ranges::count(graph.words, Word(3, zero_interval)), 0);
    EXPECT_EQ(std::ranges::count(graph.words, (Word{zero_interval, zero_interval, Symbol{0}})), 1);
    const IntervalSystem tiny = system_of(with_axiom(fibonacci_grammar(), "L S"));
    EXPECT_THAT(word_graph(tiny, 3, WordChoice::Default, plenty).words, IsEmpty()) << "shorter than a window";
}

TEST(DecompositionGraph, SymbolsThatCannotOccurAreInNoWord) {
    const IntervalGrammar stuck = make_grammar({{"X", "X"}, {"L", "S L"}, {"S", "L"}});
    const IntervalSystem system = system_of(with_axiom(stuck, "L"));
    const FactorGraph persistent = word_graph(system, 2, WordChoice::Persistent, plenty);
    EXPECT_THAT(persistent.words, SizeIs(3));
    const FactorGraph all = word_graph(system, 2, WordChoice::All, plenty);
    EXPECT_THAT(all.words, SizeIs(4));
    for (const Word& word : all.words) EXPECT_EQ(std::ranges::count(word, Symbol{0}), 0);
}

TEST(DecompositionGraph, RefusesWhatItCannotAnswer) {
    const IntervalSystem system = system_of(fibonacci_grammar());
    EXPECT_THROW((void)word_graph(system, 0, WordChoice::Default, plenty), std::invalid_argument);
    EXPECT_THROW((void)word_graph(system, 2, WordChoice::Reachable, plenty), std::invalid_argument);
    EXPECT_THROW((void)word_graph(system, 3, WordChoice::All, 7), TooManyWords);
    EXPECT_THROW((void)word_graph(system, 3, WordChoice::Persistent, 3), TooManyWords);
}

} // namespace
} // namespace internode
