// SPDX-License-Identifier: MIT

#include "internode/report/json/reversal_json.h"

#include "internode/io/json/json_writer.h"
#include "internode/report/json/json_parts.h"
#include "internode/report/text/reversal_text.h"

#include <cassert>

namespace internode {

namespace {

void write_rule(JsonWriter& json, const std::optional<ReverseRule>& rule) {
    json.key("rule");
    if (!rule) {
        json.null();
        return;
    }
    json.begin_object().key("production").string(production_text(*rule)).key("arity").integer(rule->arity);
    json.key("first").number(static_cast<double>(rule->first)).key("weights").begin_array(one_line);
    for (const Rational& weight : rule->weights) json.string(to_string(weight));
    json.end_array().key("gain").string(to_string(gain(*rule))).end_object();
}

void write_levels(JsonWriter& json, const ReversalReport& report) {
    assert(!report.rule || report.levels.size() + 1 == report.polygons.size());
    json.key("levels").begin_array();
    for (std::size_t down = 1; down < report.polygons.size(); ++down) {
        json.begin_object(one_line).key("points").integer(report.polygons[down].size() / report.dimension);
        if (report.rule) {
            json.key("largest_error").number(report.levels[down - 1].largest_error);
            json.key("rms_error").number(report.levels[down - 1].rms_error);
        } else {
            json.key("largest_error").null().key("rms_error").null();
        }
        json.end_object();
    }
    json.end_array();
}

void write_points(JsonWriter& json, const ReversalReport& report) {
    const std::vector<double>& points = report.polygons.back();
    json.key("points").begin_array();
    for (std::size_t row = 0; row < points.size() && json.good(); row += report.dimension) {
        json.begin_array(one_line);
        for (std::size_t i = row; i < row + report.dimension; ++i) json.number(points[i]);
        json.end_array();
    }
    json.end_array();
}

} // namespace

std::string reversal_json(const ReversalReport& report) {
    assert(!report.polygons.empty() && report.dimension > 0);
    StringSink sink;
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-reversal", report.generator);
    json.key("grammar").begin_object(one_line).key("name").string(report.name).end_object();
    begin_fitting(json, report.fitting);
    json.end_object();
    json.key("phase").integer(report.phase);
    write_rule(json, report.rule);
    write_levels(json, report);
    write_points(json, report);
    json.end_object().finish();
    return sink.text();
}

} // namespace internode
