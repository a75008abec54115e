// SPDX-License-Identifier: MIT
//
// JSON written value by value into a sink: the same bytes on every machine, in the order in which they are given.
//
// Objects and block arrays take a line per entry, two blanks an indent; line arrays stand on one line: [1, 2.5].
// Strings are inert wherever JSON may be pasted: `<`, `>`, `&`, controls, separators and bidirectional characters are
// written \uXXXX, bytes that are not UTF-8 become \ufffd.

#pragma once

#include "internode/io/file/sink.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

/// The text between quotes that stands for `text` in JSON, quotes included.
[[nodiscard]] std::string json_quoted(std::string_view text);

/// Appends the numbers as an array on one line: [1, 2.5]. \throw std::invalid_argument as JsonWriter::number
void append_array(std::string& text, std::span<const double> numbers);

class JsonWriter {
public:
    enum class Layout { Block, Line };

    /// The sink must outlive the writer.
    explicit JsonWriter(Sink& sink);

    /// Each value below must follow a key inside an object, and stand without one elsewhere: assert.
    JsonWriter& begin_object(Layout layout = Layout::Block);
    JsonWriter& end_object();
    JsonWriter& begin_array(Layout layout = Layout::Block);
    JsonWriter& end_array();
    JsonWriter& key(std::string_view name);
    JsonWriter& string(std::string_view text);
    /// Shortest round trip. \throw std::invalid_argument for NaN and infinities, which JSON has not
    JsonWriter& number(double value);
    JsonWriter& integer(std::size_t value);
    JsonWriter& boolean(bool value);
    JsonWriter& null();
    /// `count` values more of an array: `append_value(i, text)` appends the text of value i, on at most `threads`
    /// threads (0: as many as the machine has) and in any order. The bytes are those of one value after another.
    JsonWriter& values(std::size_t count, int threads,
                       const std::function<void(std::size_t i, std::string& text)>& append_value);
    /// The same for arrays of `columns` values each, which divides `count`: value i stands in the array i / columns.
    JsonWriter& rows(std::size_t count, std::size_t columns, int threads,
                     const std::function<void(std::size_t i, std::string& text)>& append_value);

    /// The last newline and the buffer to the sink; the value must be complete: assert. False if the sink has failed.
    bool finish();
    /// False once the sink has failed: the rest may be left out.
    [[nodiscard]] bool good() const { return good_; }

private:
    struct Open {
        Layout layout;
        bool is_object;
        bool is_empty = true;
    };

    JsonWriter& scalar(std::string_view text);
    JsonWriter& open(char bracket, bool is_object, Layout layout);
    JsonWriter& close(char bracket);
    void before_entry();
    void before_value();
    void new_line();
    void drain(std::size_t at_least);

    Sink& sink_;
    std::string buffer_;
    std::vector<Open> open_;
    bool after_key_ = false;
    bool good_ = true;
};

/// How short values stand in a long document: `json.begin_array(one_line)`.
inline constexpr JsonWriter::Layout one_line = JsonWriter::Layout::Line;

} // namespace internode
