// SPDX-License-Identifier: MIT

#include "internode/text/utf8.h"

#include <array>
#include <cassert>
#include <cstdint>

namespace internode {

namespace {

std::size_t sequence_length(unsigned char lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead < 0xE0) return 2;
    if (lead >= 0xE0 && lead < 0xF0) return 3;
    if (lead >= 0xF0 && lead < 0xF5) return 4;
    return 0;
}

/// The least value that needs a sequence of so many bytes: less is an overlong form.
constexpr std::array<char32_t, 5> least_value{0, 0, 0x80, 0x800, 0x10000};

bool is_scalar(char32_t value) {
    return value <= 0x10FFFF && !(value >= 0xD800 && value <= 0xDFFF);
}

} // namespace

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    return text;
}

CodePoint code_point_at(std::string_view text, std::size_t place) {
    assert(place < text.size());
    const auto byte_at = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte_at(place);
    const CodePoint damaged{lead, 1, false};
    const std::size_t length = sequence_length(lead);
    if (length == 0 || length > text.size() - place) return damaged;
    if (length == 1) return {lead, 1, true};
    char32_t value = lead & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const unsigned char next = byte_at(place + i);
        if ((next & 0xC0u) != 0x80u) return damaged;
        value = (value << 6) | (next & 0x3Fu);
    }
    if (value < least_value[length] || !is_scalar(value)) return damaged;
    return {value, length, true};
}

std::size_t count_code_points(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t place = 0; place < text.size(); place += code_point_at(text, place).bytes) ++count;
    return count;
}

void append_utf8(std::string& text, char32_t value) {
    assert(is_scalar(value));
    const auto append = [&text](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (value < 0x80) {
        append(value);
    } else if (value < 0x800) {
        append(0xC0 | (value >> 6));
        append(0x80 | (value & 0x3F));
    } else if (value < 0x10000) {
        append(0xE0 | (value >> 12));
        append(0x80 | ((value >> 6) & 0x3F));
        append(0x80 | (value & 0x3F));
    } else {
        append(0xF0 | (value >> 18));
        append(0x80 | ((value >> 12) & 0x3F));
        append(0x80 | ((value >> 6) & 0x3F));
        append(0x80 | (value & 0x3F));
    }
}

} // namespace internode
