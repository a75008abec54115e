// SPDX-License-Identifier: MIT

#include "internode/io/json/input_grid.h"

#include "internode/io/json/json_fields.h"
#include "internode/io/json/json_reader.h"
#include "internode/text/utf8.h"

#include <algorithm>

namespace internode {

namespace {

class GridReader {
public:
    GridReader(std::string_view text, std::string_view source)
        : text_(without_byte_order_mark(text))
        , fields_(text_, source) {
        grid_.source = source;
        for (InputPolygon& side : grid_.sides) side.source = source;
    }

    ParsedGrid read() && {
        ParsedJson json = read_json(text_, grid_.source);
        if (!json.value) return {.grid = {}, .errors = {std::move(*json.error)}};
        read_root(*json.value);
        if (fields_.good()) return {.grid = std::move(grid_), .errors = {}};
        return {.grid = {}, .errors = std::move(fields_).errors()};
    }

private:
    using Read = void (GridReader::*)(const JsonValue&);
    using ReadSide = void (GridReader::*)(const JsonValue&, InputPolygon&);
    struct Key {
        std::string_view name;
        Read read;
        bool may_be_null = true;
    };

    void read_root(const JsonValue& root) {
        if (root.object() == nullptr)
            return fields_.refuse(root, "a grid is an object, not " + std::string(root.kind()));
        for (const JsonMember& member : *root.object()) read_member(member);
        if (root.find("points") == nullptr) fields_.refuse(root, "the grid has no `points`");
        if (grid_.rational && grid_.dimension == 1)
            fields_.refuse(root, "points of a rational grid have at least one coordinate and the weight");
    }

    void read_member(const JsonMember& member) {
        constexpr std::array<Key, 11> keys{{{"format", &GridReader::read_format, false},
                                            {"version", &GridReader::read_version, false},
                                            {"generator", &GridReader::pass_over},
                                            {"degree", &GridReader::read_degrees},
                                            {"closed", &GridReader::read_ends},
                                            {"rational", &GridReader::read_rational},
                                            {"word", &GridReader::read_words},
                                            {"lengths", &GridReader::read_lengths},
                                            {"origin", &GridReader::read_origins},
                                            {"knots", &GridReader::read_knots},
                                            {"points", &GridReader::read_rows, false}}};
        if (member.key.starts_with("x-") || fields_.full()) return;
        const auto key = std::ranges::find(keys, member.key, &Key::name);
        if (key != keys.end()) {
            if (!key->may_be_null || !member.value.is_null()) (this->*key->read)(member.value);
            return;
        }
        std::vector<std::string> names;
        for (const Key& known : keys) names.emplace_back(known.name);
        fields_.refuse_key(member, "a grid", names);
    }

    void pass_over(const JsonValue&) {}

    void read_format(const JsonValue& value) {
        if (value.string() == nullptr || *value.string() != "internode-grid")
            fields_.refuse(value, "`format` must be \"internode-grid\"");
    }

    void read_version(const JsonValue& value) {
        if (value.number() == nullptr || value.number()->text != "1") fields_.refuse(value, "`version` must be 1");
    }

    /// [of u, of v], either of which may be null.
    void read_sides(const JsonValue& value, const std::string& name, ReadSide read_side) {
        if (value.array() == nullptr || value.array()->size() != 2)
            return fields_.refuse(value, "`" + name + "` must be an array of two, along u and along v");
        for (std::size_t k = 0; k < 2; ++k)
            if (const JsonValue& side = (*value.array())[k]; !side.is_null()) (this->*read_side)(side, grid_.sides[k]);
    }

    void read_degrees(const JsonValue& value) { read_sides(value, "degree", &GridReader::read_degree); }
    void read_ends(const JsonValue& value) { read_sides(value, "closed", &GridReader::read_closed); }
    void read_words(const JsonValue& value) { read_sides(value, "word", &GridReader::read_word); }
    void read_lengths(const JsonValue& value) { read_sides(value, "lengths", &GridReader::read_side_lengths); }

    void read_origins(const JsonValue& value) { read_sides(value, "origin", &GridReader::read_origin); }

    void read_knots(const JsonValue& value) { read_sides(value, "knots", &GridReader::read_side_knots); }

    void read_degree(const JsonValue& value, InputPolygon& side) { side.degree = fields_.degree(value); }
    void read_closed(const JsonValue& value, InputPolygon& side) { side.closed = fields_.boolean(value, "closed"); }
    void read_word(const JsonValue& value, InputPolygon& side) { fields_.word(value, side); }
    void read_side_lengths(const JsonValue& value, InputPolygon& side) { side.lengths = fields_.lengths(value); }

    void read_origin(const JsonValue& value, InputPolygon& side) { side.origin = fields_.exact(value); }

    void read_side_knots(const JsonValue& value, InputPolygon& side) { side.knots = fields_.knots(value); }

    void read_rational(const JsonValue& value) { grid_.rational = fields_.boolean(value, "rational").value_or(false); }

    void read_rows(const JsonValue& value) {
        if (value.array() == nullptr)
            return fields_.refuse(value, "`points` must be an array of rows, not " + std::string(value.kind()));
        if (value.array()->empty()) return fields_.refuse(value, "no point");
        grid_.rows = value.array()->size();
        for (const JsonValue& row : *value.array()) {
            if (fields_.full()) return;
            read_row(row);
        }
    }

    void read_row(const JsonValue& value) {
        const JsonArray* const row = value.array();
        if (row == nullptr)
            return fields_.refuse(value, "a row must be an array of points, not " + std::string(value.kind()));
        if (row->empty()) return fields_.refuse(value, "a row without points");
        if (grid_.columns == 0) grid_.columns = row->size();
        if (row->size() != grid_.columns)
            return fields_.refuse(value, std::to_string(row->size()) + " points, but the first row has " +
                                             std::to_string(grid_.columns));
        for (const JsonValue& point : *row) {
            if (fields_.full()) return;
            fields_.point(point, grid_.dimension, grid_.points);
        }
    }

    std::string_view text_;
    JsonFields fields_;
    InputGrid grid_;
};

} // namespace

ParsedGrid read_grid_json(std::string_view text, std::string_view source) {
    return GridReader(text, source).read();
}

} // namespace internode
