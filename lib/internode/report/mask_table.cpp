// SPDX-License-Identifier: MIT
//
// Masks belong to words of d+1 letters, stencils to windows of 2d-1: two graphs over the same choice of words. Windows
// are found breadth first from the start, each by the children of the one before.

#include "internode/report/mask_table.h"

#include "internode/stencil/automaton.h"
#include "internode/word/graph.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <unordered_map>

namespace internode {

namespace {

constexpr int largest_degree = 12;

WordChoice resolved(const IntervalSystem& system, WordChoice choice) {
    if (choice != WordChoice::Default) return choice;
    return system.grammar().axiom ? WordChoice::Reachable : WordChoice::Persistent;
}

/// The states of the axiom's cells. Refuses an axiom that is no word of a curve of this degree.
std::vector<CellState> axiom_cells(const IntervalSystem& system, int degree) {
    if (!system.grammar().axiom) throw std::invalid_argument("there is no axiom to start from");
    const Axiom& axiom = *system.grammar().axiom;
    const std::size_t least = 2 * static_cast<std::size_t>(degree) + 1;
    if (axiom.ends == Ends::Open && axiom.word.size() < least)
        throw std::invalid_argument("the axiom has " + std::to_string(axiom.word.size()) +
                                    " letters; the word of an open curve of degree " + std::to_string(degree) +
                                    " has at least " + std::to_string(least));
    return cell_states(axiom.word, degree, axiom.ends);
}

/// Windows by number, each once.
class WindowList {
public:
    explicit WindowList(std::size_t limit)
        : limit_(limit) {}

    std::uint32_t add(const Word& window) {
        const auto [place, is_new] = numbers_.try_emplace(window, static_cast<std::uint32_t>(words_.size()));
        if (is_new) {
            if (words_.size() >= limit_)
                throw TooManyWords("there are more than " + std::to_string(limit_) + " windows of " +
                                   std::to_string(window.size()) + " letters");
            words_.push_back(window);
        }
        return place->second;
    }
    [[nodiscard]] const std::vector<Word>& words() const { return words_; }

private:
    std::size_t limit_;
    std::vector<Word> words_;
    std::unordered_map<Word, std::uint32_t, WordHash> numbers_;
};

void mark_persistent(std::vector<WindowRow>& rows) {
    Graph graph;
    graph.reserve(rows.size());
    for (const WindowRow& row : rows) graph.push_back(row.children);
    const StrongComponents components = strong_components(graph);
    std::vector<std::uint32_t> on_cycle;
    for (std::uint32_t v = 0; v < rows.size(); ++v)
        if (components.cyclic[components.component[v]]) on_cycle.push_back(v);
    const std::vector<bool> reached = reachable(graph, on_cycle);
    for (std::size_t v = 0; v < rows.size(); ++v) rows[v].persistent = reached[v];
}

/// The windows of the table and their children by number; no weights.
struct WindowGraph {
    std::vector<Word> windows;
    Graph children;
};

WindowGraph window_graph(const IntervalSystem& system, const std::vector<Word>& start, std::size_t limit) {
    WindowList list(limit);
    for (const Word& window : start)
        if (window[window.size() / 2] != zero_interval) (void)list.add(window);
    Graph children;
    while (children.size() < list.words().size()) {
        const Word window = list.words()[children.size()]; // by value: the list grows
        std::vector<std::uint32_t>& row = children.emplace_back();
        for (const Word& child : child_windows(system.rules(), window)) row.push_back(list.add(child));
    }
    return {list.words(), std::move(children)};
}

std::vector<WindowRow> make_windows(const IntervalSystem& system, WindowGraph graph) {
    assert(graph.windows.size() == graph.children.size());
    std::vector<WindowRow> rows;
    rows.reserve(graph.windows.size());
    for (std::size_t v = 0; v < graph.windows.size(); ++v)
        rows.push_back(
            {.stencils = window_stencils(system, graph.windows[v]), .children = std::move(graph.children[v])});
    mark_persistent(rows);
    return rows;
}

/// A mask has a row for each entry, on pieces over its d + 1 letters at most; a window a piece, its children's rows and
/// d leading ones.
ExactCounts counts(const MaskTable& table, const WindowGraph& windows) {
    const auto d = static_cast<std::uint64_t>(table.degree);
    ExactCounts result;
    for (const auto& arcs : table.graph.arcs) {
        result.pieces += std::min<std::uint64_t>(arcs.size(), d + 1);
        result.rows += arcs.size();
    }
    for (const auto& children : windows.children) {
        result.pieces += 1;
        result.rows += children.size() + d;
    }
    return result;
}

} // namespace

MaskTable make_mask_table(const IntervalSystem& system, int degree, WordChoice choice, const ExactLimits& limits) {
    if (degree < 1 || degree > largest_degree)
        throw std::invalid_argument("a degree is 1 to " + std::to_string(largest_degree));
    MaskTable table{.system = system,
                    .degree = degree,
                    .choice = resolved(system, choice),
                    .graph = {},
                    .masks = {},
                    .windows = {}};
    const auto d = static_cast<std::size_t>(degree);
    std::vector<Word> start;
    if (table.choice == WordChoice::Reachable) {
        for (const CellState& cell : axiom_cells(system, degree)) {
            start.push_back(cell.window);
            table.has_leading = table.has_leading || cell.lead > 0;
        }
    } else {
        start = word_graph(system, 2 * d - 1, table.choice, limits.entries).words;
    }
    table.graph = word_graph(system, d + 1, table.choice, limits.entries);
    WindowGraph windows = window_graph(system, start, limits.entries);
    begin_exact_work(exact_work(system, degree, counts(table, windows)), limits);
    table.masks.reserve(table.graph.words.size());
    for (const Word& word : table.graph.words) table.masks.push_back(mask(system, word));
    table.windows = make_windows(system, std::move(windows));
    return table;
}

} // namespace internode
