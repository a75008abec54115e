// SPDX-License-Identifier: MIT

#include "internode/grammar/lexing/name.h"

#include "internode/text/ascii.h"
#include "internode/text/utf8.h"

#include <algorithm>

#include <fmt/format.h>

namespace internode {

namespace {

constexpr char32_t replacement = 0xFFFD;

bool is_plain_name(std::string_view text) {
    const auto is_inner = [](char c) { return is_ascii_letter(c) || is_ascii_digit(c) || c == '_' || c == '\''; };
    return !text.empty() && is_ascii_letter(text.front()) && std::ranges::all_of(text, is_inner);
}

bool may_stand_in_a_name(char32_t value) {
    const bool is_control = value < 0x20 || (value >= 0x7F && value < 0xA0);
    return !is_control && value <= 0x10FFFF && !(value >= 0xD800 && value <= 0xDFFF);
}

int hexadecimal_value(char c) {
    if (is_ascii_digit(c)) return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// The character of "{1f331}" at the start of the text, and the bytes it took; nothing if it is not that.
std::optional<std::pair<char32_t, std::size_t>> read_braced(std::string_view text) {
    const std::size_t close = text.find('}');
    if (!text.starts_with('{') || close == std::string_view::npos || close < 2 || close > 7) return std::nullopt;
    char32_t value = 0;
    for (const char c : text.substr(1, close - 1)) {
        if (hexadecimal_value(c) < 0) return std::nullopt;
        value = 16 * value + static_cast<char32_t>(hexadecimal_value(c));
    }
    if (!may_stand_in_a_name(value)) return std::nullopt;
    return std::pair{value, close + 1};
}

/// Reads the escape whose `\` stands before the text; returns the bytes it took, 0 if there is no such escape.
std::size_t read_escape(std::string_view text, std::string& name) {
    if (text.starts_with('"') || text.starts_with('\\')) {
        name += text.front();
        return 1;
    }
    if (!text.starts_with('u')) return 0;
    const auto braced = read_braced(text.substr(1));
    if (!braced) return 0;
    append_utf8(name, braced->first);
    return 1 + braced->second;
}

std::optional<std::string> read_quoted(std::string_view inner) {
    std::string name;
    for (std::size_t place = 0; place < inner.size();) {
        const CodePoint point = code_point_at(inner, place);
        if (!point.valid || !may_stand_in_a_name(point.value) || point.value == U'"') return std::nullopt;
        if (point.value == U'\\') {
            const std::size_t bytes = read_escape(inner.substr(place + 1), name);
            if (bytes == 0) return std::nullopt;
            place += 1 + bytes;
        } else {
            name += inner.substr(place, point.bytes);
            place += point.bytes;
        }
    }
    return name;
}

} // namespace

std::optional<std::string> read_grammar_name(std::string_view text) {
    if (is_plain_name(text)) return std::string(text);
    const bool in_quotes = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    if (!in_quotes) return std::nullopt;
    return read_quoted(text.substr(1, text.size() - 2));
}

std::string write_grammar_name(std::string_view name) {
    if (is_plain_name(name)) return std::string(name);
    std::string text = "\"";
    for (std::size_t place = 0; place < name.size();) {
        const CodePoint point = code_point_at(name, place);
        const bool sound = point.valid && may_stand_in_a_name(point.value);
        const char32_t value = sound ? point.value : replacement;
        if (value == U'"' || value == U'\\')
            text += {'\\', static_cast<char>(value)};
        else if (value < 0x80)
            text += static_cast<char>(value);
        else
            text += fmt::format("\\u{{{:x}}}", static_cast<unsigned>(value));
        place += point.bytes;
    }
    return text + '"';
}

} // namespace internode
