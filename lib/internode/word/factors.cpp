// SPDX-License-Identifier: MIT
//
// Words are numbered as they arrive, breadth first; a vertex is persistent when it is on a cycle or behind one, which
// the strong components of the graph tell. Words of length m grow from the persistent pairs, not from all n^m words.

#include "internode/word/factors.h"

#include "internode/word/graph.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <unordered_map>

namespace internode {

namespace {

/// The words seen so far, numbered in the order of their arrival.
class WordIndex {
public:
    explicit WordIndex(std::size_t limit)
        : limit_(limit) {}

    std::uint32_t add(const Word& word) {
        const auto [place, is_new] = numbers_.try_emplace(word, static_cast<std::uint32_t>(words_.size()));
        if (is_new) {
            if (words_.size() >= limit_) throw TooManyWords("more than " + std::to_string(limit_) + " words");
            words_.push_back(word);
        }
        assert(place->second < words_.size());
        return place->second;
    }
    [[nodiscard]] const std::vector<Word>& words() const { return words_; }
    std::vector<Word> take() { return std::move(words_); }

private:
    std::size_t limit_;
    std::unordered_map<Word, std::uint32_t, WordHash> numbers_;
    std::vector<Word> words_;
};

/// Every node on a cycle or reachable from one.
std::vector<bool> recurrent(const Graph& graph) {
    const StrongComponents components = strong_components(graph);
    std::vector<std::uint32_t> start;
    for (std::uint32_t node = 0; node < graph.size(); ++node)
        if (components.cyclic[components.component[node]]) start.push_back(node);
    return reachable(graph, start);
}

/// Whether |σ^k(a)| is unbounded for every letter a: the letter produces one that splits and comes back. No letter
/// vanishes, so what is split off stays.
bool every_letter_grows(const Morphism& morphism) {
    const std::size_t n = morphism.size();
    Graph products(n);
    Graph producers(n);
    for (std::uint32_t letter = 0; letter < n; ++letter) {
        for (const Symbol symbol : morphism.images()[letter]) {
            const auto product = static_cast<std::uint32_t>(to_index(symbol));
            products[letter].push_back(product);
            producers[product].push_back(letter);
        }
    }
    const StrongComponents components = strong_components(products);
    std::vector<std::uint32_t> growing;
    for (std::uint32_t letter = 0; letter < n; ++letter)
        if (products[letter].size() > 1 && components.cyclic[components.component[letter]]) growing.push_back(letter);
    return std::ranges::all_of(reachable(producers, growing), [](bool value) { return value; });
}

/// P2: the pairs of letters that occur after arbitrarily many steps, whatever the axiom.
std::vector<Word> persistent_pairs(const Morphism& morphism, std::size_t limit) {
    const FactorGraph graph = factor_graph(morphism, all_words(morphism.size(), 2, limit), limit);
    std::vector<Word> pairs;
    for (std::size_t i = 0; i < graph.words.size(); ++i)
        if (graph.persistent[i]) pairs.push_back(graph.words[i]);
    return pairs;
}

} // namespace

std::vector<Word> windows(WordView word, std::size_t m, Ends ends) {
    if (m == 0) throw std::invalid_argument("a window has at least one letter");
    const std::size_t fitting = word.size() < m ? 0 : word.size() - m + 1;
    std::vector<Word> result(ends == Ends::Open ? fitting : word.size(), Word(m));
    for (std::size_t place = 0; place < result.size(); ++place)
        for (std::size_t i = 0; i < m; ++i) result[place][i] = word[(place + i) % word.size()];
    return result;
}

std::vector<Word> factors(WordView word, std::size_t m, Ends ends) {
    WordIndex index(word.size());
    for (const Word& window : windows(word, m, ends)) index.add(window);
    return index.take();
}

FactorGraph factor_graph(const Morphism& morphism, const std::vector<Word>& start, std::size_t limit) {
    WordIndex index(limit);
    for (const Word& word : start) {
        if (word.empty() || word.size() != start.front().size())
            throw std::invalid_argument("the start words must have one length, at least 1");
        index.add(word);
    }
    FactorGraph graph;
    for (std::size_t vertex = 0; vertex < index.words().size(); ++vertex) {
        const std::size_t m = index.words()[vertex].size();
        std::vector<std::uint32_t> arcs;
        for (const Word& factor : windows(morphism(index.words()[vertex]), m, Ends::Open))
            arcs.push_back(index.add(factor));
        graph.arcs.push_back(std::move(arcs));
    }
    graph.words = index.take();
    graph.persistent = recurrent(graph.arcs);
    assert(graph.arcs.size() == graph.words.size() && graph.persistent.size() == graph.words.size());
    return graph;
}

std::vector<Word> persistent_words(const Morphism& morphism, std::size_t m, std::size_t limit) {
    if (!every_letter_grows(morphism)) throw std::invalid_argument("some letter does not grow");
    // Every window of σ^k(u), u in P2, any k, is persistent, and K of the file comment is one of these k. Once a word
    // has m letters, the windows of its image are those of the images of its windows: the closure needs no σ^K, whose
    // size explodes when one letter grows fast and another slowly.
    WordIndex start(limit);
    for (Word word : persistent_pairs(morphism, limit)) {
        while (word.size() < m) word = morphism(word);
        for (const Word& window : windows(word, m, Ends::Open)) start.add(window);
    }
    std::vector<Word> words = factor_graph(morphism, start.take(), limit).words;
    assert(std::ranges::all_of(words, [m](const Word& word) { return word.size() == m; }));
    std::ranges::sort(words);
    return words;
}

std::vector<Word> all_words(std::size_t n, std::size_t m, std::size_t limit) {
    if (m == 0) throw std::invalid_argument("a word has at least one letter here");
    std::size_t count = n;
    for (std::size_t i = 1; i < m && count > 0 && count <= limit; ++i) {
        if (count > limit / n) throw TooManyWords("more than " + std::to_string(limit) + " words");
        count *= n;
    }
    if (count > limit) throw TooManyWords("more than " + std::to_string(limit) + " words");
    std::vector<Word> words(count, Word(m));
    for (std::size_t rank = 0; rank < count; ++rank) {
        std::size_t rest = rank;
        for (std::size_t i = m; i-- > 0; rest /= n) words[rank][i] = to_symbol(rest % n);
        assert(rest == 0);
    }
    return words;
}

} // namespace internode
