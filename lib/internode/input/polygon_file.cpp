// SPDX-License-Identifier: MIT

#include "internode/input/polygon_file.h"

#include "internode/input/refuse.h"
#include "internode/io/obj/free_form_input.h"
#include "internode/io/obj/obj_freeform.h"
#include "internode/io/obj/obj_polylines.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode {

namespace {

using Element = std::optional<std::uint64_t>;

FreeFormFile free_forms(std::string_view text, std::string_view source) {
    ParsedFreeForms parsed = read_obj_freeform(text, source);
    if (!parsed.file) refuse(std::move(parsed.errors));
    return *std::move(parsed.file);
}

/// The place of an element in a list, from 0.
std::size_t place_of_element(std::uint64_t element, std::size_t count, const std::string& source) {
    if (element < 1 || element > count)
        refuse(fmt::format("no element {}: {} has {}, counted from 1", element, source, count));
    return static_cast<std::size_t>(element) - 1;
}

const FreeForm& chosen(const FreeFormFile& file, Element element) {
    const std::size_t count = file.elements.size();
    if (element) return file.elements[place_of_element(*element, count, file.source)];
    if (count != 1)
        refuse(fmt::format("{} has {} curves and surfaces", file.source, count),
               fmt::format("say which: --element 1 … {}", count));
    return file.elements.front();
}

/// "element 2 of body.obj (line 31)".
std::string element_name(const FreeFormFile& file, const FreeForm& element) {
    return fmt::format("element {} of {} (line {})", &element - file.elements.data() + 1, file.source,
                       element.place.line);
}

std::vector<InputPolygon> free_form_polygons(std::string_view text, std::string_view source, Element element) {
    const FreeFormFile file = free_forms(text, source);
    const bool only_curves = std::ranges::none_of(file.elements, [](const FreeForm& one) { return one.v.has_value(); });
    std::vector<InputPolygon> polygons;
    if (!element && only_curves) {
        for (const FreeForm& curve : file.elements) {
            polygons.push_back(free_form_polygon(file, curve));
            if (file.elements.size() > 1) polygons.back().line = curve.place.line;
        }
        return polygons;
    }
    const FreeForm& one = chosen(file, element);
    if (one.v)
        refuse(fmt::format("{} is a surface", element_name(file, one)),
               "a surface has a grammar along each side: --u G --v G");
    polygons.push_back(free_form_polygon(file, one));
    return polygons;
}

std::vector<InputPolygon> parts(std::string_view text, std::string_view source, Element element, int threads) {
    const bool polylines = is_obj(text, source);
    ParsedPolygons parsed = polylines ? read_obj_polylines(text, source) : read_polygons(text, source, threads);
    if (parsed.polygons.empty()) refuse(std::move(parsed.errors));
    if (!element) return std::move(parsed.polygons);
    InputPolygon& one = parsed.polygons[place_of_element(*element, parsed.polygons.size(), std::string(source))];
    one.break_text.clear();
    std::vector<InputPolygon> only;
    only.push_back(std::move(one));
    return only;
}

} // namespace

bool is_obj(std::string_view text, std::string_view source) {
    return source.ends_with(".obj") || source.ends_with(".OBJ") || looks_like_obj(text);
}

Settled<std::vector<InputPolygon>> polygons_of_file(std::string_view text, std::string_view source, Element element,
                                                    int threads) {
    return settled([&] {
        const bool free_form = is_obj(text, source) && !has_only_polylines(text);
        return free_form ? free_form_polygons(text, source, element) : parts(text, source, element, threads);
    });
}

Settled<InputPolygon> polygon_of_file(std::string_view text, std::string_view source, Element element, int threads) {
    return settled([&] {
        std::vector<InputPolygon> polygons = take(polygons_of_file(text, source, element, threads));
        if (polygons.size() > 1)
            refuse(fmt::format("{} has {} polygons, where one is meant", source, polygons.size()),
                   fmt::format("say which: --element 1 … {}", polygons.size()));
        return std::move(polygons.front());
    });
}

Settled<InputGrid> grid_of_file(std::string_view text, std::string_view source, Element element) {
    return settled([&] {
        if (is_obj(text, source)) {
            const FreeFormFile file = free_forms(text, source);
            const FreeForm& one = chosen(file, element);
            if (!one.v)
                refuse(fmt::format("{} is a curve", element_name(file, one)),
                       "a curve has one grammar: subdivide G FILE");
            return free_form_grid(file, one);
        }
        if (element) refuse(fmt::format("{} is no OBJ file: --element means nothing in it", source));
        ParsedGrid parsed = read_grid_json(text, source);
        if (!parsed.grid) refuse(std::move(parsed.errors));
        return *std::move(parsed.grid);
    });
}

} // namespace internode
