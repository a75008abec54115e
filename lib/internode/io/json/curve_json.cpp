// SPDX-License-Identifier: MIT

#include "internode/io/json/curve_json.h"

#include "internode/io/json/json_writer.h"
#include "internode/text/number.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

void write_head(JsonWriter& json, const CurveDocument& curve) {
    json.key("format").string("internode-curve").key("version").integer(1);
    json.key("generator").begin_object(one_line);
    json.key("version").string(curve.version).key("command").string(curve.command).end_object();
    json.key("degree").integer(curve.degree).key("closed").boolean(curve.ends == Ends::Circular);
}

void write_word(JsonWriter& json, const CurveDocument& curve) {
    if (curve.word.empty()) return;
    json.key("word").begin_array(one_line);
    std::vector<std::string> quoted;
    for (const std::string& symbol : curve.symbols) quoted.push_back(json_quoted(symbol));
    json.values(curve.word.size(), curve.threads, [&](std::size_t i, std::string& text) {
        text += curve.word[i] == zero_interval ? "\"0\"" : quoted.at(to_index(curve.word[i]));
    });
    json.end_array();
}

void write_lengths(JsonWriter& json, const CurveDocument& curve) {
    const bool any =
        std::ranges::any_of(curve.lengths, [](const CurveLength& length) { return !length.exact.empty(); });
    if (!any) return;
    json.key("lengths").begin_object();
    for (const CurveLength& length : curve.lengths) {
        if (length.exact.empty()) continue;
        json.key(length.symbol).begin_object(one_line).key("value").number(length.value).key("exact").begin_array();
        for (const std::string& coefficient : length.exact) json.string(coefficient);
        json.end_array().end_object();
    }
    json.end_object();
}

void write_knots(JsonWriter& json, const CurveDocument& curve) {
    if (!curve.origin.exact.empty()) {
        json.key("origin").begin_object(one_line).key("value").number(curve.origin.value).key("exact").begin_array();
        for (const std::string& coefficient : curve.origin.exact) json.string(coefficient);
        json.end_array().end_object();
    }
    if (curve.knots.empty()) return;
    json.key("knots").begin_array(one_line);
    json.values(curve.knots.size(), curve.threads,
                [&](std::size_t i, std::string& text) { append(text, curve.knots[i]); });
    json.end_array();
}

void write_points(JsonWriter& json, const CurveDocument& curve) {
    const std::size_t dimension = curve.points.dimension - (curve.weighted ? 1 : 0);
    assert(dimension >= 1);
    json.key("points").begin_array();
    json.values(curve.points.size(), curve.threads,
                [&](std::size_t row, std::string& text) { append_array(text, curve.points[row].first(dimension)); });
    json.end_array();
}

void write_weights(JsonWriter& json, const CurveDocument& curve) {
    json.key("weights").begin_array(one_line);
    json.values(curve.points.size(), curve.threads,
                [&](std::size_t row, std::string& text) { append(text, curve.points[row].back()); });
    json.end_array();
}

void require_writable(const CurveDocument& curve) {
    require_whole_rows(curve.points);
    if (curve.weighted && curve.points.dimension < 2) throw std::invalid_argument("a weight and no coordinate");
}

void write_one(JsonWriter& json, const CurveDocument& curve) {
    json.begin_object();
    write_head(json, curve);
    write_word(json, curve);
    write_lengths(json, curve);
    write_knots(json, curve);
    write_points(json, curve);
    if (curve.weighted) write_weights(json, curve);
    json.end_object();
}

} // namespace

bool write_curve_json(Sink& sink, const CurveDocument& curve) {
    require_writable(curve);
    JsonWriter json(sink);
    write_one(json, curve);
    return json.finish();
}

bool write_curves_json(Sink& sink, std::span<const CurveDocument> curves) {
    std::ranges::for_each(curves, require_writable);
    JsonWriter json(sink);
    json.begin_object();
    json.key("format").string("internode-curves").key("version").integer(1);
    json.key("curves").begin_array();
    for (const CurveDocument& curve : curves) write_one(json, curve);
    json.end_array().end_object();
    return json.finish();
}

} // namespace internode
