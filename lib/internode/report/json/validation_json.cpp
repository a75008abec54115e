// SPDX-License-Identifier: MIT

#include "internode/report/json/validation_json.h"

#include "internode/report/json/json_parts.h"

#include <cassert>

namespace internode {

namespace {

void write_optional(JsonWriter& json, const std::optional<bool>& value) {
    if (value)
        json.boolean(*value);
    else
        json.null();
}

void write_decision(JsonWriter& json, const Verdict& verdict) {
    json.key("valid");
    if (verdict.decision == Decision::Undecided)
        json.null();
    else
        json.boolean(verdict.decision == Decision::Valid);
    json.key("exactness").string(verdict.exact ? "exact" : "enclosure");
    json.key("theorems").begin_array(one_line);
    for (const std::string& theorem : verdict.theorems) json.string(theorem);
    json.end_array();
}

void write_ratio(JsonWriter& json, const Verdict& verdict) {
    json.key("field");
    if (verdict.field)
        write_field(json, *verdict.field);
    else
        json.null();
    json.key("ratio");
    write_quantity(json, verdict.ratio, verdict.field);
    json.key("enclosure").begin_object(one_line);
    json.key("lower").number(verdict.ratio.bounds.lower);
    json.key("upper").number(verdict.ratio.bounds.upper);
    json.end_object();
    json.key("pisot");
    write_optional(json, verdict.pisot);
    json.key("period").integer(verdict.period);
}

void write_symbols(JsonWriter& json, const Verdict& verdict, const Alphabet& alphabet) {
    assert(verdict.occurs.size() == alphabet.size());
    const auto write_entry = [&](const std::vector<Quantity>& quantities, std::size_t i) {
        if (i < quantities.size() && verdict.occurs[i])
            write_quantity(json, quantities[i], verdict.field);
        else
            json.null();
    };
    json.key("symbols").begin_array();
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        json.begin_object(one_line).key("name").string(alphabet.name(to_symbol(i)));
        json.key("length");
        write_entry(verdict.lengths, i);
        json.key("frequency");
        write_entry(verdict.frequencies, i);
        json.end_object();
    }
    json.end_array();
    json.key("free_lengths").integer(verdict.free_lengths);
}

void write_classes(JsonWriter& json, const Verdict& verdict, const Alphabet& alphabet) {
    json.key("classes").begin_array();
    for (const SymbolClass& symbol_class : verdict.classes) {
        json.begin_object(one_line).key("symbols");
        write_word(json, symbol_class.symbols, alphabet);
        json.key("final").boolean(symbol_class.final);
        json.key("basic");
        write_optional(json, symbol_class.basic);
        json.key("period").integer(symbol_class.period);
        json.key("ratio");
        write_quantity(json, symbol_class.ratio, verdict.field);
        json.end_object();
    }
    json.end_array();
}

void write_reasons(JsonWriter& json, const Verdict& verdict, const Alphabet& alphabet) {
    json.key("reasons").begin_array();
    for (const Reason& reason : verdict.reasons) {
        json.begin_object(one_line).key("code").string(to_string(reason.code));
        json.key("symbols");
        write_word(json, reason.symbols, alphabet);
        json.key("message").string(reason.message).end_object();
    }
    json.end_array();
}

} // namespace

std::string validation_json(const Verdict& verdict, const IntervalGrammar& grammar, const Generator& generator) {
    StringSink sink;
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-validation", generator);
    json.key("grammar");
    write_grammar(json, grammar);
    write_decision(json, verdict);
    write_ratio(json, verdict);
    write_symbols(json, verdict, grammar.alphabet);
    write_classes(json, verdict, grammar.alphabet);
    write_reasons(json, verdict, grammar.alphabet);
    json.end_object().finish();
    return sink.text();
}

} // namespace internode
