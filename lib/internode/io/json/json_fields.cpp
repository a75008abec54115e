// SPDX-License-Identifier: MIT

#include "internode/io/json/json_fields.h"

#include "internode/io/file/limits.h"
#include "internode/text/did_you_mean.h"
#include "internode/text/number.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <tuple>

namespace internode {

namespace {

std::string kind(const JsonValue& value) {
    return std::string(value.kind());
}

} // namespace

JsonFields::JsonFields(std::string_view text, std::string_view source)
    : text_(text)
    , source_(source) {}

bool JsonFields::full() const {
    return errors_.size() >= max_polygon_errors;
}

std::vector<Diagnostic> JsonFields::errors() && {
    std::ranges::stable_sort(errors_, {}, [](const Diagnostic& d) { return std::tuple(d.line, d.column); });
    return std::move(errors_);
}

void JsonFields::refuse(const JsonValue& value, std::string message, std::string hint) {
    refuse(value.place(), std::move(message), std::move(hint));
}

void JsonFields::refuse(TextPlace place, std::string message, std::string hint) {
    if (full()) return;
    errors_.push_back(diagnostic_at(text_, place, source_, std::move(message)));
    errors_.back().hint = std::move(hint);
    errors_.back().code = "json.unexpected";
}

void JsonFields::refuse_key(const JsonMember& member, const std::string& owner, const std::vector<std::string>& known) {
    const std::string meant = did_you_mean(shortened(member.key), known);
    refuse(member.place, owner + " has no key `" + shortened(member.key) + '`',
           meant.empty() ? "keys that begin with `x-` are passed over" : "did you mean `" + meant + "`?");
}

std::optional<std::size_t> JsonFields::degree(const JsonValue& value) {
    std::size_t number = 0;
    const std::string_view text = value.number() == nullptr ? std::string_view{} : value.number()->text;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (!text.empty() && error == std::errc{} && end == text.data() + text.size() && number <= max_input_degree)
        return number;
    refuse(value, "`degree` must be a whole number from 0 to " + std::to_string(max_input_degree));
    return std::nullopt;
}

std::optional<bool> JsonFields::boolean(const JsonValue& value, const std::string& name) {
    if (value.boolean() != nullptr) return *value.boolean();
    refuse(value, "`" + name + "` must be true or false, not " + kind(value));
    return std::nullopt;
}

void JsonFields::word(const JsonValue& value, InputPolygon& side) {
    if (value.string() != nullptr) {
        side.word_text = PlacedText{*value.string(), value.place()};
    } else if (value.array() != nullptr) {
        side.word_letters.emplace();
        for (const JsonValue& entry : *value.array()) letter(entry, side);
    } else {
        refuse(value, "`word` must be an array of symbols or a string, not " + kind(value));
    }
}

void JsonFields::letter(const JsonValue& value, InputPolygon& side) {
    assert(side.word_letters);
    if (value.string() == nullptr) return refuse(value, "a symbol of `word` must be a string, not " + kind(value));
    side.word_letters->push_back({*value.string(), value.place()});
}

std::vector<InputLength> JsonFields::lengths(const JsonValue& value) {
    std::vector<InputLength> result;
    if (value.object() == nullptr) {
        refuse(value, "`lengths` must be an object, not " + kind(value));
        return result;
    }
    for (const JsonMember& member : *value.object()) {
        InputLength entry{{member.key, member.place}, {}};
        if (length(member.value, entry.coefficients)) result.push_back(std::move(entry));
    }
    return result;
}

std::vector<InputNumber> JsonFields::knots(const JsonValue& value) {
    const JsonArray* const array = value.array();
    if (array == nullptr || array->size() > max_knots) {
        refuse(value, "`knots` must be an array of at most " + std::to_string(max_knots) + " knots");
        return {};
    }
    std::vector<InputNumber> knots(array->size());
    for (std::size_t i = 0; i < knots.size() && !full(); ++i) (void)length((*array)[i], knots[i]);
    return knots;
}

std::optional<InputNumber> JsonFields::exact(const JsonValue& value) {
    InputNumber number;
    if (!length(value, number)) return std::nullopt;
    return number;
}

/// "3/2", 1.5, or {"exact": ["-3", "2"], …} as our own files have it.
bool JsonFields::length(const JsonValue& value, std::vector<Rational>& coefficients) {
    if (value.object() == nullptr) return rational(value, coefficients);
    const JsonValue* const exact = value.find("exact");
    if (exact == nullptr || exact->array() == nullptr || exact->array()->empty()) {
        refuse(value, "an exact number as an object needs `exact`, the array of its coefficients");
        return false;
    }
    return std::ranges::all_of(*exact->array(), [&](const JsonValue& entry) { return rational(entry, coefficients); });
}

bool JsonFields::rational(const JsonValue& value, std::vector<Rational>& coefficients) {
    std::string_view text;
    if (value.string() != nullptr) text = *value.string();
    if (value.number() != nullptr) text = value.number()->text;
    std::optional<Rational> number = parse_rational(text);
    if (!number) {
        refuse(value, "an exact number must be a number or a string like \"3/2\", with at most " +
                          std::to_string(max_digits) + " digits and an exponent within ±" +
                          std::to_string(max_exponent));
        return false;
    }
    coefficients.push_back(std::move(*number));
    return true;
}

void JsonFields::point(const JsonValue& value, std::size_t& dimension, std::vector<double>& points) {
    const JsonArray* const coordinates = value.array();
    if (coordinates == nullptr)
        return refuse(value, "a point must be an array of numbers, not " + kind(value),
                      value.number() == nullptr ? "" : "write [[0], [1]] for points on a line");
    if (coordinates->empty() || coordinates->size() > max_dimension)
        return refuse(value, "a point must have 1 to " + std::to_string(max_dimension) + " coordinates, not " +
                                 std::to_string(coordinates->size()));
    if (dimension == 0) dimension = coordinates->size();
    if (coordinates->size() != dimension)
        return refuse(value, std::to_string(coordinates->size()) + " coordinates, but the first point has " +
                                 std::to_string(dimension));
    for (const JsonValue& entry : *coordinates) coordinate(entry, points);
}

void JsonFields::coordinate(const JsonValue& value, std::vector<double>& points) {
    const JsonNumber* const number = value.number();
    if (number == nullptr) return refuse(value, "a coordinate must be a number, not " + kind(value));
    const std::optional<double> parsed = parse_double(number->text);
    if (!parsed) return refuse(value, "a coordinate beyond the range of doubles");
    points.push_back(*parsed);
}

} // namespace internode
