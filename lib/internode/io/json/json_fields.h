// SPDX-License-Identifier: MIT
//
// The values that a polygon's and a grid's JSON have, read with a diagnostic for whatever is wrong in them.

#pragma once

#include "internode/io/json/json_reader.h"
#include "internode/io/polygon.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

class JsonFields {
public:
    /// Both must outlive the fields.
    JsonFields(std::string_view text, std::string_view source);

    [[nodiscard]] bool good() const { return errors_.empty(); }
    /// Whether the document is to be given up.
    [[nodiscard]] bool full() const;
    /// In the order of the text.
    [[nodiscard]] std::vector<Diagnostic> errors() &&;

    void refuse(const JsonValue& value, std::string message, std::string hint = {});
    void refuse(TextPlace place, std::string message, std::string hint = {});
    /// A key that `owner` ("a grid") has not, with the known key that is nearest to it.
    void refuse_key(const JsonMember& member, const std::string& owner, const std::vector<std::string>& known);

    // Each reads one value, or refuses it.
    [[nodiscard]] std::optional<std::size_t> degree(const JsonValue& value);
    [[nodiscard]] std::optional<bool> boolean(const JsonValue& value, const std::string& name);
    /// Into word_text or word_letters.
    void word(const JsonValue& value, InputPolygon& side);
    [[nodiscard]] std::vector<InputLength> lengths(const JsonValue& value);
    [[nodiscard]] std::vector<InputNumber> knots(const JsonValue& value);
    [[nodiscard]] std::optional<InputNumber> exact(const JsonValue& value);
    /// Appends the coordinates; the first point settles the dimension.
    void point(const JsonValue& value, std::size_t& dimension, std::vector<double>& points);

private:
    void letter(const JsonValue& value, InputPolygon& side);
    bool length(const JsonValue& value, std::vector<Rational>& coefficients);
    bool rational(const JsonValue& value, std::vector<Rational>& coefficients);
    void coordinate(const JsonValue& value, std::vector<double>& points);

    std::string_view text_;
    std::string_view source_;
    std::vector<Diagnostic> errors_;
};

} // namespace internode
