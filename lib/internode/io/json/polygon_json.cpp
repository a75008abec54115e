// SPDX-License-Identifier: MIT
//
// A table says which member reads which key. Everything that is wrong is noted and reading goes on until the fields are
// full; at the end the errors stand in the order of the text.

#include "internode/io/polygon.h"

#include "internode/curve/homogeneous.h"
#include "internode/io/file/limits.h"
#include "internode/io/json/json_fields.h"
#include "internode/io/json/json_reader.h"
#include "internode/text/number.h"
#include "internode/text/utf8.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace internode {

namespace {

class CurveReader {
public:
    CurveReader(std::string_view text, std::string_view source)
        : text_(without_byte_order_mark(text))
        , source_(source)
        , fields_(text_, source) {}

    ParsedPolygons read() && {
        ParsedJson json = read_json(text_, source_);
        if (!json.value) return {.polygons = {}, .errors = {std::move(*json.error)}};
        const bool several = has_format(*json.value, "internode-curves");
        if (several)
            read_curves(*json.value);
        else
            read_one(*json.value);
        if (!several && !polygons_.empty()) polygons_.front().line = 0;
        if (!fields_.good()) return {.polygons = {}, .errors = std::move(fields_).errors()};
        return {.polygons = std::move(polygons_), .errors = {}};
    }

private:
    using Read = void (CurveReader::*)(const JsonValue&);
    struct Key {
        std::string_view name;
        Read read;
        bool may_be_null = true;
    };

    static bool has_format(const JsonValue& root, std::string_view name) {
        const JsonValue* const format = root.find("format");
        return format != nullptr && format->string() != nullptr && *format->string() == name;
    }

    /// The object of format "internode-curves": nothing but a version and its curves.
    void read_curves(const JsonValue& root) {
        assert(root.object() != nullptr);
        constexpr std::array<std::string_view, 4> keys{"format", "version", "generator", "curves"};
        for (const JsonMember& member : *root.object())
            if (!member.key.starts_with("x-") && std::ranges::find(keys, member.key) == keys.end())
                fields_.refuse(member.place, "a list of curves has no key `" + shortened(member.key) + '`');
        if (const JsonValue* const version = root.find("version")) read_version(*version);
        const JsonValue* const curves = root.find("curves");
        if (curves == nullptr) return refuse(root, "the list has no `curves`");
        if (curves->array() == nullptr) return refuse(*curves, "`curves` must be an array, not " + kind(*curves));
        if (curves->array()->empty()) return refuse(*curves, "no curve");
        for (const JsonValue& curve : *curves->array())
            if (!fields_.full()) read_one(curve);
    }

    void read_one(const JsonValue& root) {
        polygon_ = {};
        polygon_.source = source_;
        polygon_.line = root.place().line;
        read_root(root);
        polygons_.push_back(std::move(polygon_));
    }

    void read_root(const JsonValue& root) {
        if (root.array() != nullptr) return read_points(root);
        if (root.object() == nullptr) return refuse(root, "a curve is an object or an array of points");
        for (const JsonMember& member : *root.object()) read_member(member);
        if (root.find("points") == nullptr) refuse(root, "the curve has no `points`");
        const JsonValue* const weights = root.find("weights");
        if (weights != nullptr && !weights->is_null() && fields_.good() && polygon_.weights.size() != polygon_.size())
            refuse(*weights, std::to_string(polygon_.weights.size()) + " weights, but " +
                                 std::to_string(polygon_.size()) + " points");
    }

    void read_member(const JsonMember& member) {
        constexpr std::array<Key, 11> keys{{{"format", &CurveReader::read_format, false},
                                            {"version", &CurveReader::read_version, false},
                                            {"generator", &CurveReader::pass_over},
                                            {"degree", &CurveReader::read_degree},
                                            {"closed", &CurveReader::read_closed},
                                            {"word", &CurveReader::read_word},
                                            {"lengths", &CurveReader::read_lengths},
                                            {"origin", &CurveReader::read_origin},
                                            {"knots", &CurveReader::read_knots},
                                            {"weights", &CurveReader::read_weights},
                                            {"points", &CurveReader::read_points, false}}};
        if (member.key.starts_with("x-") || fields_.full()) return;
        const auto key = std::ranges::find(keys, member.key, &Key::name);
        if (key == keys.end()) {
            std::vector<std::string> names;
            for (const Key& known : keys) names.emplace_back(known.name);
            return fields_.refuse_key(member, "a curve", names);
        }
        if (!key->may_be_null || !member.value.is_null()) (this->*key->read)(member.value);
    }

    void pass_over(const JsonValue&) {}

    void read_format(const JsonValue& value) {
        if (value.string() == nullptr || *value.string() != "internode-curve")
            refuse(value, "`format` must be \"internode-curve\"");
    }

    void read_version(const JsonValue& value) {
        if (value.number() == nullptr || value.number()->text != "1") refuse(value, "`version` must be 1");
    }

    void read_degree(const JsonValue& value) { polygon_.degree = fields_.degree(value); }

    void read_closed(const JsonValue& value) { polygon_.closed = fields_.boolean(value, "closed"); }

    void read_word(const JsonValue& value) { fields_.word(value, polygon_); }

    void read_lengths(const JsonValue& value) { polygon_.lengths = fields_.lengths(value); }

    void read_origin(const JsonValue& value) { polygon_.origin = fields_.exact(value); }

    void read_knots(const JsonValue& value) {
        const JsonArray* const knots = value.array();
        if (knots == nullptr) return refuse(value, "`knots` must be an array, not " + kind(value));
        if (knots->size() > max_knots)
            return refuse(value, std::to_string(knots->size()) + " knots, more than the limit of " +
                                     std::to_string(max_knots));
        polygon_.knots = fields_.knots(value);
    }

    void read_weights(const JsonValue& value) {
        if (value.array() == nullptr) return refuse(value, "`weights` must be an array, not " + kind(value));
        for (const JsonValue& weight : *value.array()) {
            if (fields_.full()) return;
            const std::string_view text = weight.number() == nullptr ? std::string_view{} : weight.number()->text;
            const double number = parse_double(text).value_or(0);
            if (first_bad_weight({&number, 1}))
                refuse(weight, "a weight must be a number from " + to_string(smallest_weight) + " to " +
                                   to_string(largest_weight));
            polygon_.weights.push_back(number);
        }
    }

    void read_points(const JsonValue& value) {
        if (value.array() == nullptr) return refuse(value, "`points` must be an array, not " + kind(value));
        if (value.array()->empty()) return refuse(value, "no point");
        for (const JsonValue& point : *value.array()) {
            if (fields_.full()) return;
            fields_.point(point, polygon_.dimension, polygon_.points);
        }
    }

    static std::string kind(const JsonValue& value) { return std::string(value.kind()); }

    void refuse(const JsonValue& value, std::string message) { fields_.refuse(value, std::move(message)); }

    std::string_view text_;
    std::string_view source_;
    InputPolygon polygon_; ///< the one that is being read
    std::vector<InputPolygon> polygons_;
    JsonFields fields_;
};

} // namespace

ParsedPolygons read_polygons_json(std::string_view text, std::string_view source) {
    return CurveReader(text, source).read();
}

} // namespace internode
