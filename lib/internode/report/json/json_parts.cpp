// SPDX-License-Identifier: MIT

#include "internode/report/json/json_parts.h"

#include <cmath>
#include <stdexcept>

namespace internode {

namespace {

void write_finite(JsonWriter& json, std::string_view key, double value) {
    json.key(key);
    if (std::isfinite(value))
        json.number(value);
    else
        json.null();
}

/// The coefficients of a number that may belong to another field.
std::optional<std::vector<Rational>> coefficients_in(const Quantity& quantity,
                                                     const std::optional<NumberField>& field) {
    if (!quantity.exact || !field) return std::nullopt;
    try {
        return quantity.exact->coefficients(*field);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

void write_exact(JsonWriter& json, double value, const std::vector<Rational>& coefficients) {
    json.begin_object(one_line);
    write_finite(json, "value", value);
    json.key("exact").begin_array(one_line);
    for (const Rational& coefficient : coefficients) json.string(to_string(coefficient));
    json.end_array().end_object();
}

} // namespace

void write_heading(JsonWriter& json, std::string_view format, const Generator& generator) {
    json.key("format").string(format);
    json.key("version").integer(1);
    json.key("generator").begin_object(one_line);
    json.key("version").string(generator.version);
    json.key("command").string(generator.command);
    json.end_object();
}

void write_number(JsonWriter& json, const Number& number, const NumberField& field) {
    write_exact(json, number.to_double(), number.coefficients(field));
}

void write_quantity(JsonWriter& json, const Quantity& quantity, const std::optional<NumberField>& field) {
    if (const auto coefficients = coefficients_in(quantity, field)) {
        write_exact(json, quantity.value, *coefficients);
        return;
    }
    json.begin_object(one_line);
    write_finite(json, "value", quantity.value);
    write_finite(json, "lower", quantity.bounds.lower);
    write_finite(json, "upper", quantity.bounds.upper);
    json.end_object();
}

void write_field(JsonWriter& json, const NumberField& field) {
    json.begin_object(one_line);
    json.key("minimal_polynomial").begin_array(one_line);
    for (const Integer& coefficient : field.minimal_polynomial()) json.string(coefficient.get_str());
    json.end_array();
    write_finite(json, "root", field.generator().to_double());
    json.end_object();
}

void write_word(JsonWriter& json, WordView word, const Alphabet& alphabet) {
    json.begin_array(one_line);
    for (const Symbol symbol : word) json.string(alphabet.name(symbol));
    json.end_array();
}

void write_grammar(JsonWriter& json, const IntervalGrammar& grammar) {
    json.begin_object();
    json.key("name").string(grammar.name);
    json.key("rules").begin_object();
    for (std::size_t i = 0; i < grammar.alphabet.size(); ++i) {
        json.key(grammar.alphabet.name(to_symbol(i)));
        write_word(json, grammar.rules.image(to_symbol(i)), grammar.alphabet);
    }
    json.end_object();
    json.key("axiom");
    if (grammar.axiom) {
        json.begin_object(one_line).key("word");
        write_word(json, grammar.axiom->word, grammar.alphabet);
        json.key("closed").boolean(grammar.axiom->ends == Ends::Circular).end_object();
    } else {
        json.null();
    }
    json.end_object();
}

void begin_fitting(JsonWriter& json, const Fitting& fitting) {
    json.key("fitting").begin_object(one_line).key("measured").integer(fitting.measured);
    json.key("points").integer(fitting.points).key("change");
    json.string(fitting.fit == Fit::AsMeasured ? "none" : fitting.fit == Fit::Cut ? "cut" : "resampled");
}

void write_system(JsonWriter& json, const IntervalSystem& system) {
    json.key("grammar");
    write_grammar(json, system.grammar());
    json.key("field");
    write_field(json, system.field());
    json.key("ratio");
    write_number(json, system.ratio(), system.field());
    json.key("symbols").begin_array();
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) {
        const Symbol symbol = to_symbol(i);
        json.begin_object(one_line).key("name").string(system.alphabet().name(symbol)).key("length");
        if (system.occurs(symbol))
            write_number(json, system.length(symbol), system.field());
        else
            json.null();
        json.end_object();
    }
    json.end_array();
}

} // namespace internode
