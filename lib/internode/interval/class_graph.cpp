// SPDX-License-Identifier: MIT
//
// Strong components come with their successors first (word/graph.h) and classes keep that order: when a class asks for
// its home, the homes of all that it leads to are known.

#include "internode/interval/class_graph.h"

#include "internode/word/graph.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace internode {

namespace {

SparseRow count_letters(WordView word) {
    assert(std::ranges::find(word, zero_interval) == word.end());
    std::vector<std::uint32_t> letters;
    for (const Symbol symbol : word) letters.push_back(static_cast<std::uint32_t>(to_index(symbol)));
    std::ranges::sort(letters);
    SparseRow row;
    for (const std::uint32_t letter : letters) {
        if (row.empty() || row.back().first != letter)
            row.emplace_back(letter, 1);
        else
            ++row.back().second;
    }
    return row;
}

Graph graph_of(const SparseMatrix& matrix) {
    Graph graph(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (const auto& entry : matrix[i]) graph[i].push_back(entry.first);
    return graph;
}

std::vector<bool> occurring(const IntervalGrammar& grammar, const Graph& graph) {
    if (!grammar.axiom) return std::vector<bool>(graph.size(), true);
    std::vector<std::uint32_t> start;
    for (const Symbol symbol : grammar.axiom->word)
        if (symbol != zero_interval) start.push_back(static_cast<std::uint32_t>(to_index(symbol)));
    return reachable(graph, start);
}

/// The period of an irreducible block, in time proportional to the block and not to the system.
std::size_t block_period(const SparseMatrix& block) {
    StrongComponents whole;
    whole.component.assign(block.size(), 0);
    whole.members.emplace_back(block.size());
    std::iota(whole.members.front().begin(), whole.members.front().end(), 0U);
    return period(graph_of(block), whole, 0);
}

/// Fills block and successors of every class from the rows of its members.
void split_rows(ClassGraph& graph) {
    assert(graph.class_of.size() == graph.matrix.size());
    std::vector<std::uint32_t> place(graph.matrix.size());
    for (const IntervalClass& one : graph.classes)
        for (std::uint32_t local = 0; local < one.members.size(); ++local) place[one.members[local]] = local;
    for (std::uint32_t index = 0; index < graph.classes.size(); ++index) {
        IntervalClass& one = graph.classes[index];
        for (const std::uint32_t member : one.members) {
            SparseRow& inside = one.block.emplace_back();
            for (const auto& [column, entry] : graph.matrix[member]) {
                assert(graph.class_of[column] != no_class && "what occurs produces only what occurs");
                if (graph.class_of[column] == index)
                    inside.emplace_back(place[column], entry);
                else
                    one.successors.push_back(graph.class_of[column]);
            }
        }
        std::ranges::sort(one.successors);
        one.successors.erase(std::unique(one.successors.begin(), one.successors.end()), one.successors.end());
    }
}

/// Successors come first, so their homes are known.
std::uint32_t home_of(const ClassGraph& graph, std::uint32_t index) {
    const IntervalClass& one = graph.classes[index];
    if (one.final) return index;
    assert(!one.successors.empty() && one.successors.back() < index);
    const std::uint32_t home = graph.classes[one.successors.front()].home;
    const auto agrees = [&](std::uint32_t successor) { return graph.classes[successor].home == home; };
    return std::ranges::all_of(one.successors, agrees) ? home : no_class;
}

} // namespace

ClassGraph class_graph(const IntervalGrammar& grammar) {
    ClassGraph result;
    for (const Word& image : grammar.rules.images()) result.matrix.push_back(count_letters(image));
    const Graph graph = graph_of(result.matrix);
    const std::vector<bool> occurs = occurring(grammar, graph);
    assert(occurs.size() == graph.size());
    const StrongComponents components = strong_components(graph);
    result.class_of.assign(graph.size(), no_class);
    for (const std::vector<std::uint32_t>& members : components.members) {
        if (!occurs[members.front()]) continue;
        for (const std::uint32_t member : members)
            result.class_of[member] = static_cast<std::uint32_t>(result.classes.size());
        result.classes.emplace_back().members = members;
    }
    for (std::size_t i = 0; i < graph.size(); ++i)
        if (!occurs[i]) result.matrix[i].clear();
    split_rows(result);
    for (std::uint32_t index = 0; index < result.classes.size(); ++index) {
        IntervalClass& one = result.classes[index];
        one.final = one.successors.empty();
        one.home = home_of(result, index);
        one.period = block_period(one.block);
    }
    return result;
}

bool splits(const IntervalClass& one) {
    const auto is_repeated = [](const auto& entry) { return entry.second > 1; };
    return std::ranges::any_of(
        one.block, [&](const SparseRow& row) { return row.size() > 1 || std::ranges::any_of(row, is_repeated); });
}

SparseMatrix transposed(const SparseMatrix& matrix) {
    SparseMatrix result(matrix.size());
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
        for (const auto& [column, entry] : matrix[i]) result[column].emplace_back(i, entry);
    return result;
}

} // namespace internode
