// SPDX-License-Identifier: MIT

#include "internode/report/automaton_export.h"

#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

void require_degree(int degree) {
    if (degree < 1 || degree > 12) throw std::invalid_argument("a stencil automaton has a degree from 1 to 12");
}

} // namespace

std::vector<CellState> cells_of_windows(const std::vector<Word>& windows, int degree) {
    require_degree(degree);
    const auto d = static_cast<std::uint32_t>(degree);
    std::vector<CellState> cells;
    for (const Word& window : windows) {
        assert(window.size() + 1 == 2 * std::size_t{d});
        for (std::uint32_t z = 0; z <= d; ++z) cells.push_back({window, z});
        Word clamped(d, zero_interval);
        clamped.insert(clamped.end(), window.begin(), window.end());
        clamped.insert(clamped.end(), d, zero_interval);
        const std::vector<CellState> ends = cell_states(clamped, degree, Ends::Open);
        cells.insert(cells.end(), ends.begin(), ends.end());
    }
    return cells;
}

AutomatonExport export_automaton(const std::string& name, const IntervalSystem& system, int degree, WordChoice choice,
                                 const ExactLimits& limits) {
    require_degree(degree);
    const bool has_axiom = system.grammar().axiom.has_value();
    if (choice == WordChoice::Reachable && !has_axiom) throw std::invalid_argument("there is no axiom to start from");
    if (choice == WordChoice::Reachable || (choice == WordChoice::Default && has_axiom)) {
        AutomatonExport exported = export_automaton(name, system, degree, *system.grammar().axiom, limits);
        exported.start = "axiom";
        return exported;
    }
    if (choice == WordChoice::Default) choice = WordChoice::Persistent;
    const std::size_t letters = 2 * static_cast<std::size_t>(degree) - 1;
    const std::vector<Word> windows = word_graph(system, letters, choice, limits.entries).words;
    return {name, system, choice == WordChoice::All ? "all" : "persistent",
            make_automaton(system, degree, cells_of_windows(windows, degree), limits), 1};
}

AutomatonExport export_automaton(const std::string& name, const IntervalSystem& system, int degree, const Axiom& word,
                                 const ExactLimits& limits) {
    return {name, system, "word", make_automaton(system, degree, cell_states(word.word, degree, word.ends), limits), 1};
}

} // namespace internode
