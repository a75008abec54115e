// SPDX-License-Identifier: MIT
//
// JSON read into an immutable value that knows its places.
//
// Numbers stay the text that stood in the file: 0.1 is 1/10 to one reader and a double to another, and no locale or
// integer type comes between. Refused beyond JSON's own grammar: a key twice in one object, more than max_json_depth
// open brackets, more than max_json_values values, a byte 0, numbers beyond the range of doubles.

#pragma once

#include "internode/io/file/limits.h"
#include "internode/text/diagnostic.h"
#include "internode/text/place.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace internode {

class JsonValue;
struct JsonMember;

struct JsonNumber {
    std::string text; ///< the number as it stood: "-0", "1e5", "0.10"
};
using JsonArray = std::vector<JsonValue>;
using JsonObject = std::vector<JsonMember>; ///< members in the order of the text, no key twice

class JsonValue {
public:
    using Content = std::variant<std::monostate, bool, JsonNumber, std::string, JsonArray, JsonObject>;

    JsonValue(Content content, TextPlace place);

    [[nodiscard]] bool is_null() const;
    /// The content if it is of that kind, else null.
    [[nodiscard]] const bool* boolean() const;
    [[nodiscard]] const JsonNumber* number() const;
    [[nodiscard]] const std::string* string() const;
    [[nodiscard]] const JsonArray* array() const;
    [[nodiscard]] const JsonObject* object() const;
    /// The member of that name; null if there is none or this is no object.
    [[nodiscard]] const JsonValue* find(std::string_view key) const;
    /// Where the value begins.
    [[nodiscard]] TextPlace place() const { return place_; }
    /// "null", "a boolean", "a number", "a string", "an array", "an object".
    [[nodiscard]] std::string_view kind() const;

private:
    Content content_;
    TextPlace place_;
};

struct JsonMember {
    std::string key;
    TextPlace place; ///< where the key stands
    JsonValue value;
};

struct ParsedJson {
    std::optional<JsonValue> value; ///< present iff error is not
    std::optional<Diagnostic> error;
};

/// Reads a whole text as one JSON value, of at most max_values values in all; a byte order mark is passed over. Never
/// throws on any text but std::bad_alloc. Cost: linear in the text (and n log n in the keys of one object).
[[nodiscard]] ParsedJson read_json(std::string_view text, std::string_view source,
                                   std::uint64_t max_values = max_json_values);

/// A key of the user as an error shows it: at most 60 bytes of it.
[[nodiscard]] std::string shortened(const std::string& text);

} // namespace internode
