// SPDX-License-Identifier: MIT
//
// nlohmann's parser is used for its event interface alone: its values would be copied and destroyed by recursion, and
// its integers and doubles forget how they were written. Events carry no places; the iterator counts the bytes taken,
// and between two events there are only blanks, commas and colons.

#include "internode/io/json/json_reader.h"

#include "internode/text/utf8.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>

namespace internode {

namespace {

/// The code of every error of a text that is no JSON, or too much of it.
constexpr std::string_view unreadable = "json.unreadable";

/// Reads bytes and says how many were taken, also when copied into the parser.
class CountingIterator {
public:
    // The names that std::iterator_traits looks for. NOLINTBEGIN(readability-identifier-naming)
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    // NOLINTEND(readability-identifier-naming)

    CountingIterator(const char* position, std::size_t* taken)
        : position_(position)
        , taken_(taken) {}

    reference operator*() const { return *position_; }
    CountingIterator& operator++() {
        ++position_;
        ++*taken_;
        return *this;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.position_ == b.position_; }

private:
    const char* position_;
    std::size_t* taken_;
};

/// An array or object that is not closed yet.
struct OpenValue {
    bool is_object = false;
    TextPlace place;
    JsonArray items;
    JsonObject members;
    std::set<std::string> keys;
    std::string key; ///< the key of the member whose value comes next
    TextPlace key_place;
};

class Builder final : public nlohmann::json_sax<nlohmann::json> {
public:
    Builder(std::string_view text, std::string_view source, const std::size_t& taken, std::uint64_t max_values)
        : text_(text)
        , source_(source)
        , taken_(taken)
        , max_values_(max_values) {}

    ParsedJson take() && {
        if (error_) root_.reset(); // the error may come after the value
        return {.value = std::move(root_), .error = std::move(error_)};
    }

    bool null() override { return literal(std::monostate{}, 4); }
    bool boolean(bool value) override { return literal(value, value ? 4 : 5); }
    bool number_integer(number_integer_t) override { return number(); }
    bool number_unsigned(number_unsigned_t) override { return number(); }
    bool number_float(number_float_t, const string_t&) override { return number(); }
    bool binary(binary_t&) override { return false; } // not in text

    bool string(string_t& value) override {
        const TextPlace place = begin_token();
        cursor_ = taken_;
        return add(JsonValue(std::move(value), place));
    }

    bool start_object(std::size_t) override { return open(true); }
    bool start_array(std::size_t) override { return open(false); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& value) override {
        assert(!open_.empty() && open_.back().is_object);
        OpenValue& object = open_.back();
        object.key_place = begin_token();
        if (!object.keys.insert(value).second) return refuse("the key `" + shortened(value) + "` stands here twice");
        cursor_ = taken_;
        object.key = std::move(value);
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& exception) override {
        begin_token();
        constexpr int number_overflow = 406;
        if (exception.id == number_overflow) return refuse("a number beyond the range of doubles");
        const std::string_view token = text_.substr(cursor_);
        const bool not_finite = token.starts_with('N') || token.starts_with('I') || token.starts_with("-I") ||
                                token.starts_with("nan") || token.starts_with("inf");
        error_ = diagnostic_at(text_, position == 0 ? 0 : position - 1, source_, explanation(exception.what()));
        error_->code = unreadable;
        if (not_finite) error_->hint = "JSON has neither NaN nor Infinity";
        return false;
    }

private:
    /// "[json.exception…] parse error at …: syntax error while parsing value - WHAT; last read: '…'; expected THIS"
    /// without what the diagnostic shows itself.
    static std::string explanation(std::string_view what) {
        const std::size_t dash = what.find(" - ");
        if (dash != std::string_view::npos) what.remove_prefix(dash + 3);
        std::string text = "not JSON: " + std::string(what.substr(0, what.find("; ")));
        const std::size_t expected = what.rfind("; expected ");
        if (expected != std::string_view::npos && what.size() - expected < 100) text += what.substr(expected);
        return text;
    }

    /// Moves cursor_ to the next token and returns its place.
    TextPlace begin_token() {
        assert(counted_ <= cursor_ && cursor_ <= text_.size());
        const std::size_t begin = std::min(text_.find_first_not_of(" \t\r\n,:", cursor_), text_.size());
        place_ = place_of(text_, begin, counted_, place_);
        cursor_ = counted_ = begin;
        return place_;
    }

    bool literal(JsonValue::Content content, std::size_t size) {
        const TextPlace place = begin_token();
        cursor_ += size;
        return add(JsonValue(std::move(content), place));
    }

    bool number() {
        const TextPlace place = begin_token();
        const std::size_t end = std::min(text_.find_first_not_of("0123456789+-.eE", cursor_), text_.size());
        std::string raw(text_.substr(cursor_, end - cursor_));
        cursor_ = end;
        return add(JsonValue(JsonNumber{std::move(raw)}, place));
    }

    bool open(bool is_object) {
        const TextPlace place = begin_token();
        if (open_.size() == max_json_depth)
            return refuse("brackets open " + std::to_string(max_json_depth) + " deep are the most allowed");
        ++cursor_;
        open_.emplace_back();
        open_.back().is_object = is_object;
        open_.back().place = place;
        return true;
    }

    bool close() {
        assert(!open_.empty());
        begin_token();
        ++cursor_;
        OpenValue closed = std::move(open_.back());
        open_.pop_back();
        if (closed.is_object) return add(JsonValue(std::move(closed.members), closed.place));
        closed.items.shrink_to_fit();
        return add(JsonValue(std::move(closed.items), closed.place));
    }

    bool add(JsonValue value) {
        if (++values_ > max_values_) return refuse("more than " + std::to_string(max_values_) + " values");
        if (open_.empty()) {
            root_ = std::move(value);
        } else if (OpenValue& parent = open_.back(); parent.is_object) {
            parent.members.push_back({std::move(parent.key), parent.key_place, std::move(value)});
        } else {
            parent.items.push_back(std::move(value));
        }
        return true;
    }

    /// An error at the token that begins at the cursor.
    bool refuse(std::string message) {
        error_ = diagnostic_at(text_, cursor_, source_, std::move(message));
        error_->code = unreadable;
        return false;
    }

    std::string_view text_;
    std::string_view source_;
    const std::size_t& taken_;
    std::uint64_t max_values_;
    std::size_t cursor_ = 0;  ///< end of the last token
    std::size_t counted_ = 0; ///< place_ is the place of this byte
    TextPlace place_;
    std::uint64_t values_ = 0;
    std::vector<OpenValue> open_;
    std::optional<JsonValue> root_;
    std::optional<Diagnostic> error_;
};

} // namespace

JsonValue::JsonValue(Content content, TextPlace place)
    : content_(std::move(content))
    , place_(place) {}

bool JsonValue::is_null() const {
    return std::holds_alternative<std::monostate>(content_);
}

const bool* JsonValue::boolean() const {
    return std::get_if<bool>(&content_);
}

const JsonNumber* JsonValue::number() const {
    return std::get_if<JsonNumber>(&content_);
}

const std::string* JsonValue::string() const {
    return std::get_if<std::string>(&content_);
}

const JsonArray* JsonValue::array() const {
    return std::get_if<JsonArray>(&content_);
}

const JsonObject* JsonValue::object() const {
    return std::get_if<JsonObject>(&content_);
}

const JsonValue* JsonValue::find(std::string_view key) const {
    const JsonObject* const members = object();
    if (members == nullptr) return nullptr;
    const auto member = std::ranges::find(*members, key, &JsonMember::key);
    return member == members->end() ? nullptr : &member->value;
}

std::string_view JsonValue::kind() const {
    constexpr std::array<std::string_view, 6> names{"null",     "a boolean", "a number",
                                                    "a string", "an array",  "an object"};
    return names[content_.index()];
}

std::string shortened(const std::string& text) {
    constexpr std::size_t shown = 60;
    return text.size() <= shown ? text : text.substr(0, shown) + "...";
}

ParsedJson read_json(std::string_view text, std::string_view source, std::uint64_t max_values) {
    text = without_byte_order_mark(text);
    const std::size_t zero = text.find('\0'); // the parser would take it for the end of the text
    if (zero != std::string_view::npos) {
        ParsedJson refused{.value = {}, .error = diagnostic_at(text, zero, source, "a byte 0")};
        refused.error->code = unreadable;
        return refused;
    }
    std::size_t taken = 0;
    Builder builder(text, source, taken, max_values);
    nlohmann::json::sax_parse(CountingIterator(text.data(), &taken),
                              CountingIterator(text.data() + text.size(), &taken), &builder);
    return std::move(builder).take();
}

} // namespace internode
