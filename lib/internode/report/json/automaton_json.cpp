// SPDX-License-Identifier: MIT

#include "internode/report/json/automaton_json.h"

#include "internode/report/json/json_parts.h"

namespace internode {

namespace {

void write_states(JsonWriter& json, const AutomatonExport& exported) {
    const StencilAutomaton& automaton = exported.automaton;
    json.key("states").begin_array();
    for (std::uint32_t s = 0; s < automaton.state_count(); ++s) {
        const CellState& state = automaton.state(s);
        json.begin_object(one_line).key("window");
        write_word(json, state.window, exported.system.alphabet());
        json.key("lead").integer(state.lead);
        json.key("offset").number(static_cast<double>(automaton.offset(s)));
        json.key("children").begin_array(one_line);
        for (const StencilAutomaton::Child& child : automaton.children(s))
            json.begin_object(one_line).key("state").integer(child.state).key("row").integer(child.row).end_object();
        json.end_array().end_object();
    }
    json.end_array();
}

void write_rows(JsonWriter& json, const AutomatonExport& exported) {
    json.key("rows").begin_array();
    for (std::uint32_t row = 0; row < exported.automaton.row_count(); ++row) {
        json.begin_array(one_line);
        for (const Number& weight : exported.automaton.exact_weights(row))
            write_number(json, weight, exported.system.field());
        json.end_array();
    }
    json.end_array();
}

} // namespace

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
