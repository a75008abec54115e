// SPDX-License-Identifier: MIT

#include "internode/report/json/points_json.h"

#include "internode/io/json/json_writer.h"
#include "internode/point/strands.h"
#include "internode/report/json/json_parts.h"
#include "internode/text/number.h"

#include <cassert>
#include <span>
#include <stdexcept>

namespace internode {

namespace {

void write_row(JsonWriter& json, std::span<const double> row) {
    json.begin_array(one_line);
    for (const double coordinate : row) json.number(coordinate);
    json.end_array();
}

void write_system(JsonWriter& json, const PointSystem& system, const std::string& name) {
    const PointGrammar& grammar = system.grammar();
    json.key("grammar").begin_object().key("name").string(name).key("constants").begin_object();
    for (std::uint32_t i = 0; i < grammar.definitions.size(); ++i) {
        if (!grammar.definitions[i].formals.empty()) continue;
        const KnownNumber& constant = system.constant(i);
        json.key(grammar.definitions[i].name).begin_object(one_line).key("value").number(nearest(constant));
        json.key("exact");
        if (constant.exact)
            json.string(to_string(*constant.exact));
        else
            json.null();
        json.end_object();
    }
    json.end_object().end_object();
}

void write_points(JsonWriter& json, const PointStrands& strands, const PointsDocument& document) {
    const std::size_t width = strands.dimension;
    assert(!document.weighted || width >= 2);
    if (document.weighted) {
        json.key("weights").begin_array(one_line);
        json.values(strands.size(), document.threads,
                    [&](std::size_t i, std::string& text) { append(text, strands.points[i * width + width - 1]); });
        json.end_array();
    }
    json.key("points").begin_array();
    json.values(strands.size(), document.threads, [&](std::size_t i, std::string& text) {
        append_array(text, std::span(strands.points).subspan(i * width, document.weighted ? width - 1 : width));
    });
    json.end_array();
}

void write_strands(JsonWriter& json, const PointStrands& strands) {
    json.key("strands").begin_array();
    for (const PointStrands::Strand& strand : strands.strands) {
        json.begin_object().key("closed").boolean(strand.closed).key("points").begin_array(one_line);
        for (const std::size_t index : strand.points) json.integer(index);
        json.end_array().end_object();
    }
    json.end_array().key("lines").begin_array();
    const std::size_t width = strands.dimension;
    assert(width == 0 || strands.lines.size() % (2 * width) == 0);
    for (std::size_t at = 0; at + 2 * width <= strands.lines.size() && width > 0 && json.good(); at += 2 * width) {
        json.begin_array(one_line);
        write_row(json, std::span(strands.lines).subspan(at, width));
        write_row(json, std::span(strands.lines).subspan(at + width, width));
        json.end_array();
    }
    json.end_array();
}

void require_writable(const PointsPart& part) {
    if (part.document.weighted && part.strands.dimension < 2)
        throw std::invalid_argument("points: a weight without a point");
}

void write_one(JsonWriter& json, const PointsPart& part) {
    json.begin_object();
    write_heading(json, "internode-points", part.document.generator);
    write_system(json, part.system, part.document.name);
    json.key("cycles").integer(part.document.cycles).key("closed").boolean(part.system.grammar().ring);
    write_points(json, part.strands, part.document);
    write_strands(json, part.strands);
    json.end_object();
}

} // namespace

bool write_points_json(Sink& sink, const PointStrands& strands, const PointSystem& system,
                       const PointsDocument& document) {
    const PointsPart part{strands, system, document};
    require_writable(part);
    JsonWriter json(sink);
    write_one(json, part);
    return json.finish();
}

bool write_parts_json(Sink& sink, std::span<const PointsPart> parts) {
    for (const PointsPart& part : parts) require_writable(part);
    JsonWriter json(sink);
    json.begin_object().key("format").string("internode-parts").key("version").integer(1);
    json.key("parts").begin_array();
    for (const PointsPart& part : parts) write_one(json, part);
    json.end_array().end_object();
    return json.finish();
}

} // namespace internode
