// SPDX-License-Identifier: MIT

#include "internode/io/json/grid_json.h"

#include "internode/io/json/json_writer.h"

#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

void write_head(JsonWriter& json, const GridDocument& grid) {
    json.key("format").string("internode-grid").key("version").integer(1);
    json.key("generator").begin_object(one_line);
    json.key("version").string(grid.version).key("command").string(grid.command).end_object();
    json.key("degree").begin_array(one_line);
    for (const GridSide& side : grid.sides) json.integer(side.degree);
    json.end_array().key("closed").begin_array(one_line);
    for (const GridSide& side : grid.sides) json.boolean(side.ends == Ends::Circular);
    json.end_array().key("rational").boolean(grid.rational);
}

void write_words(JsonWriter& json, const GridDocument& grid) {
    json.key("word").begin_array();
    for (const GridSide& side : grid.sides) {
        json.begin_array(one_line);
        for (const Symbol symbol : side.word) {
            if (!json.good()) break;
            json.string(symbol == zero_interval ? "0" : side.symbols.at(to_index(symbol)));
        }
        json.end_array();
    }
    json.end_array();
}

void write_lengths(JsonWriter& json, const GridDocument& grid) {
    json.key("lengths").begin_array();
    for (const GridSide& side : grid.sides) {
        json.begin_object();
        for (const CurveLength& length : side.lengths) {
            if (length.exact.empty()) continue;
            json.key(length.symbol).begin_object(one_line).key("value").number(length.value).key("exact").begin_array();
            for (const std::string& coefficient : length.exact) json.string(coefficient);
            json.end_array().end_object();
        }
        json.end_object();
    }
    json.end_array();
}

void write_origins(JsonWriter& json, const GridDocument& grid) {
    if (grid.sides[0].origin.exact.empty() && grid.sides[1].origin.exact.empty()) return;
    json.key("origin").begin_array();
    for (const GridSide& side : grid.sides) {
        if (side.origin.exact.empty()) {
            json.null();
            continue;
        }
        json.begin_object(one_line).key("value").number(side.origin.value).key("exact").begin_array();
        for (const std::string& coefficient : side.origin.exact) json.string(coefficient);
        json.end_array().end_object();
    }
    json.end_array();
}

void write_knots(JsonWriter& json, const GridDocument& grid) {
    if (grid.sides[0].knots.empty() && grid.sides[1].knots.empty()) return;
    json.key("knots").begin_array();
    for (const GridSide& side : grid.sides) {
        if (side.knots.empty()) {
            json.null();
            continue;
        }
        json.begin_array(one_line);
        for (std::size_t i = 0; i < side.knots.size() && json.good(); ++i) json.number(side.knots[i]);
        json.end_array();
    }
    json.end_array();
}

/// Row after row, a line for each.
void write_points(JsonWriter& json, const GridDocument& grid) {
    assert(grid.columns > 0 && grid.points.size() % grid.columns == 0);
    json.key("points").begin_array();
    json.rows(grid.points.size(), grid.columns, grid.threads,
              [&](std::size_t point, std::string& text) { append_array(text, grid.points[point]); });
    json.end_array();
}

} // namespace

bool write_grid_json(Sink& sink, const GridDocument& grid) {
    require_whole_rows(grid.points);
    if (grid.columns == 0 || grid.points.size() % grid.columns != 0)
        throw std::invalid_argument("write_grid_json: the points are not whole rows of the grid");
    JsonWriter json(sink);
    json.begin_object();
    write_head(json, grid);
    write_words(json, grid);
    write_lengths(json, grid);
    write_origins(json, grid);
    write_knots(json, grid);
    write_points(json, grid);
    json.end_object();
    return json.finish();
}

} // namespace internode
