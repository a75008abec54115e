// SPDX-License-Identifier: MIT

#include "internode/io/polygon.h"

#include <cassert>

namespace internode {

namespace {

bool is_json(std::string_view text) {
    const std::size_t first = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
    return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

ParsedPolygon only_one(ParsedPolygons parsed) {
    assert(parsed.polygons.empty() != parsed.errors.empty());
    if (parsed.polygons.empty()) return {.polygon = {}, .errors = std::move(parsed.errors)};
    if (parsed.polygons.size() == 1) return {.polygon = std::move(parsed.polygons.front()), .errors = {}};
    Diagnostic second;
    second.source = parsed.polygons[1].source;
    second.line = parsed.polygons[1].line;
    second.column = 1;
    second.message = "a second polygon begins here, where one is meant";
    return {.polygon = {}, .errors = {std::move(second)}};
}

} // namespace

ParsedPolygons read_polygons(std::string_view text, std::string_view source, int threads) {
    return is_json(text) ? read_polygons_json(text, source) : read_polygons_csv(text, source, threads);
}

ParsedPolygon read_polygon_csv(std::string_view text, std::string_view source) {
    return only_one(read_polygons_csv(text, source));
}

ParsedPolygon read_polygon_json(std::string_view text, std::string_view source) {
    return only_one(read_polygons_json(text, source));
}

ParsedPolygon read_polygon(std::string_view text, std::string_view source) {
    return only_one(read_polygons(text, source));
}

} // namespace internode
