// SPDX-License-Identifier: MIT
//
// A table says which member reads which key. Everything that is wrong is noted and reading goes on, up to
// max_polygon_errors; at the end the errors stand in the order of the text.

#include "internode/io/polygon.h"

#include "internode/curve/homogeneous.h"
#include "internode/io/file/limits.h"
#include "internode/io/json/json_reader.h"
#include "internode/text/did_you_mean.h"
#include "internode/text/number.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <tuple>

namespace internode {

namespace {

class CurveReader {
public:
    CurveReader(std::string_view text, std::string_view source)
        : text_(text)
        , source_(source) {}

    ParsedPolygons read() && {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
        ParsedJson json = read_json(text_, source_);
        if (!json.value) return {.polygons = {}, .errors = {std::move(*json.error)}};
        const bool several = has_format(*json.value, "internode-curves");
        if (several)
            read_curves(*json.value);
        else
            read_one(*json.value);
        if (!several && !polygons_.empty()) polygons_.front().line = 0;
        if (errors_.empty()) return {.polygons = std::move(polygons_), .errors = {}};
        std::ranges::stable_sort(errors_, {}, [](const Diagnostic& d) { return std::tuple(d.line, d.column); });
        return {.polygons = {}, .errors = std::move(errors_)};
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
                refuse(member.place, "a list of curves has no key `" + shortened(member.key) + '`');
        if (const JsonValue* const version = root.find("version")) read_version(*version);
        const JsonValue* const curves = root.find("curves");
        if (curves == nullptr) return refuse(root, "the list has no `curves`");
        if (curves->array() == nullptr) return refuse(*curves, "`curves` must be an array, not " + kind(*curves));
        if (curves->array()->empty()) return refuse(*curves, "no curve");
        for (const JsonValue& curve : *curves->array())
            if (errors_.size() < max_polygon_errors) read_one(curve);
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
        if (weights != nullptr && !weights->is_null() && errors_.empty() && polygon_.weights.size() != polygon_.size())
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
        if (member.key.starts_with("x-") || errors_.size() >= max_polygon_errors) return;
        const auto key = std::ranges::find(keys, member.key, &Key::name);
        if (key != keys.end()) {
            if (!key->may_be_null || !member.value.is_null()) (this->*key->read)(member.value);
            return;
        }
        refuse(member.place, "a curve has no key `" + shortened(member.key) + '`');
        std::vector<std::string> names;
        for (const Key& known : keys) names.emplace_back(known.name);
        const std::string meant = did_you_mean(shortened(member.key), names);
        errors_.back().hint =
            meant.empty() ? "keys that begin with `x-` are passed over" : "did you mean `" + meant + "`?";
    }

    void pass_over(const JsonValue&) {}

    void read_format(const JsonValue& value) {
        if (value.string() == nullptr || *value.string() != "internode-curve")
            refuse(value, "`format` must be \"internode-curve\"");
    }

    void read_version(const JsonValue& value) {
        if (value.number() == nullptr || value.number()->text != "1") refuse(value, "`version` must be 1");
    }

    void read_degree(const JsonValue& value) {
        std::size_t degree = 0;
        const std::string_view text = value.number() == nullptr ? std::string_view{} : value.number()->text;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), degree);
        if (text.empty() || error != std::errc{} || end != text.data() + text.size() || degree > max_input_degree)
            return refuse(value, "`degree` must be a whole number from 0 to " + std::to_string(max_input_degree));
        polygon_.degree = degree;
    }

    void read_closed(const JsonValue& value) {
        if (value.boolean() == nullptr) return refuse(value, "`closed` must be true or false, not " + kind(value));
        polygon_.closed = *value.boolean();
    }

    void read_word(const JsonValue& value) {
        if (value.string() != nullptr) {
            polygon_.word_text = PlacedText{*value.string(), value.place()};
        } else if (value.array() != nullptr) {
            polygon_.word_letters.emplace();
            for (const JsonValue& letter : *value.array()) read_letter(letter);
        } else {
            refuse(value, "`word` must be an array of symbols or a string, not " + kind(value));
        }
    }

    void read_letter(const JsonValue& value) {
        assert(polygon_.word_letters);
        if (value.string() == nullptr) return refuse(value, "a symbol of `word` must be a string, not " + kind(value));
        polygon_.word_letters->push_back({*value.string(), value.place()});
    }

    void read_lengths(const JsonValue& value) {
        if (value.object() == nullptr) return refuse(value, "`lengths` must be an object, not " + kind(value));
        for (const JsonMember& member : *value.object()) {
            InputLength length{{member.key, member.place}, {}};
            if (read_exact(member.value, length.coefficients)) polygon_.lengths.push_back(std::move(length));
        }
    }

    void read_origin(const JsonValue& value) {
        InputNumber origin;
        if (read_exact(value, origin)) polygon_.origin = std::move(origin);
    }

    void read_knots(const JsonValue& value) {
        const JsonArray* const knots = value.array();
        if (knots == nullptr) return refuse(value, "`knots` must be an array, not " + kind(value));
        if (knots->size() > max_knots)
            return refuse(value, std::to_string(knots->size()) + " knots, more than the limit of " +
                                     std::to_string(max_knots));
        polygon_.knots.emplace(knots->size());
        for (std::size_t i = 0; i < knots->size() && errors_.size() < max_polygon_errors; ++i)
            (void)read_exact((*knots)[i], (*polygon_.knots)[i]);
    }

    void read_weights(const JsonValue& value) {
        if (value.array() == nullptr) return refuse(value, "`weights` must be an array, not " + kind(value));
        for (const JsonValue& weight : *value.array()) {
            if (errors_.size() >= max_polygon_errors) return;
            const std::string_view text = weight.number() == nullptr ? std::string_view{} : weight.number()->text;
            const double number = parse_double(text).value_or(0);
            if (first_bad_weight({&number, 1}))
                refuse(weight, "a weight must be a number from " + to_string(smallest_weight) + " to " +
                                   to_string(largest_weight));
            polygon_.weights.push_back(number);
        }
    }

    /// "3/2", 1.5, or {"exact": ["-3", "2"], …} as our own files have it.
    bool read_exact(const JsonValue& value, InputNumber& coefficients) {
        if (value.object() == nullptr) return read_rational(value, coefficients);
        const JsonValue* const exact = value.find("exact");
        if (exact == nullptr || exact->array() == nullptr || exact->array()->empty()) {
            refuse(value, "an exact number as an object needs `exact`, the array of its coefficients");
            return false;
        }
        return std::ranges::all_of(*exact->array(),
                                   [&](const JsonValue& entry) { return read_rational(entry, coefficients); });
    }

    bool read_rational(const JsonValue& value, InputNumber& coefficients) {
        std::string_view text;
        if (value.string() != nullptr) text = *value.string();
        if (value.number() != nullptr) text = value.number()->text;
        std::optional<Rational> rational = parse_rational(text);
        if (!rational) {
            refuse(value, "an exact number must be a number or a string like \"3/2\", with at most " +
                              std::to_string(max_digits) + " digits and an exponent within ±" +
                              std::to_string(max_exponent));
            return false;
        }
        coefficients.push_back(std::move(*rational));
        return true;
    }

    void read_points(const JsonValue& value) {
        if (value.array() == nullptr) return refuse(value, "`points` must be an array, not " + kind(value));
        if (value.array()->empty()) return refuse(value, "no point");
        for (const JsonValue& point : *value.array()) {
            if (errors_.size() >= max_polygon_errors) return;
            read_point(point);
        }
    }

    void read_point(const JsonValue& value) {
        const JsonArray* const coordinates = value.array();
        if (coordinates == nullptr) {
            refuse(value, "a point must be an array of numbers, not " + kind(value));
            if (value.number() != nullptr) errors_.back().hint = "write [[0], [1]] for points on a line";
            return;
        }
        if (coordinates->empty() || coordinates->size() > max_dimension)
            return refuse(value, "a point must have 1 to " + std::to_string(max_dimension) + " coordinates, not " +
                                     std::to_string(coordinates->size()));
        if (polygon_.dimension == 0) polygon_.dimension = coordinates->size();
        if (coordinates->size() != polygon_.dimension)
            return refuse(value, std::to_string(coordinates->size()) + " coordinates, but the first point has " +
                                     std::to_string(polygon_.dimension));
        for (const JsonValue& coordinate : *coordinates) read_coordinate(coordinate);
    }

    void read_coordinate(const JsonValue& value) {
        const JsonNumber* const number = value.number();
        if (number == nullptr) return refuse(value, "a coordinate must be a number, not " + kind(value));
        const std::optional<double> coordinate = parse_double(number->text);
        if (!coordinate) return refuse(value, "a coordinate beyond the range of doubles");
        polygon_.points.push_back(*coordinate);
    }

    static std::string kind(const JsonValue& value) { return std::string(value.kind()); }

    static std::string shortened(const std::string& text) {
        constexpr std::size_t shown = 60;
        return text.size() <= shown ? text : text.substr(0, shown) + "...";
    }

    void refuse(const JsonValue& value, std::string message) { refuse(value.place(), std::move(message)); }

    void refuse(TextPlace place, std::string message) {
        if (errors_.size() >= max_polygon_errors) return;
        errors_.push_back(diagnostic_at(text_, place, source_, std::move(message)));
        errors_.back().code = "json.unexpected";
    }

    std::string_view text_;
    std::string_view source_;
    InputPolygon polygon_; ///< the one that is being read
    std::vector<InputPolygon> polygons_;
    std::vector<Diagnostic> errors_;
};

} // namespace

ParsedPolygons read_polygons_json(std::string_view text, std::string_view source) {
    return CurveReader(text, source).read();
}

} // namespace internode
