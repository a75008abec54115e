// SPDX-License-Identifier: MIT

#include "internode/report/json/point_masks_json.h"

#include "internode/io/json/json_writer.h"
#include "internode/report/json/json_parts.h"

namespace internode {

namespace {

void write_name(JsonWriter& json, const std::string& name, bool closed) {
    json.key("grammar").begin_object(one_line).key("name").string(name).end_object();
    json.key("closed").boolean(closed);
}

void write_signed(JsonWriter& json, std::ptrdiff_t value) {
    json.number(static_cast<double>(value));
}

void write_mask(JsonWriter& json, const std::optional<UniformMask>& mask) {
    json.key("mask");
    if (!mask) {
        json.null();
        return;
    }
    json.begin_object(one_line).key("arity").integer(mask->arity).key("first");
    write_signed(json, mask->first);
    json.key("coefficients").begin_array(one_line);
    for (const Rational& weight : mask->coefficients) json.string(to_string(weight));
    json.end_array().end_object();
}

void write_matrix(JsonWriter& json, const RationalMatrix& matrix) {
    json.key("matrix").begin_object().key("columns").integer(matrix.columns).key("rows").begin_array();
    for (const RationalRow& row : matrix.rows) {
        json.begin_array(one_line);
        for (const RationalEntry& entry : row)
            json.begin_object(one_line)
                .key("column")
                .integer(entry.column)
                .key("weight")
                .string(to_string(entry.value))
                .end_object();
        json.end_array();
    }
    json.end_array().end_object();
}

void write_states(JsonWriter& json, const CellAutomaton& automaton) {
    json.key("states").begin_array();
    for (std::uint32_t state = 0; state < automaton.state_count(); ++state) {
        json.begin_object(one_line).key("offset");
        write_signed(json, automaton.offset(state));
        json.key("children").begin_array(one_line);
        for (const CellAutomaton::Child& child : automaton.children(state))
            json.begin_object(one_line).key("state").integer(child.state).key("row").integer(child.row).end_object();
        json.end_array().end_object();
    }
    json.end_array().key("rows").begin_array();
    const NumberField rationals; // weights of point grammars are rational
    for (std::uint32_t row = 0; row < automaton.row_count(); ++row) {
        json.begin_array(one_line);
        for (const Number& weight : automaton.exact_weights(row))
            json.string(to_string(weight.coefficients(rationals).front()));
        json.end_array();
    }
    json.end_array();
}

} // namespace

std::string point_masks_json(const PointMasks& masks) {
    StringSink sink;
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-point-masks", masks.generator);
    write_name(json, masks.name, masks.closed);
    write_mask(json, masks.mask);
    write_matrix(json, masks.matrix);
    json.end_object().finish();
    return sink.text();
}

std::string cells_json(const CellExport& cells) {
    StringSink sink;
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-cells", cells.generator);
    write_name(json, cells.name, cells.closed);
    json.key("interior");
    if (cells.compiled.interior())
        json.integer(*cells.compiled.interior());
    else
        json.null();
    json.key("start").begin_array(one_line);
    for (const std::uint32_t state : cells.compiled.cells()) json.integer(state);
    json.end_array();
    write_states(json, cells.compiled.automaton());
    json.end_object().finish();
    return sink.text();
}

} // namespace internode
