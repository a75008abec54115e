// SPDX-License-Identifier: MIT
//
// The first thing that is wrong ends the reading: a Fault with its place, thrown and caught in this file.

#include "internode/io/json/pyramid_json.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/io/file/limits.h"
#include "internode/io/json/json_reader.h"
#include "internode/text/number.h"

#include <algorithm>
#include <charconv>

namespace internode {

namespace {

/// What is wrong at a value; reading goes no further.
struct Fault {
    TextPlace place;
    std::string message;
};

[[noreturn]] void refuse(const JsonValue& value, std::string message) {
    throw Fault{value.place(), std::move(message)};
}

const JsonValue& member(const JsonValue& object, const std::string& key) {
    if (object.object() == nullptr) refuse(object, "an object with `" + key + "` is wanted here");
    const JsonValue* const value = object.find(key);
    if (value == nullptr) refuse(object, "`" + key + "` is missing");
    return *value;
}

const JsonArray& array(const JsonValue& value, const std::string& what) {
    if (value.array() == nullptr) refuse(value, what + " must be an array, not " + std::string(value.kind()));
    return *value.array();
}

std::string text(const JsonValue& value, const std::string& what) {
    if (value.string() == nullptr) refuse(value, what + " must be a string, not " + std::string(value.kind()));
    return *value.string();
}

bool boolean(const JsonValue& value, const std::string& what) {
    if (value.boolean() == nullptr) refuse(value, what + " must be true or false, not " + std::string(value.kind()));
    return *value.boolean();
}

std::size_t whole(const JsonValue& value, const std::string& what, std::size_t most) {
    std::size_t number = 0;
    const std::string_view digits = value.number() == nullptr ? std::string_view{} : value.number()->text;
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, number);
    if (digits.empty() || read.ec != std::errc{} || read.ptr != end || number > most)
        refuse(value, what + " must be a whole number from 0 to " + std::to_string(most));
    return number;
}

std::vector<std::string> letters(const JsonValue& value) {
    std::vector<std::string> names;
    for (const JsonValue& letter : array(value, "a word")) names.push_back(text(letter, "a symbol"));
    return names;
}

/// Rows of coordinates; the first one settles the dimension where it is 0.
std::vector<double> rows(const JsonValue& value, std::size_t& dimension) {
    std::vector<double> numbers;
    for (const JsonValue& row : array(value, "points")) {
        const JsonArray& coordinates = array(row, "a point");
        if (dimension == 0) dimension = coordinates.size();
        if (coordinates.size() != dimension || dimension == 0 || dimension > max_dimension)
            refuse(row, std::to_string(coordinates.size()) + " coordinates; points here have " +
                            std::to_string(dimension) + ", and at most " + std::to_string(max_dimension));
        for (const JsonValue& coordinate : coordinates) {
            const auto number = coordinate.number() == nullptr ? std::nullopt : parse_double(coordinate.number()->text);
            if (!number) refuse(coordinate, "a coordinate must be a number within the range of doubles");
            numbers.push_back(*number);
        }
    }
    return numbers;
}

void read_grammar(const JsonValue& value, InputPyramid& pyramid) {
    pyramid.name = text(member(value, "name"), "`name`");
    const JsonValue& rules = member(value, "rules");
    if (rules.object() == nullptr) refuse(rules, "`rules` must be an object");
    if (rules.object()->size() > max_symbols) refuse(rules, "more than " + std::to_string(max_symbols) + " symbols");
    for (const JsonMember& rule : *rules.object()) pyramid.rules.push_back({rule.key, letters(rule.value)});
    const JsonValue& axiom = member(value, "axiom");
    if (!axiom.is_null())
        pyramid.axiom = InputWord{letters(member(axiom, "word")), boolean(member(axiom, "closed"), "`closed`")};
}

/// {"value", "exact": [...]}.
InputNumber exact(const JsonValue& value) {
    InputNumber coefficients;
    for (const JsonValue& coefficient : array(member(value, "exact"), "`exact`")) {
        const auto number = parse_rational(text(coefficient, "a coefficient"));
        if (!number) refuse(coefficient, "a coefficient must be an integer or a fraction in a string");
        coefficients.push_back(*number);
    }
    return coefficients;
}

/// [{"name", "length": null or {"exact": [...]}}].
void read_lengths(const JsonValue& value, InputPyramid& pyramid) {
    for (const JsonValue& symbol : array(value, "`symbols`")) {
        const JsonValue& length = member(symbol, "length");
        if (length.is_null()) continue;
        const JsonValue& name = member(symbol, "name");
        InputLength& entry = pyramid.lengths.emplace_back();
        entry.symbol = {text(name, "`name`"), name.place()};
        entry.coefficients = exact(length);
    }
}

void read_method(const JsonValue& root, InputPyramid& pyramid) {
    const JsonValue& method = member(root, "method");
    const std::string name = text(method, "`method`");
    if (name != "least-squares" && name != "local") refuse(method, "`method` must be \"least-squares\" or \"local\"");
    if (name == "least-squares") return;
    pyramid.options.method = ReverseMethod::Local;
    pyramid.options.window = whole(member(root, "window"), "`window`", max_filter_window);
}

PyramidLevel read_level(const JsonValue& value, std::size_t dimension) {
    constexpr std::size_t most = std::size_t{1} << 53; // beyond, JSON's numbers are not whole to everyone
    PyramidLevel level;
    level.points = whole(member(value, "points"), "`points`", most);
    level.inserted = whole(member(value, "inserted"), "`inserted`", most);
    for (const JsonValue& point : array(member(value, "at"), "`at`"))
        level.details.points.push_back(whole(point, "a point of `at`", most));
    level.details.vectors = rows(member(value, "details"), dimension);
    return level;
}

InputPyramid read_root(const JsonValue& root) {
    InputPyramid pyramid;
    const JsonValue& format = member(root, "format");
    if (text(format, "`format`") != "internode-pyramid") refuse(format, "`format` must be \"internode-pyramid\"");
    const JsonValue& version = member(root, "version");
    if (whole(version, "`version`", max_input_degree) != 1) refuse(version, "`version` must be 1");
    pyramid.degree = whole(member(root, "degree"), "`degree`", max_degree);
    read_grammar(member(root, "grammar"), pyramid);
    read_lengths(member(root, "symbols"), pyramid);
    read_method(root, pyramid);
    pyramid.word = {letters(member(root, "word")), boolean(member(root, "closed"), "`closed`")};
    if (const JsonValue* const origin = root.find("origin"); origin != nullptr && !origin->is_null())
        pyramid.origin = exact(*origin);
    pyramid.points = rows(member(root, "points"), pyramid.dimension);
    if (pyramid.points.empty()) refuse(member(root, "points"), "no point");
    for (const JsonValue& level : array(member(root, "levels"), "`levels`"))
        pyramid.levels.push_back(read_level(level, pyramid.dimension));
    return pyramid;
}

} // namespace

ParsedPyramid read_pyramid(std::string_view text, std::string_view source) {
    ParsedPyramid parsed;
    ParsedJson json = read_json(text, source);
    if (!json.value) {
        parsed.errors.push_back(std::move(*json.error));
        return parsed;
    }
    try {
        parsed.pyramid = read_root(*json.value);
        parsed.pyramid->source = source;
    } catch (const Fault& fault) {
        parsed.errors.push_back(diagnostic_at(text, fault.place, source, fault.message));
        parsed.errors.back().code = "json.unexpected";
    }
    return parsed;
}

} // namespace internode
