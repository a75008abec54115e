// SPDX-License-Identifier: MIT

#include "internode/io/json/json_writer.h"

#include "internode/io/file/text_lines.h"
#include "internode/text/number.h"
#include "internode/text/utf8.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace internode {

namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 16;

void append_unit(std::string& text, char32_t unit) {
    assert(unit <= 0xFFFF);
    constexpr std::string_view digits = "0123456789abcdef";
    text += "\\u";
    for (int shift = 12; shift >= 0; shift -= 4) text += digits[(unit >> static_cast<unsigned>(shift)) & 0xFU];
}

/// What may not stand as itself: markup, controls, bidirectional and invisible format characters, separators, the
/// byte order mark. All below U+10000: one \uXXXX each.
bool is_escaped(char32_t value) {
    struct Range {
        char32_t first, last;
    };
    constexpr std::array<Range, 12> ranges{{{0x00, 0x1F},
                                            {U'&', U'&'},
                                            {U'<', U'<'},
                                            {U'>', U'>'},
                                            {0x7F, 0x9F},
                                            {0xAD, 0xAD},
                                            {0x061C, 0x061C},
                                            {0x200B, 0x200F},
                                            {0x2028, 0x202E},
                                            {0x2060, 0x206F},
                                            {0xFEFF, 0xFEFF},
                                            {0xFFF9, 0xFFFB}}};
    return std::ranges::any_of(ranges, [value](Range range) { return range.first <= value && value <= range.last; });
}

void append_escaped(std::string& text, CodePoint point, std::string_view bytes) {
    constexpr char32_t replacement = 0xFFFD;
    if (!point.valid) return append_unit(text, replacement);
    switch (point.value) {
    case U'"':
        text += "\\\"";
        return;
    case U'\\':
        text += "\\\\";
        return;
    case U'\n':
        text += "\\n";
        return;
    case U'\r':
        text += "\\r";
        return;
    case U'\t':
        text += "\\t";
        return;
    default:
        break;
    }
    if (is_escaped(point.value))
        append_unit(text, point.value);
    else
        text += bytes;
}

} // namespace

std::string json_quoted(std::string_view text) {
    std::string quoted = "\"";
    for (std::size_t place = 0; place < text.size();) {
        const CodePoint point = code_point_at(text, place);
        append_escaped(quoted, point, text.substr(place, point.bytes));
        place += point.bytes;
    }
    quoted += '"';
    return quoted;
}

void append_array(std::string& text, std::span<const double> numbers) {
    text += '[';
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0) text += ", ";
        append(text, numbers[i]);
    }
    text += ']';
}

JsonWriter::JsonWriter(Sink& sink)
    : sink_(sink) {}

JsonWriter& JsonWriter::begin_object(Layout layout) {
    return open('{', true, layout);
}

JsonWriter& JsonWriter::end_object() {
    assert(!open_.empty() && open_.back().is_object && !after_key_);
    return close('}');
}

JsonWriter& JsonWriter::begin_array(Layout layout) {
    return open('[', false, layout);
}

JsonWriter& JsonWriter::end_array() {
    assert(!open_.empty() && !open_.back().is_object);
    return close(']');
}

JsonWriter& JsonWriter::key(std::string_view name) {
    assert(!open_.empty() && open_.back().is_object && !after_key_);
    before_entry();
    buffer_ += json_quoted(name);
    buffer_ += ": ";
    after_key_ = true;
    return *this;
}

JsonWriter& JsonWriter::string(std::string_view text) {
    return scalar(json_quoted(text));
}

JsonWriter& JsonWriter::number(double value) {
    before_value();
    append(buffer_, value);
    drain(buffer_bytes);
    return *this;
}

JsonWriter& JsonWriter::integer(std::size_t value) {
    return scalar(std::to_string(value));
}

JsonWriter& JsonWriter::boolean(bool value) {
    return scalar(value ? "true" : "false");
}

JsonWriter& JsonWriter::null() {
    return scalar("null");
}

JsonWriter& JsonWriter::values(std::size_t count, int threads,
                               const std::function<void(std::size_t i, std::string& text)>& append_value) {
    assert(!open_.empty() && !open_.back().is_object);
    if (count == 0) return *this;
    before_entry();
    drain(0);
    before_entry();
    const std::string between = std::exchange(buffer_, {});
    good_ = write_lines(sink_, count, threads,
                        [&](std::size_t i, std::string& text) {
                            if (i > 0) text += between;
                            append_value(i, text);
                        }) &&
            good_;
    return *this;
}

JsonWriter& JsonWriter::rows(std::size_t count, std::size_t columns, int threads,
                             const std::function<void(std::size_t i, std::string& text)>& append_value) {
    assert(!open_.empty() && !open_.back().is_object && open_.back().layout == Layout::Block);
    assert(columns > 0 && count % columns == 0);
    if (count == 0) return *this;
    before_entry();
    drain(0);
    new_line();
    const std::string line = std::exchange(buffer_, {});
    good_ = write_lines(sink_, count, threads,
                        [&](std::size_t i, std::string& text) {
                            const bool begins = i % columns == 0;
                            if (i > 0) text += ',';
                            if (begins && i > 0) text += line;
                            if (begins) text += '[';
                            text += line + "  ";
                            append_value(i, text);
                            if ((i + 1) % columns == 0) text += line + ']';
                        }) &&
            good_;
    return *this;
}

bool JsonWriter::finish() {
    assert(open_.empty() && !after_key_);
    buffer_ += '\n';
    drain(0);
    return good_;
}

JsonWriter& JsonWriter::scalar(std::string_view text) {
    before_value();
    buffer_ += text;
    drain(buffer_bytes);
    return *this;
}

JsonWriter& JsonWriter::open(char bracket, bool is_object, Layout layout) {
    const bool inside_line = !open_.empty() && open_.back().layout == Layout::Line;
    before_value();
    buffer_ += bracket;
    open_.push_back({.layout = inside_line ? Layout::Line : layout, .is_object = is_object});
    return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
    const Open closed = open_.back();
    open_.pop_back();
    if (closed.layout == Layout::Block && !closed.is_empty) new_line();
    buffer_ += bracket;
    drain(buffer_bytes);
    return *this;
}

void JsonWriter::before_value() {
    assert(open_.empty() || open_.back().is_object == after_key_);
    if (!after_key_) before_entry();
    after_key_ = false;
}

void JsonWriter::before_entry() {
    if (open_.empty()) return;
    Open& parent = open_.back();
    if (!parent.is_empty) buffer_ += parent.layout == Layout::Line ? ", " : ",";
    parent.is_empty = false;
    if (parent.layout == Layout::Block) new_line();
}

void JsonWriter::new_line() {
    buffer_ += '\n';
    buffer_.append(2 * open_.size(), ' ');
}

void JsonWriter::drain(std::size_t at_least) {
    if (buffer_.size() < at_least) return;
    good_ = sink_.write(buffer_) && good_;
    buffer_.clear();
}

} // namespace internode
