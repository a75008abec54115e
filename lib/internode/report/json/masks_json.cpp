// SPDX-License-Identifier: MIT

#include "internode/report/json/masks_json.h"

#include "internode/report/json/json_parts.h"

#include <cassert>

namespace internode {

namespace {

void write_weights(JsonWriter& json, const std::vector<Number>& weights, const NumberField& field) {
    json.begin_array(one_line);
    for (const Number& weight : weights) write_number(json, weight, field);
    json.end_array();
}

void write_decompositions(JsonWriter& json, const MaskTable& table) {
    assert(table.graph.persistent.size() == table.masks.size());
    const Alphabet& alphabet = table.system.alphabet();
    json.key("decompositions").begin_array();
    for (std::size_t v = 0; v < table.masks.size(); ++v) {
        json.begin_object().key("word");
        write_word(json, table.masks[v].word, alphabet);
        json.key("persistent").boolean(table.graph.persistent[v]);
        json.key("mask").begin_array();
        for (const MaskEntry& entry : table.masks[v].entries) {
            json.begin_object(one_line).key("word");
            write_word(json, entry.word, alphabet);
            json.key("weight");
            write_number(json, entry.weight, table.system.field());
            json.end_object();
        }
        json.end_array().end_object();
    }
    json.end_array();
}

void write_windows(JsonWriter& json, const MaskTable& table) {
    const NumberField& field = table.system.field();
    json.key("windows").begin_array();
    for (const WindowRow& row : table.windows) {
        json.begin_object().key("word");
        write_word(json, row.stencils.window, table.system.alphabet());
        json.key("persistent").boolean(row.persistent);
        json.key("children").begin_array();
        assert(row.children.size() == row.stencils.children.size());
        for (std::size_t c = 0; c < row.children.size(); ++c) {
            json.begin_object(one_line).key("window").integer(row.children[c]).key("weights");
            write_weights(json, row.stencils.children[c], field);
            json.end_object();
        }
        json.end_array();
        json.key("leading").begin_array();
        for (const std::vector<Number>& weights : row.stencils.leading) write_weights(json, weights, field);
        json.end_array().end_object();
    }
    json.end_array();
}

} // namespace

std::string_view to_string(WordChoice choice) {
    switch (choice) {
    case WordChoice::Reachable:
        return "reachable";
    case WordChoice::Persistent:
        return "persistent";
    case WordChoice::All:
        return "all";
    case WordChoice::Default:
        break;
    }
    return "default";
}

std::string masks_json(const MaskTable& table, const Generator& generator) {
    StringSink sink;
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-masks", generator);
    json.key("degree").integer(static_cast<std::size_t>(table.degree));
    json.key("words").string(to_string(table.choice));
    write_system(json, table.system);
    write_decompositions(json, table);
    write_windows(json, table);
    json.end_object().finish();
    return sink.text();
}

} // namespace internode
