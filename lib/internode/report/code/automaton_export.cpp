// SPDX-License-Identifier: MIT

#include "internode/report/code/automaton_export.h"

#include "internode/report/json/json_parts.h"

#include <stdexcept>

namespace internode {

namespace {

constexpr JsonWriter::Layout line = JsonWriter::Layout::Line;

void require_degree(int degree) {
    if (degree < 1 || degree > 12) throw std::invalid_argument("a stencil automaton has a degree from 1 to 12");
}

void write_states(JsonWriter& json, const AutomatonExport& exported) {
    const StencilAutomaton& automaton = exported.automaton;
    json.key("states").begin_array();
    for (std::uint32_t s = 0; s < automaton.state_count(); ++s) {
        const CellState& state = automaton.state(s);
        json.begin_object(line).key("window");
        write_word(json, state.window, exported.system.alphabet());
        json.key("lead").integer(state.lead);
        json.key("offset").number(static_cast<double>(automaton.offset(s)));
        json.key("children").begin_array(line);
        for (const StencilAutomaton::Child& child : automaton.children(s))
            json.begin_object(line).key("state").integer(child.state).key("row").integer(child.row).end_object();
        json.end_array().end_object();
    }
    json.end_array();
}

void write_rows(JsonWriter& json, const AutomatonExport& exported) {
    json.key("rows").begin_array();
    for (std::uint32_t row = 0; row < exported.automaton.row_count(); ++row) {
        json.begin_array(line);
        for (const Number& weight : exported.automaton.exact_weights(row))
            write_number(json, weight, exported.system.field());
        json.end_array();
    }
    json.end_array();
}

} // namespace

std::vector<CellState> cells_of_windows(const std::vector<Word>& windows, int degree) {
    require_degree(degree);
    const auto d = static_cast<std::uint32_t>(degree);
    std::vector<CellState> cells;
    for (const Word& window : windows) {
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

std::string automaton_json(const AutomatonExport& automaton, const Generator& generator) {
    StringSink sink;
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-automaton", generator);
    json.key("degree").integer(static_cast<std::size_t>(automaton.automaton.degree()));
    json.key("start").string(automaton.start);
    json.key("steps").integer(automaton.steps);
    write_system(json, automaton.system);
    write_states(json, automaton);
    write_rows(json, automaton);
    json.end_object().finish();
    return sink.text();
}

} // namespace internode
