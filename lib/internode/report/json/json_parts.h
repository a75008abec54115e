// SPDX-License-Identifier: MIT
//
// The parts that the JSON documents share (docs/json.md): numbers with their certificate, fields, words, grammars.
//
// A number known exactly: {"value", "exact": [c_0, c_1, …]} meaning Σ c_i ρ^i, as many strings as the field has
// degrees; known by enclosure: {"value", "lower", "upper"}. A value beyond the range of double is null.

#pragma once

#include "internode/curve/reverse/resampling.h"
#include "internode/interval/interval_system.h"
#include "internode/interval/quantity.h"
#include "internode/io/json/json_writer.h"
#include "internode/report/generator.h"

#include <optional>
#include <string_view>

namespace internode {

/// "format", "version": 1, "generator".
void write_heading(JsonWriter& json, std::string_view format, const Generator& generator);

/// An exact number of the field, on one line.
void write_number(JsonWriter& json, const Number& number, const NumberField& field);

/// Exact coefficients when the number is known and lies in the field, else its enclosure.
void write_quantity(JsonWriter& json, const Quantity& quantity, const std::optional<NumberField>& field);

/// {"minimal_polynomial": [low degree first], "root"}.
void write_field(JsonWriter& json, const NumberField& field);

/// ["L", "S"], on one line; "0" for the interval of length zero.
void write_word(JsonWriter& json, WordView word, const Alphabet& alphabet);

/// {"name", "rules": {symbol: word}, "axiom": null or {"word", "closed"}}.
void write_grammar(JsonWriter& json, const IntervalGrammar& grammar);

/// "fitting": {"measured", "points", "change"; the object stays open.
void begin_fitting(JsonWriter& json, const Fitting& fitting);

/// "grammar", "field", "ratio" and "symbols" with their lengths, as keys of the open object.
void write_system(JsonWriter& json, const IntervalSystem& system);

} // namespace internode
