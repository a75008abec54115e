// SPDX-License-Identifier: MIT

#include "internode/report/json/pyramid_json.h"

#include "internode/report/json/json_parts.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

void write_rows(JsonWriter& json, const std::vector<double>& rows, std::size_t dimension) {
    assert(dimension > 0 && rows.size() % dimension == 0);
    json.begin_array();
    for (std::size_t row = 0; row < rows.size(); row += dimension) {
        json.begin_array(one_line);
        for (std::size_t c = row; c < row + dimension; ++c) json.number(rows[c]);
        json.end_array();
    }
    json.end_array();
}

void write_error(JsonWriter& json, std::string_view key, const PolygonError& error) {
    json.key(key).begin_object(one_line).key("largest").number(error.largest);
    json.key("root_mean_square").number(error.root_mean_square).end_object();
}

void write_fitting(JsonWriter& json, const Fitting& fitting) {
    begin_fitting(json, fitting);
    json.key("spacing");
    if (fitting.fit == Fit::Resampled)
        json.string(fitting.spacing == Spacing::Index ? "index" : "chord-length");
    else
        json.null();
    json.key("clamped").boolean(fitting.clamped).end_object();
}

void write_method(JsonWriter& json, const ReverseOptions& options) {
    const bool local = options.method == ReverseMethod::Local;
    json.key("method").string(local ? "local" : "least-squares").key("window");
    if (local)
        json.integer(options.window);
    else
        json.null();
}

/// Where the parameter of all levels begins.
void write_origin(JsonWriter& json, const Knots& knots) {
    json.key("origin")
        .begin_object(one_line)
        .key("value")
        .number(knots.origin().to_double())
        .key("exact")
        .begin_array();
    for (const Rational& coefficient : knots.origin().coefficients(knots.system().field()))
        json.string(to_string(coefficient));
    json.end_array().end_object();
}

void write_level(JsonWriter& json, const PyramidReport& report, std::size_t level) {
    const std::size_t dimension = report.kept.coarse.dimension();
    assert(level + 1 < report.analysis.gains.size() && level + 1 < report.errors.approximations.size());
    const PyramidLevel& kept = report.kept.levels[level];
    const std::vector<double> lengths = lengths_of(report.analysis.pyramid.levels[level].details, dimension);
    json.begin_object().key("points").integer(kept.points).key("inserted").integer(kept.inserted);
    json.key("longest").number(lengths.empty() ? 0 : *std::ranges::max_element(lengths));
    json.key("gain").number(report.analysis.gains[level + 1]);
    write_error(json, "approximation", report.errors.approximations[level + 1]);
    json.key("at").begin_array(one_line);
    for (const std::size_t point : kept.details.points) json.integer(point);
    json.end_array().key("details");
    write_rows(json, kept.details.vectors, dimension);
    json.end_object();
}

} // namespace

std::string pyramid_json(const PyramidReport& report, const Generator& generator) {
    StringSink sink;
    JsonWriter json(sink);
    const Curve& coarse = report.kept.coarse;
    json.begin_object();
    write_heading(json, "internode-pyramid", generator);
    json.key("degree").integer(static_cast<std::size_t>(coarse.degree()));
    json.key("closed").boolean(coarse.ends() == Ends::Circular);
    write_system(json, coarse.system());
    write_fitting(json, report.fitting);
    write_method(json, report.kept.options);
    json.key("gain").number(report.analysis.gains.front());
    write_error(json, "approximation", report.errors.approximations.front());
    write_error(json, "round_trip", report.errors.round_trips.back());
    write_error(json, "error", report.errors.kept);
    json.key("word");
    write_word(json, coarse.word(), coarse.system().alphabet());
    write_origin(json, coarse.knots());
    json.key("points");
    write_rows(json, coarse.points(), coarse.dimension());
    json.key("levels").begin_array();
    for (std::size_t level = 0; level < report.kept.levels.size(); ++level) write_level(json, report, level);
    json.end_array().end_object().finish();
    return sink.text();
}

} // namespace internode
