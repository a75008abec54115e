// SPDX-License-Identifier: MIT
//
// One pass over the statements: vertices are kept, the indices of an `l` make a polyline or lengthen the one before.
// Points are copied at the end, when it is known what belongs together.

#include "internode/io/obj/obj_polylines.h"

#include "internode/io/obj/obj_statement.h"
#include "internode/text/number.h"

#include <cassert>
#include <charconv>

namespace internode {

namespace {

constexpr std::size_t polyline_row = 3;   // x, y, z
constexpr std::size_t longest_line = 256; // indices that write_obj puts into an `l`

struct Polyline {
    std::size_t line = 0; ///< the line of the text where it begins
    std::vector<std::size_t> vertices;
    std::size_t last_count = 0; ///< indices of its last `l`
};

class PolylineReader {
public:
    PolylineReader(std::string_view text, std::string_view source, const ObjLimits& limits)
        : text_(text)
        , source_(source)
        , words_(text)
        , limits_(limits) {}

    ParsedPolygons read() && {
        while (errors_.size() < max_polygon_errors) {
            const auto keyword = words_.next_statement();
            if (!keyword) break;
            if (keyword->text == "v")
                read_vertex(*keyword);
            else if (keyword->text == "l")
                read_line(*keyword);
            else
                pass_over(*keyword);
        }
        if (!errors_.empty()) return {.polygons = {}, .errors = std::move(errors_)};
        ParsedPolygons parsed;
        for (const Polyline& polyline : polylines_) parsed.polygons.push_back(polygon_of(polyline));
        if (parsed.polygons.size() == 1) parsed.polygons.front().line = 0;
        return parsed;
    }

private:
    void pass_over(const ObjWord& keyword) {
        const ObjStatement statement = obj_statement(keyword.text);
        // A new object or group never goes on with the polyline of the one before.
        if (keyword.text == "o" || keyword.text == "g") may_go_on_ = false;
        if (statement == ObjStatement::Foreign)
            refuse(keyword, obj_quoted(keyword.text) + " reaches out of the file: it is not followed");
        if (statement == ObjStatement::Unknown) refuse(keyword, obj_quoted(keyword.text) + " is no statement of OBJ");
    }

    void read_vertex(const ObjWord& keyword) {
        if (vertices_.size() / polyline_row >= limits_.vertices) return refuse_limit(keyword, "vertices");
        std::size_t count = 0;
        while (const auto word = words_.next()) {
            const std::optional<double> number = parse_double(word->text);
            if (!number) return refuse(*word, obj_quoted(word->text) + " is not a number within the range of doubles");
            if (count < polyline_row) vertices_.push_back(*number); // a weight or a colour may follow
            ++count;
        }
        vertices_.resize((vertices_.size() + polyline_row - 1) / polyline_row * polyline_row);
        if (count < polyline_row) refuse(keyword, "a vertex needs x, y and z");
    }

    void read_line(const ObjWord& keyword) {
        std::vector<std::size_t> indices;
        while (const auto word = words_.next()) {
            if (indices_++ >= limits_.vertices) return refuse_limit(*word, "indices");
            const auto index = vertex(*word);
            if (!index) return;
            indices.push_back(*index);
        }
        if (indices.size() < 2) return refuse(keyword, "`l` needs two vertices at least");
        if (!goes_on(indices)) {
            known_place_ = place_of(text_, keyword.offset, known_offset_, known_place_);
            known_offset_ = keyword.offset;
            polylines_.push_back({.line = known_place_.line, .vertices = {}, .last_count = 0});
        }
        Polyline& polyline = polylines_.back();
        polyline.last_count = indices.size();
        polyline.vertices.insert(polyline.vertices.end(), indices.begin() + (polyline.vertices.empty() ? 0 : 1),
                                 indices.end());
        may_go_on_ = true;
    }

    /// Whether the indices lengthen the last polyline.
    [[nodiscard]] bool goes_on(const std::vector<std::size_t>& indices) const {
        if (!may_go_on_ || polylines_.empty()) return false;
        const Polyline& last = polylines_.back();
        assert(last.vertices.size() >= 2);
        if (last.vertices.front() == last.vertices.back() || last.vertices.back() != indices.front()) return false;
        return last.last_count == longest_line || (last.last_count == 2 && indices.size() == 2);
    }

    /// The vertex of `3`, `-1` or `3/7`, from 0.
    std::optional<std::size_t> vertex(const ObjWord& word) {
        const std::string_view text = word.text.substr(0, word.text.find('/'));
        const std::size_t count = vertices_.size() / polyline_row;
        std::int64_t value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const auto most = static_cast<std::int64_t>(count);
        if (error == std::errc{} && stop == end && value != 0 && value >= -most && value <= most)
            return value > 0 ? static_cast<std::size_t>(value) - 1 : count - static_cast<std::size_t>(-value);
        refuse(word, "no vertex " + obj_quoted(text) + ": " + std::to_string(count) +
                         (count == 1 ? " stands" : " stand") + " before");
        errors_.back().hint = "indices count from 1, or from -1 backwards";
        return std::nullopt;
    }

    [[nodiscard]] InputPolygon polygon_of(const Polyline& polyline) const {
        InputPolygon polygon;
        polygon.source = source_;
        polygon.dimension = polyline_row;
        polygon.line = polyline.line;
        const bool closed = polyline.vertices.size() > 3 && polyline.vertices.front() == polyline.vertices.back();
        if (closed) polygon.closed = true;
        const std::size_t count = polyline.vertices.size() - (closed ? 1 : 0);
        polygon.points.reserve(count * polyline_row);
        for (std::size_t i = 0; i < count; ++i) {
            assert((polyline.vertices[i] + 1) * polyline_row <= vertices_.size());
            const auto first = vertices_.begin() + static_cast<std::ptrdiff_t>(polyline.vertices[i] * polyline_row);
            polygon.points.insert(polygon.points.end(), first, first + polyline_row);
        }
        return polygon;
    }

    void refuse_limit(const ObjWord& word, const std::string& what) {
        refuse(word, "more than " + std::to_string(limits_.vertices) + " " + what + ", the limit");
    }

    void refuse(const ObjWord& word, std::string message) {
        Diagnostic diagnostic = diagnostic_at(text_, word.offset, source_, std::move(message));
        diagnostic.width = columns_of(word.text);
        errors_.push_back(std::move(diagnostic));
    }

    std::string_view text_;
    std::string_view source_;
    ObjWords words_;
    ObjLimits limits_;
    std::vector<double> vertices_;
    std::vector<Polyline> polylines_;
    bool may_go_on_ = false;
    std::uint64_t indices_ = 0; ///< indices of all polylines
    std::size_t known_offset_ = 0;
    TextPlace known_place_;
    std::vector<Diagnostic> errors_;
};

} // namespace

bool has_only_polylines(std::string_view text) {
    ObjWords words(text);
    bool any = false;
    while (const auto keyword = words.next_statement()) {
        const ObjStatement statement = obj_statement(keyword->text);
        if (statement == ObjStatement::Curve || statement == ObjStatement::Surface) return false;
        any = any || keyword->text == "l";
    }
    return any;
}

ParsedPolygons read_obj_polylines(std::string_view text, std::string_view source, const ObjLimits& limits) {
    return PolylineReader(text, source, limits).read();
}

} // namespace internode
